#include <glisson/cpu/solids/shared_nodes.hpp>

#include <algorithm>
#include <utility>

#include <glisson/cpu/simd/nodes.hpp>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SharedNodes::SharedNodes(std::span<const Patch> patches, int nodes, int slot_count) : node_count(nodes) {
  std::vector<int> parts(at(node_count));
  auto over_slots = [&](auto&& visit) {
    for (const Patch& patch : patches)
      for (int i = patch.interior_count, slot = patch.slot; i < patch.node_count; ++i, ++slot)
        visit(patch.node[i], slot);
  };
  over_slots([&](int n, int) { ++parts[at(n)]; });
  const auto count = std::count_if(parts.begin(), parts.end(), [](int p) { return p > 0; });
  node.reserve(static_cast<std::size_t>(count));
  begin.reserve(static_cast<std::size_t>(count) + 1);
  slots.resize(at(slot_count));
  int first = 0;
  for (int n = 0; n < node_count; ++n) {
    if (parts[at(n)] == 0) continue;
    node.push_back(n);
    begin.push_back(first);
    first += std::exchange(parts[at(n)], first);
  }
  begin.push_back(first);
  over_slots([&](int n, int slot) { slots[at(parts[at(n)]++)] = slot; });
}

Share SharedNodes::share(int thread, int thread_count) const {
  return listed_share(count(), thread, thread_count, node_count, [&](int i) { return node[at(i)]; });
}

void SharedNodes::sum_forces(const Pass& pass, const Share& share) const {
  constexpr int ahead =
      32;  // parts lie in several patches: without fetching them ahead each one waits for memory
  auto row = [](auto* rows, int i) { return rows + 4 * static_cast<std::ptrdiff_t>(i); };
  const int last_slot = static_cast<int>(slots.size()) - ahead;
  for (int i = share.first; i < share.last; ++i) {
    if (i + ahead / 2 < share.last) __builtin_prefetch(row(pass.f, node[at(i + ahead / 2)]), 1, 3);
    Row sum = load_row(row(pass.f, node[at(i)]));
    for (int k = begin[at(i)]; k < begin[at(i + 1)]; ++k) {
      if (k < last_slot) __builtin_prefetch(row(pass.slot_force, slots[at(k + ahead)]), 0, 3);
      sum += load_row(row(pass.slot_force, slots[at(k)]));
    }
    store_row(row(pass.f, node[at(i)]), sum);
  }
}

}  // namespace glisson::patches
