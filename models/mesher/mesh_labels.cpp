// Elements and nodes from the coarse grid. Tetrahedra: Kuhn's subdivision (Kuhn 1960), the same in every
// cube, so that the diagonals of neighbours meet.
#include <algorithm>
#include <cmath>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesher/coarse_grid.hpp>
#include <glisson/models/mesher/mesh_labels.hpp>
#include <unordered_map>

namespace glisson {
namespace {

using detail::CoarseGrid;
using detail::Selection;

/// Corner c of a cube sits at ((c >> 0) & 1, (c >> 1) & 1, (c >> 2) & 1).
constexpr int hexahedron_corners[8] = {0, 1, 3, 2, 4, 5, 7, 6};

/// One tetrahedron per order of the axes: along the first, second, third axis from corner 0 to corner 7; odd
/// orders are turned round so that all volumes are positive.
constexpr int tetrahedron_corners[6][4] = {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7},
                                           {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}};

/// Groups the filled cubes around a grid node by shared faces. Cubes of different groups touch there only
/// along an edge or at the node. Returns for each of the 8 cubes its group's first cube, or -1 for an empty
/// one.
std::array<int, 8> groups_around(unsigned filled) {
  std::array<int, 8> group{};
  for (int c = 0; c < 8; ++c) group[static_cast<std::size_t>(c)] = filled >> c & 1 ? c : -1;
  for (int pass = 0; pass < 7; ++pass)  // the longest way through faces has 7 steps
    for (std::size_t c = 0; c < 8; ++c)
      for (const std::size_t axis : {1u, 2u, 4u})
        if (group[c] >= 0 && group[c ^ axis] >= 0) group[c] = std::min(group[c], group[c ^ axis]);
  return group;
}

class Builder {
 public:
  Builder(const LabelImage& image, const CoarseGrid& grid, const std::vector<int>& labels,
          const MesherOptions& options)
      : image_(image), grid_(grid), labels_(labels), options_(options) {
    Mat3<double> A{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) A.m[a][b] = image.to_world[a][b];
    mirrored_ = determinant(A) < 0;
    for (unsigned filled = 0; filled < 256; ++filled) groups_[filled] = groups_around(filled);
  }

  Mesh build() {
    for (int k = 0; k < grid_.size[2]; ++k)
      for (int j = 0; j < grid_.size[1]; ++j)
        for (int i = 0; i < grid_.size[0]; ++i)
          if (grid_.filled(i, j, k)) add_cube(i, j, k);
    return std::move(mesh_);
  }

  std::int64_t split_nodes() const { return split_nodes_; }

 private:
  void add_cube(int i, int j, int k) {
    std::array<int, 8> corner{};
    for (int c = 0; c < 8; ++c) {
      // A mirrored image is put right by counting the corners of the first axis backwards.
      const int at = mirrored_ ? c ^ 1 : c;
      corner[static_cast<std::size_t>(c)] = node(i + (at & 1), j + (at >> 1 & 1), k + (at >> 2 & 1), at);
    }
    const int label = labels_[static_cast<std::size_t>(grid_.region[grid_.index(i, j, k)])];
    if (options_.element == Shape::hexahedron) return add(hexahedron_corners, corner, label);
    for (const auto& corners : tetrahedron_corners) add(corners, corner, label);
  }

  template <std::size_t N>
  void add(const int (&corners)[N], const std::array<int, 8>& corner, int label) {
    std::array<int, N> nodes;
    for (std::size_t a = 0; a < N; ++a) nodes[a] = corner[static_cast<std::size_t>(corners[a])];
    mesh_.add_element(N == 4 ? Shape::tetrahedron : Shape::hexahedron, nodes);
    mesh_.label.push_back(label);
  }

  /// The node at a grid point as the cube sees it whose corner `c` lies there.
  int node(int i, int j, int k, int c) {
    unsigned filled = 0;
    for (int around = 0; around < 8; ++around)  // cube `around` has the point as its corner 7 - around
      if (grid_.filled(i - 1 + (around & 1), j - 1 + (around >> 1 & 1), k - 1 + (around >> 2 & 1)))
        filled |= 1u << around;
    const auto& group = groups_[filled];
    const int mine = group[static_cast<std::size_t>(7 - c)];
    const std::uint64_t n0 = static_cast<std::uint64_t>(grid_.size[0]) + 1,
                        n1 = static_cast<std::uint64_t>(grid_.size[1]) + 1;
    const std::uint64_t point = static_cast<std::uint64_t>(i) +
                                n0 * (static_cast<std::uint64_t>(j) + n1 * static_cast<std::uint64_t>(k));
    const auto [found, fresh] =
        numbers_.try_emplace(8 * point + static_cast<std::uint64_t>(mine), mesh_.node_count());
    if (fresh) {
      if (mine != *std::find_if(group.begin(), group.end(), [](int g) { return g >= 0; })) ++split_nodes_;
      mesh_.X.push_back(options_.scale * position(i, j, k));
    }
    return found->second;
  }

  Vec3<double> position(int i, int j, int k) const {
    const auto at = [&](std::size_t a, int n) { return (grid_.first[a] + n) * grid_.ratio[a] - 0.5; };
    return image_.world(at(0, i), at(1, j), at(2, k));
  }

  const LabelImage& image_;
  const CoarseGrid& grid_;
  const std::vector<int>& labels_;
  const MesherOptions& options_;
  bool mirrored_ = false;
  std::array<std::array<int, 8>, 256> groups_{};
  std::unordered_map<std::uint64_t, int> numbers_;
  std::int64_t split_nodes_ = 0;
  Mesh mesh_;
};

double voxel_volume(const LabelImage& image) {
  Mat3<double> A{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) A.m[a][b] = image.to_world[a][b];
  return std::abs(determinant(A));
}

std::vector<MeshedRegion> regions_of(const LabelImage& image, const Selection& selection,
                                     const CoarseGrid& grid, const MesherOptions& options) {
  const double voxel = voxel_volume(image), coarse = voxel * grid.ratio[0] * grid.ratio[1] * grid.ratio[2];
  std::vector<std::int64_t> filled(selection.labels.size());
  for (const int region : grid.region)
    if (region >= 0) ++filled[static_cast<std::size_t>(region)];
  std::vector<MeshedRegion> regions;
  for (std::size_t r = 0; r < selection.labels.size(); ++r) {
    const double image_mm3 = static_cast<double>(selection.voxels[r]) * voxel;
    if (options.one_region && r > 0) {
      regions[0].image_mm3 += image_mm3;
      continue;
    }
    regions.push_back({selection.labels[r], image_mm3, static_cast<double>(filled[r]) * coarse,
                       filled[r] * (options.element == Shape::tetrahedron ? 6 : 1)});
  }
  return regions;
}

void add_warnings(LabelMesh& result, const LabelImage& image, std::int64_t split_nodes) {
  for (const MeshedRegion& region : result.regions)
    if (region.element_count == 0)
      result.warnings.push_back(
          "label " + std::to_string(region.label) + " (" + std::to_string(std::llround(region.image_mm3)) +
          " mm^3) fills no coarse voxel and is not in the mesh; use smaller voxels to keep it");
  if (split_nodes > 0)
    result.warnings.push_back("cut " + std::to_string(split_nodes) +
                              " connection(s) that were only an edge or a node wide");
  const auto spacing = detail::spacing_of(image);
  if (voxel_volume(image) < 0.99 * spacing[0] * spacing[1] * spacing[2])
    result.warnings.push_back("the image's axes are not at right angles, so the elements are sheared");
}

}  // namespace

LabelMesh mesh_labels(const LabelImage& image, const MesherOptions& options) {
  const Selection selection = detail::select(image, options.labels);
  CoarseGrid grid = detail::coarsen(image, selection, options);
  LabelMesh result;
  detail::drop_small_pieces(grid, options, result.warnings);
  result.regions = regions_of(image, selection, grid, options);
  if (std::all_of(grid.region.begin(), grid.region.end(), [](int region) { return region < 0; }))
    throw Error(ErrorKind::input,
                "no coarse voxel of " + std::to_string(options.voxel_mm) +
                    " mm is at least half filled by the chosen labels in a piece of " +
                    std::to_string(options.min_component) +
                    " voxels or more, so there is nothing to mesh. Use a smaller voxel size. The labels "
                    "of the image are: " +
                    label_summary(image) + ".");
  Builder builder(image, grid, selection.labels, options);
  result.mesh = builder.build();
  add_warnings(result, image, builder.split_nodes());
  return result;
}

}  // namespace glisson
