#include <glisson/contact/bvh/node_regions.hpp>

namespace glisson::contact {

NodeRegions node_regions(const Hierarchy& hierarchy, std::span<const int> of_triangle,
                         const std::function<bool(int region_a, int region_b)>& may_touch) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  NodeRegions regions{std::vector<int>(hierarchy.nodes.size(), -1)};
  for (const int n : hierarchy.by_level) {  // children first
    const Hierarchy::Node& node = hierarchy.nodes[at(n)];
    int its = node.triangle >= 0 ? of_triangle[at(node.triangle)] : regions.of_node[at(node.child[0])];
    for (const int c : node.child)
      if (c >= 0 && regions.of_node[at(c)] != its) its = -1;
    regions.of_node[at(n)] = its;
    if (node.triangle < 0 && node.connected && (its < 0 || may_touch(its, its))) regions.uses_cones = true;
  }
  return regions;
}

}  // namespace glisson::contact
