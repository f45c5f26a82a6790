// Face-connected pieces of a coarse grid, and what becomes of the small ones.
#include <algorithm>

#include <glisson/models/mesher/coarse_grid.hpp>

namespace glisson::detail {
namespace {

/// Numbers the face-connected pieces; returns the coarse voxels of each.
std::vector<std::int64_t> find_pieces(const CoarseGrid& grid, std::vector<int>& piece) {
  std::vector<std::int64_t> sizes;
  std::vector<std::array<int, 3>> front;
  piece.assign(grid.region.size(), -1);
  const auto visit = [&](int i, int j, int k, int number) {
    if (!grid.filled(i, j, k) || piece[grid.index(i, j, k)] >= 0) return;
    piece[grid.index(i, j, k)] = number;
    ++sizes[static_cast<std::size_t>(number)];
    front.push_back({i, j, k});
  };
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if (!grid.filled(i, j, k) || piece[grid.index(i, j, k)] >= 0) continue;
        const int number = static_cast<int>(sizes.size());
        sizes.push_back(0);
        visit(i, j, k, number);
        while (!front.empty()) {
          const auto [x, y, z] = front.back();
          front.pop_back();
          for (const int d : {-1, 1}) {
            visit(x + d, y, z, number);
            visit(x, y + d, z, number);
            visit(x, y, z + d, number);
          }
        }
      }
  return sizes;
}

}  // namespace

void drop_small_pieces(CoarseGrid& grid, const MesherOptions& options, std::vector<std::string>& warnings) {
  std::vector<int> piece;
  const std::vector<std::int64_t> sizes = find_pieces(grid, piece);
  if (sizes.empty()) return;
  const auto largest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const auto kept = [&](int p) {
    return options.largest_only ? p == largest : sizes[static_cast<std::size_t>(p)] >= options.min_component;
  };
  std::int64_t pieces = 0, voxels = 0;
  for (int p = 0; p < static_cast<int>(sizes.size()); ++p)
    if (!kept(p)) {
      ++pieces;
      voxels += sizes[static_cast<std::size_t>(p)];
    }
  for (std::size_t c = 0; c < piece.size(); ++c)
    if (piece[c] >= 0 && !kept(piece[c])) grid.region[c] = -1;
  if (pieces > 0)
    warnings.push_back("dropped " + std::to_string(pieces) + " separate piece(s) with " +
                       std::to_string(voxels) + " coarse voxel(s) in all (" +
                       (options.largest_only
                            ? "only the largest is kept"
                            : "fewer than " + std::to_string(options.min_component) + " each") +
                       ")");
  const std::int64_t left = static_cast<std::int64_t>(sizes.size()) - pieces;
  if (left > 1)
    warnings.push_back("the mesh has " + std::to_string(left) +
                       " separate pieces; each needs its own constraints, or keep only the largest");
}

}  // namespace glisson::detail
