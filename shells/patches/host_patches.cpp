#include <glisson/shells/patches/host_patches.hpp>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <class R, template <class> class Constants>
void append(const std::vector<Constants<double>>& all, const std::vector<int>& order,
            std::vector<std::byte>& bytes) {
  if (all.empty()) return;
  bytes.resize(order.size() * sizeof(Constants<R>));
  std::byte* to = bytes.data();
  for (const int k : order) {
    const auto own = narrowed<R, Constants>(all[at(k)]);
    std::memcpy(to, &own, sizeof own);
    to += sizeof own;
  }
}

}  // namespace

std::vector<int> locality_order(const ShellSection& section, const Numbering& numbering) {
  std::vector<int> rank(numbering.triangle_order.size());
  for (std::size_t i = 0; i < rank.size(); ++i) rank[at(numbering.triangle_order[i])] = static_cast<int>(i);
  std::vector<int> order(section.elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return rank[at(section.elements[at(a)])] < rank[at(section.elements[at(b)])];
  });
  return order;
}

template <class R>
HostBlock<R> patch_block(const HostShells& host, const std::vector<int>& order, const Numbering& numbering) {
  HostBlock<R> block;
  block.element_count = static_cast<int>(order.size());
  block.nodes_per_element = host.slots();
  for (const int k : order)
    for (int a = 0; a < host.slots(); ++a)
      block.nodes.push_back(numbering.internal_of_user[at(host.nodes[at(k * host.slots() + a)])]);
  append<R, Membrane::Constants>(host.membranes, order, block.constants);
  append<R, RotationFree::Constants>(host.shells, order, block.constants);
  return block;
}

template HostBlock<float> patch_block(const HostShells&, const std::vector<int>&, const Numbering&);
template HostBlock<double> patch_block(const HostShells&, const std::vector<int>&, const Numbering&);

}  // namespace glisson::shells
