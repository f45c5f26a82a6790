#include <glisson/contact/bvh/preorder_tree.hpp>

#include <glisson/contact/bvh/node_regions.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Number in preorder of each node.
std::vector<int> preorder(const Hierarchy& h) {
  std::vector<int> place(h.nodes.size(), -1), open;
  if (h.node_count() > 0) open.push_back(0);
  for (int next = 0; !open.empty(); ++next) {
    const int n = open.back();
    open.pop_back();
    place[at(n)] = next;
    const auto& child = h.nodes[at(n)].child;
    for (auto c = child.rbegin(); c != child.rend(); ++c)
      if (*c >= 0) open.push_back(*c);
  }
  return place;
}

void copy_nodes(const Hierarchy& h, const std::vector<int>& place, PreorderTree& tree) {
  for (auto* array : {&tree.skip, &tree.parent, &tree.triangle, &tree.connected})
    array->resize(h.nodes.size());
  for (const int n : h.by_level) {  // children first
    const Hierarchy::Node& node = h.nodes[at(n)];
    const std::size_t to = at(place[at(n)]);
    tree.parent[to] = node.parent >= 0 ? place[at(node.parent)] : -1;
    tree.triangle[to] = node.triangle;
    tree.connected[to] = node.connected ? 1 : 0;
    tree.skip[to] = place[at(n)] + 1;
    for (const int c : node.child)
      if (c >= 0) tree.skip[to] = tree.skip[at(place[at(c)])];
    tree.by_level.push_back(place[at(n)]);
    if (node.triangle >= 0) tree.leaf[at(node.triangle)] = place[at(n)];
  }
}

void set_regions(const Hierarchy& h, const std::vector<int>& place, const SearchRegions& regions,
                 PreorderTree& tree) {
  tree.region_count = regions.count;
  for (int i = 0; i < regions.count; ++i)
    for (int j = 0; j < regions.count; ++j) tree.may_touch.push_back(regions.may_touch(i, j) ? 1 : 0);
  const NodeRegions its = node_regions(h, regions.of_triangle, regions.may_touch);
  tree.region.resize(place.size());
  for (std::size_t n = 0; n < place.size(); ++n) tree.region[at(place[n])] = its.of_node[n];
  tree.uses_cones = its.uses_cones;
}

}  // namespace

PreorderTree preorder_tree(const Hierarchy& h, std::span<const Triangle> triangles,
                           const SearchRegions& regions) {
  PreorderTree tree;
  tree.leaf.resize(triangles.size());
  for (const Triangle& t : triangles) tree.corners.insert(tree.corners.end(), t.begin(), t.end());
  const std::vector<int> place = preorder(h);
  copy_nodes(h, place, tree);
  set_regions(h, place, regions, tree);
  tree.level_begin = h.level_begin;
  tree.rule = h.settings.cones;
  return tree;
}

}  // namespace glisson::contact
