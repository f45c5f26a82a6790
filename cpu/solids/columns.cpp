#include <glisson/cpu/solids/columns.hpp>

#include <algorithm>
#include <cstdint>

namespace glisson::patches {
namespace {

using Hexahedra = std::span<const std::array<int, 8>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Corners of face 2 a (of negative axis a) and 2 a + 1, in an order whose right-hand normal points inwards.
/// The corners that edges link with those of face g are those of face g ^ 1 in reverse.
constexpr int face_corner[6][4] = {{0, 3, 7, 4}, {5, 6, 2, 1}, {0, 4, 5, 1},
                                   {2, 6, 7, 3}, {0, 1, 2, 3}, {7, 6, 5, 4}};

/// A hexahedron, the face through which a column enters it, and which corner of that face comes first.
struct Place {
  int element = -1, face = 0, turn = 0;
};

class Builder {
 public:
  explicit Builder(Hexahedra hexahedra)
      : hexahedra_(hexahedra), across_(hexahedra.size()), free_(hexahedra.size(), true) {
    find_neighbours();
  }

  std::vector<Column> build() {
    columns_.reserve(hexahedra_.size() / column_length + 8);
    for (int length = column_length; length > 0; --length)
      for (int axis = best_axis(length); axis >= 0; axis = best_axis(length)) cut(axis, length, true);
    return std::move(columns_);
  }

 private:
  int node(const Place& p, int k) const { return hexahedra_[at(p.element)][at(corner(p, k))]; }
  /// Corner k of the face where the column enters (0 .. 3) or leaves (4 .. 7).
  static int corner(const Place& p, int k) {
    const int on_face = (k % 4 + p.turn) % 4;
    return k < 4 ? face_corner[p.face][on_face] : face_corner[p.face ^ 1][3 - on_face];
  }

  void find_neighbours() {
    struct Face {
      std::uint64_t key;
      int side;  ///< 6 x hexahedron + face
    };
    std::vector<Face> faces;
    faces.reserve(6 * hexahedra_.size());
    for (int side = 0; side < static_cast<int>(6 * hexahedra_.size()); ++side) {
      std::array<std::uint64_t, 4> n;
      for (int k = 0; k < 4; ++k)
        n[at(k)] = static_cast<std::uint64_t>(hexahedra_[at(side / 6)][at(face_corner[side % 6][k])]);
      std::sort(n.begin(), n.end());
      faces.push_back({n[0] << 48 | n[1] << 32 | n[2] << 16 | n[3], side});
    }
    std::sort(faces.begin(), faces.end(),
              [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.side < b.side; });
    for (auto& sides : across_) sides.fill(-1);
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
      if (faces[i].key != faces[i + 1].key) continue;
      const int a = faces[i].side, b = faces[i + 1].side;
      across_[at(a / 6)][at(a % 6)] = b;
      across_[at(b / 6)][at(b % 6)] = a;
      ++i;
    }
  }

  /// Where the column goes on, or none: the next one must be free, and its face the same when seen from the
  /// same side (which a hexahedron that lies inside out, or twice in the list, is not).
  Place next(const Place& p) const {
    const int side = across_[at(p.element)][at(p.face ^ 1)];
    if (side < 0 || !free_[at(side / 6)]) return {};
    for (int turn = 0; turn < 4; ++turn) {
      const Place q{side / 6, side % 6, turn};
      bool same = true;
      for (int k = 0; k < 4; ++k) same = same && node(q, k) == node(p, k + 4);
      if (same) return q;
    }
    return {};
  }

  /// Cuts all that is free into pieces of `length` along an axis, where `take` says so; returns how many
  /// there are.
  int cut(int axis, int length, bool take) {
    std::vector<bool> seen(hexahedra_.size());
    int count = 0;
    for (int e = 0; e < static_cast<int>(hexahedra_.size()); ++e) {
      if (seen[at(e)] || !free_[at(e)]) continue;
      Place first{e, 2 * axis, 0};
      // backwards to the start of the row: the same as forwards from the opposite face
      std::size_t steps = 0;  // a ring has no start: any will do
      for (Place p = next({e, 2 * axis + 1, 0}); p.element >= 0 && p.element != e && !seen[at(p.element)];
           p = next(p)) {
        first = {p.element, p.face ^ 1, 0};
        if (++steps == hexahedra_.size()) break;
      }
      std::vector<Place> row;
      for (Place p = first; p.element >= 0 && !seen[at(p.element)]; p = next(p)) {
        seen[at(p.element)] = true;
        row.push_back(p);
      }
      const std::size_t pieces = row.size() / at(length);
      count += static_cast<int>(pieces);
      for (std::size_t i = 0; take && i < pieces; ++i)
        add(std::span(row).subspan(i * at(length), at(length)));
    }
    return count;
  }

  int best_axis(int length) {
    int best = -1, most = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (const int count = cut(axis, length, false); count > most) most = count, best = axis;
    return best;
  }

  void add(std::span<const Place> row) {
    Column column;
    for (std::size_t k = 0; k < column.node.size(); ++k) {
      const std::size_t j = std::min(k / 4, row.size());
      column.node[k] =
          j == 0 ? node(row[0], static_cast<int>(k % 4)) : node(row[j - 1], static_cast<int>(k % 4) + 4);
    }
    for (std::size_t j = 0; j < row.size(); ++j) {
      column.element[j] = row[j].element;
      free_[at(row[j].element)] = false;
    }
    columns_.push_back(column);
  }

  Hexahedra hexahedra_;
  std::vector<std::array<int, 6>> across_;  ///< 6 x hexahedron + face on the other side of a face; -1: none
  std::vector<bool> free_;
  std::vector<Column> columns_;
};

}  // namespace

std::vector<Column> build_columns(std::span<const std::array<int, 8>> hexahedra) {
  return Builder(hexahedra).build();
}

}  // namespace glisson::patches
