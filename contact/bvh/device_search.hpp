// Broad phase on a device: the pairs that PairSearch finds on the host. Include it only where a backend is
// instantiated.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <glisson/contact/bvh/device_tree.hpp>
#include <glisson/contact/bvh/pairs.hpp>
#include <glisson/contact/bvh/preorder_tree.hpp>
#include <glisson/contact/deformable/resizable.hpp>

namespace glisson::contact {

template <Backend B>
class DeviceSearch {
 public:
  /// The backend must outlive it.
  DeviceSearch(B& backend, const Hierarchy& hierarchy, std::span<const Triangle> triangles,
               const SearchRegions& regions)
      : DeviceSearch(backend, preorder_tree(hierarchy, triangles, regions)) {}

  /// Refits to x [point_count] and finds the pairs of triangles whose boxes overlap, as PairSearch::find.
  /// margin: added to all sides of a leaf's box [m]; threshold: as for overlapping_pairs.
  void find(const std::vector<Vec3<double>>& x, double margin, double threshold, Pairs& found) {
    found.clear();
    if (view_.node_count == 0) return;
    points_.put(x);
    for (std::size_t level = 0; level + 1 < level_begin_.size(); ++level)
      backend_.for_each(level_begin_[level + 1] - level_begin_[level],
                        RefitLevel{view_, by_level_.get() + level_begin_[level], points_.get(), margin, rule_,
                                   uses_cones_});
    backend_.for_each(view_.triangle_count, FindClosed{view_, threshold, uses_cones_});
    backend_.for_each(view_.triangle_count, FindPairs{view_, counts_.get(), nullptr, nullptr});
    list(found);
  }

 private:
  DeviceSearch(B& backend, const PreorderTree& tree)
      : backend_(backend),
        skip_(detail::upload(backend, tree.skip)),
        parent_(detail::upload(backend, tree.parent)),
        triangle_(detail::upload(backend, tree.triangle)),
        connected_(detail::upload(backend, tree.connected)),
        region_(detail::upload(backend, tree.region)),
        leaf_(detail::upload(backend, tree.leaf)),
        corners_(detail::upload(backend, tree.corners)),
        by_level_(detail::upload(backend, tree.by_level)),
        may_touch_(detail::upload(backend, tree.may_touch)),
        box_(detail::reserve<Box>(backend, tree.skip.size())),
        cone_(detail::reserve<NormalCone>(backend, tree.skip.size())),
        behind_(detail::reserve<int>(backend, tree.leaf.size())),
        counts_(detail::reserve<int>(backend, tree.leaf.size())),
        points_(backend),
        begin_(backend),
        others_(backend),
        level_begin_(tree.level_begin),
        rule_(tree.rule),
        uses_cones_(tree.uses_cones),
        view_{skip_.get(),
              parent_.get(),
              triangle_.get(),
              connected_.get(),
              region_.get(),
              leaf_.get(),
              corners_.get(),
              may_touch_.get(),
              box_.get(),
              cone_.get(),
              behind_.get(),
              static_cast<int>(tree.skip.size()),
              static_cast<int>(tree.leaf.size()),
              tree.region_count} {}

  /// Numbers the places on the host, which has to know how many there are in any case.
  void list(Pairs& found) {
    const auto triangles = static_cast<std::size_t>(view_.triangle_count);
    host_begin_.assign(triangles + 1, 0);
    backend_.copy_out(counts_.get(), host_begin_.data() + 1, triangles);
    for (std::size_t t = 0; t < triangles; ++t) host_begin_[t + 1] += host_begin_[t];
    const auto total = static_cast<std::size_t>(host_begin_.back());
    if (total == 0) return;
    begin_.put(host_begin_);
    others_.resize(total);
    backend_.for_each(view_.triangle_count, FindPairs{view_, nullptr, begin_.get(), others_.get()});
    host_others_.resize(total);
    backend_.copy_out(others_.get(), host_others_.data(), total);
    found.reserve(total);
    for (std::size_t t = 0; t < triangles; ++t)
      for (int k = host_begin_[t]; k < host_begin_[t + 1]; ++k)
        found.push_back(std::minmax(static_cast<int>(t), host_others_[static_cast<std::size_t>(k)]));
  }

  B& backend_;
  Buffer<int> skip_, parent_, triangle_, connected_, region_, leaf_, corners_, by_level_;
  Buffer<unsigned char> may_touch_;
  Buffer<Box> box_;
  Buffer<NormalCone> cone_;
  Buffer<int> behind_, counts_;
  Resizable<B, Vec3<double>> points_;
  Resizable<B, int> begin_, others_;
  std::vector<int> level_begin_, host_begin_, host_others_;
  ConeRule rule_;
  bool uses_cones_;
  TreeView view_;
};

}  // namespace glisson::contact
