#include <glisson/cpu/solids/patch_lists.hpp>

#include <algorithm>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rows of a node are summed two at a time; an odd one is paired with a row of zeros.
int even(int rows) { return rows + rows % 2; }

}  // namespace

std::vector<PronyCoefficients<float>> prony_terms(std::span<const PronyTerm> terms, double dt) {
  std::vector<PronyCoefficients<float>> result;
  result.reserve(terms.size());
  for (const PronyTerm& term : terms) {
    const auto exact = prony_coefficients(term.alpha, term.tau, dt);
    result.push_back({static_cast<float>(exact.alpha), static_cast<float>(exact.rate)});
  }
  return result;
}

PatchLists::PatchLists(int node_count, int width)
    : width_(width), valence_(at(node_count)), local_(at(node_count), -1) {}

void PatchLists::sort_nodes(const Layout& layout, std::span<const Item> items, PatchOutline& outline) {
  std::vector<PatchOutline::Node>& nodes = outline.nodes;
  for (const Item& item : items) {
    const int per_element = layout.corners_of_element(item.corners);
    for (int k = 0; k < item.corners; ++k) {
      int& local = local_[at(item.node[at(k)])];
      if (local < 0) {
        local = static_cast<int>(nodes.size());
        nodes.push_back({item.node[at(k)], 0, 0});
      }
      PatchOutline::Node& node = nodes[at(local)];
      ++node.rows;
      for (int j = 0, first = 0; j < layout.elements(item.corners); ++j, first += layout.new_corners)
        node.elements += k >= first && k < first + per_element;
    }
  }
  auto shared = [&](const PatchOutline::Node& n) { return n.elements < valence_[at(n.node)]; };
  std::sort(nodes.begin(), nodes.end(), [&](const PatchOutline::Node& a, const PatchOutline::Node& b) {
    if (shared(a) != shared(b)) return shared(b);
    return even(a.rows) != even(b.rows) ? even(a.rows) < even(b.rows) : a.node < b.node;
  });
  outline.patch.interior_count = static_cast<int>(
      std::count_if(nodes.begin(), nodes.end(), [&](const PatchOutline::Node& n) { return !shared(n); }));
  for (std::size_t i = 0; i < nodes.size(); ++i) local_[at(nodes[i].node)] = static_cast<int>(i);
}

PatchOutline PatchLists::outline(const Layout& layout, std::span<const Item> items) {
  PatchOutline outline;
  Patch& patch = outline.patch;
  sort_nodes(layout, items, outline);
  patch.tiles = (static_cast<int>(items.size()) + width_ - 1) / width_;
  patch.node_count = static_cast<int>(outline.nodes.size());
  patch.slot = slot_count_;
  slot_count_ += patch.node_count - patch.interior_count;
  for (int i = 0; i < patch.node_count; ++i) {
    const auto count = static_cast<std::uint16_t>(even(outline.nodes[at(i)].rows));
    if (i == patch.interior_count) patch.interior_runs = static_cast<int>(outline.runs.size());
    if (i == 0 || i == patch.interior_count || outline.runs.back().rows != count)
      outline.runs.push_back({0, count});
    ++outline.runs.back().nodes;
    outline.rows += count;
  }
  patch.runs = static_cast<int>(outline.runs.size());
  if (patch.interior_count == patch.node_count) patch.interior_runs = patch.runs;
  largest_node_count_ = std::max(largest_node_count_, patch.node_count);
  largest_row_count_ = std::max(largest_row_count_, patch.tiles * layout.corners * width_);
  return outline;
}

void PatchLists::write(const PatchOutline& outline, const Layout& layout, std::span<const Item> items,
                       const PatchListArrays& to) {
  std::transform(outline.nodes.begin(), outline.nodes.end(), to.node, [](const auto& n) { return n.node; });
  std::copy(outline.runs.begin(), outline.runs.end(), to.run);
  write_corners_and_rows(outline, layout, items, to.corner, to.row);
  for (const auto& n : outline.nodes) local_[at(n.node)] = -1;
}

void PatchLists::write_corners_and_rows(const PatchOutline& outline, const Layout& layout,
                                        std::span<const Item> items, std::uint16_t* corner,
                                        std::uint16_t* row) const {
  std::vector<std::uint16_t*> next;
  next.reserve(outline.nodes.size());
  for (const auto& node : outline.nodes) {
    next.push_back(row);
    row += even(node.rows);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int tile = static_cast<int>(i) / width_, lane = static_cast<int>(i) % width_;
    for (int k = 0; k < layout.corners; ++k) {
      const int local = local_[at(items[i].node[at(k)])];
      corner[(tile * layout.corners + k) * width_ + lane] = static_cast<std::uint16_t>(4 * local);
      const int its_row = (tile * layout.corners + k) * width_ + row_of_lane(lane, width_);
      if (k < items[i].corners) *next[at(local)]++ = static_cast<std::uint16_t>(16 + 4 * its_row);
    }
  }
}

}  // namespace glisson::patches
