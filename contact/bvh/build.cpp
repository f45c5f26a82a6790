// Building: connected patches, division of each from the top, union of their boxes from the bottom.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <glisson/contact/bvh/split.hpp>
#include <glisson/core/base/error.hpp>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;
using Patch = std::vector<int>;
std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A binary tree; arity 4 skips every second level of it.
struct Binary {
  int left = -1, right = -1, triangle = -1;
  bool connected = true;
};

detail::PatchData patch_data(std::span<const Triangle> triangles, Nodes x,
                             const HierarchySettings& settings) {
  detail::PatchData data{{}, {}, {}, neighbours_of(triangles), settings};
  Box all;
  for (const Triangle& t : triangles) {
    Box box;
    for (const int n : t) box = united(box, x[at(n)]);
    all = united(all, box);
    data.box.push_back(box);
    data.centre.push_back((1.0 / 3) * (x[at(t[0])] + x[at(t[1])] + x[at(t[2])]));
    data.cone.push_back(cone_of(cross(x[at(t[1])] - x[at(t[0])], x[at(t[2])] - x[at(t[0])])));
  }
  const Vec3<double> d = all.high - all.low;
  const double least = triangles.empty() ? 0 : 1e-3 * std::sqrt(dot(d, d));
  for (Box& box : data.box) box = inflated(box, std::max(settings.margin, least));
  return data;
}

std::vector<Patch> connected_patches(const std::vector<std::array<int, 3>>& neighbours) {
  std::vector<Patch> patches;
  std::vector<bool> seen(neighbours.size());
  for (int start = 0; start < static_cast<int>(neighbours.size()); ++start) {
    if (seen[at(start)]) continue;
    Patch patch{start};
    seen[at(start)] = true;
    for (std::size_t i = 0; i < patch.size(); ++i)
      for (const int n : neighbours[at(patch[i])])
        if (n >= 0 && !seen[at(n)]) {
          seen[at(n)] = true;
          patch.push_back(n);
        }
    patches.push_back(std::move(patch));
  }
  return patches;
}

class Builder {
 public:
  explicit Builder(detail::PatchData data) : data_(std::move(data)), mark_(data_.box.size(), -1) {}

  /// Index of the root; -1 without triangles. Patches are split with a stack: a chain of triangles may be
  /// deep.
  int build() {
    std::vector<Root> roots;
    for (Patch& patch : connected_patches(data_.neighbours)) {
      Box box;
      for (const int t : patch) box = united(box, data_.box[at(t)]);
      roots.push_back({divide(std::move(patch)), box});
    }
    return roots.empty() ? -1 : unite(roots);
  }
  const std::vector<Binary>& tree() const { return tree_; }

 private:
  struct Root {
    int node;
    Box box;
  };
  static constexpr std::size_t most_roots = 64;  ///< for the search of the best pair, which is cubic

  int divide(Patch patch) {
    const int root = add({});
    std::vector<std::pair<int, Patch>> open;
    open.emplace_back(root, std::move(patch));
    while (!open.empty()) {
      auto [node, its] = std::move(open.back());
      open.pop_back();
      if (its.size() == 1) {
        tree_[at(node)].triangle = its[0];
        continue;
      }
      auto [a, b] = detail::split_patch(data_, its, mark_);
      const int left = add({}), right = add({});
      tree_[at(node)].left = left;
      tree_[at(node)].right = right;
      open.emplace_back(right, std::move(b));
      open.emplace_back(left, std::move(a));
    }
    return root;
  }

  /// Unites the two boxes whose union is smallest until one is left (Johnsen 2016, figure 5.3); more than 64
  /// patches are first divided at the median of their widest direction.
  int unite(std::vector<Root> roots) {
    if (roots.size() > most_roots) {
      const auto middle = sort_at_median(roots);
      const int left = unite({roots.begin(), middle}), right = unite({middle, roots.end()});
      return add({left, right, -1, false});
    }
    while (roots.size() > 1) {
      std::size_t best_i = 0, best_j = 1;
      double least = volume(united(roots[0].box, roots[1].box));
      for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t j = i + 1; j < roots.size(); ++j)
          if (const double v = volume(united(roots[i].box, roots[j].box)); v < least) {
            least = v;
            best_i = i;
            best_j = j;
          }
      roots[best_i] = {add({roots[best_i].node, roots[best_j].node, -1, false}),
                       united(roots[best_i].box, roots[best_j].box)};
      roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(best_j));
    }
    return roots[0].node;
  }
  static std::vector<Root>::iterator sort_at_median(std::vector<Root>& roots) {
    Box all;
    for (const Root& r : roots) all = united(all, 0.5 * (r.box.low + r.box.high));
    const Vec3<double> d = all.high - all.low;
    const auto key = [&](const Root& r) {
      const Vec3<double> c = r.box.low + r.box.high;
      return d.x >= d.y && d.x >= d.z ? c.x : d.y >= d.z ? c.y : c.z;
    };
    std::stable_sort(roots.begin(), roots.end(),
                     [&](const Root& a, const Root& b) { return key(a) < key(b); });
    return roots.begin() + static_cast<std::ptrdiff_t>(roots.size() / 2);
  }
  int add(const Binary& node) {
    tree_.push_back(node);
    return static_cast<int>(tree_.size()) - 1;
  }

  detail::PatchData data_;
  std::vector<int> mark_;
  std::vector<Binary> tree_;
};

/// Children of a binary node in the wanted arity, left to right.
std::vector<int> children_of(const std::vector<Binary>& tree, int node, int arity) {
  std::vector<int> result;
  for (const int c : {tree[at(node)].left, tree[at(node)].right}) {
    if (arity == 4 && tree[at(c)].triangle < 0) {
      result.push_back(tree[at(c)].left);
      result.push_back(tree[at(c)].right);
    } else {
      result.push_back(c);
    }
  }
  return result;
}

void copy_tree(const std::vector<Binary>& tree, int root, Hierarchy& h) {
  std::vector<int> source{root};
  h.nodes.emplace_back();
  for (int n = 0; n < h.node_count(); ++n) {  // grows while it runs
    const Binary& from = tree[at(source[at(n)])];
    h.nodes[at(n)].triangle = from.triangle;
    h.nodes[at(n)].connected = from.connected;
    if (from.triangle >= 0) continue;
    std::size_t k = 0;
    for (const int c : children_of(tree, source[at(n)], h.settings.arity)) {
      h.nodes[at(n)].child[k++] = h.node_count();
      h.nodes.emplace_back().parent = n;
      source.push_back(c);
    }
  }
}

/// A node's level is one above the highest of its children; parents come before children in `nodes`.
void find_levels(Hierarchy& h) {
  std::vector<int> level(h.nodes.size(), 0);
  for (int n = h.node_count() - 1; n > 0; --n) {
    int& parent = level[at(h.nodes[at(n)].parent)];
    parent = std::max(parent, level[at(n)] + 1);
  }
  h.by_level.resize(h.nodes.size());
  std::iota(h.by_level.begin(), h.by_level.end(), 0);
  std::stable_sort(h.by_level.begin(), h.by_level.end(),
                   [&](int a, int b) { return level[at(a)] < level[at(b)]; });
  for (std::size_t i = 0; i < h.by_level.size(); ++i)
    if (i == 0 || level[at(h.by_level[i])] != level[at(h.by_level[i - 1])])
      h.level_begin.push_back(static_cast<int>(i));
  h.level_begin.push_back(h.node_count());
}

}  // namespace

Hierarchy build_hierarchy(std::span<const Triangle> triangles, Nodes x, const HierarchySettings& settings) {
  if (settings.arity != 2 && settings.arity != 4)
    throw Error(ErrorKind::usage, "A bounding volume hierarchy has 2 or 4 children a node, not " +
                                      std::to_string(settings.arity) + ".");
  Builder builder(patch_data(triangles, x, settings));
  Hierarchy hierarchy;
  hierarchy.settings = settings;
  if (const int root = builder.build(); root >= 0) copy_tree(builder.tree(), root, hierarchy);
  find_levels(hierarchy);
  hierarchy.box.resize(hierarchy.nodes.size());
  hierarchy.cone.resize(hierarchy.nodes.size());
  refit(hierarchy, triangles, x);
  return hierarchy;
}

}  // namespace glisson::contact
