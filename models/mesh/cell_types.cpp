#include <glisson/models/mesh/cell_types.hpp>

#include <algorithm>
#include <iterator>

namespace glisson::detail {
namespace {

struct CellRow {
  int code;
  CellUse use;
  int nodes;
  const char* name;
};

constexpr CellRow rows[] = {
    {0, CellUse::point_or_line, 0, "empty cell"},
    {1, CellUse::point_or_line, 1, "vertex"},
    {2, CellUse::point_or_line, 0, "set of vertices"},
    {3, CellUse::point_or_line, 2, "line"},
    {4, CellUse::point_or_line, 0, "polyline"},
    {5, CellUse::facet, 3, "triangle"},
    {6, CellUse::facet, 0, "triangle strip"},
    {7, CellUse::facet, 0, "polygon"},
    {8, CellUse::facet, 4, "pixel"},
    {9, CellUse::facet, 4, "quadrilateral"},
    {10, CellUse::solid, 4, "tetrahedron"},
    {11, CellUse::solid, 8, "voxel"},
    {12, CellUse::solid, 8, "hexahedron"},
    {13, CellUse::other_solid, 6, "wedge"},
    {14, CellUse::other_solid, 5, "pyramid"},
    {15, CellUse::other_solid, 10, "pentagonal prism"},
    {16, CellUse::other_solid, 12, "hexagonal prism"},
    {21, CellUse::point_or_line, 3, "3-node line"},
    {22, CellUse::curved_facet, 6, "6-node triangle"},
    {23, CellUse::curved_facet, 8, "8-node quadrilateral"},
    {24, CellUse::other_solid, 10, "10-node tetrahedron"},
    {25, CellUse::other_solid, 20, "20-node hexahedron"},
    {26, CellUse::other_solid, 15, "15-node wedge"},
    {27, CellUse::other_solid, 13, "13-node pyramid"},
    {28, CellUse::curved_facet, 9, "9-node quadrilateral"},
    {29, CellUse::other_solid, 27, "27-node hexahedron"},
    {30, CellUse::curved_facet, 6, "6-node quadrilateral"},
    {31, CellUse::other_solid, 12, "12-node wedge"},
    {32, CellUse::other_solid, 18, "18-node wedge"},
    {33, CellUse::other_solid, 24, "24-node hexahedron"},
    {34, CellUse::curved_facet, 7, "7-node triangle"},
    {35, CellUse::point_or_line, 4, "4-node line"},
    {36, CellUse::curved_facet, 0, "quadratic polygon"},
    {37, CellUse::other_solid, 19, "19-node pyramid"},
    {41, CellUse::other_solid, 0, "convex point set"},
    {42, CellUse::other_solid, 0, "polyhedron"},
    {68, CellUse::point_or_line, 0, "line of higher order"},
    {69, CellUse::curved_facet, 0, "triangle of higher order"},
    {70, CellUse::curved_facet, 0, "quadrilateral of higher order"},
    {71, CellUse::other_solid, 0, "tetrahedron of higher order"},
    {72, CellUse::other_solid, 0, "hexahedron of higher order"},
    {73, CellUse::other_solid, 0, "wedge of higher order"},
    {74, CellUse::other_solid, 0, "pyramid of higher order"},
    {75, CellUse::point_or_line, 0, "Bezier curve"},
    {76, CellUse::curved_facet, 0, "Bezier triangle"},
    {77, CellUse::curved_facet, 0, "Bezier quadrilateral"},
    {78, CellUse::other_solid, 0, "Bezier tetrahedron"},
    {79, CellUse::other_solid, 0, "Bezier hexahedron"},
    {80, CellUse::other_solid, 0, "Bezier wedge"},
    {81, CellUse::other_solid, 0, "Bezier pyramid"},
};

const CellRow* row_of(int code) {
  const auto row =
      std::find_if(std::begin(rows), std::end(rows), [code](const CellRow& r) { return r.code == code; });
  return row == std::end(rows) ? nullptr : row;
}

}  // namespace

CellUse use_of(int code) {
  const auto row = row_of(code);
  return row == nullptr ? CellUse::unknown : row->use;
}

std::string name_of_cell(int code) {
  const auto row = row_of(code);
  return row == nullptr ? "cell of type " + std::to_string(code) : row->name;
}

int nodes_of_cell(int code) {
  const auto row = row_of(code);
  return row == nullptr ? 0 : row->nodes;
}

GmshType gmsh_type(std::int64_t type) {
  constexpr GmshType types[] = {
      {0, 0},   {3, 2},   {5, 3},   {9, 4},   {10, 4},  {12, 8},  {13, 6},  {14, 5},
      {21, 3},  {22, 6},  {28, 9},  {24, 10}, {29, 27}, {32, 18}, {37, 14}, {1, 1},
      {23, 8},  {25, 20}, {26, 15}, {27, 13}, {69, 9},  {69, 10}, {69, 12}, {69, 15},
      {69, 15}, {69, 21}, {35, 4},  {68, 5},  {68, 6},  {71, 20}, {71, 35}, {71, 56},
  };
  if (type >= 1 && type < std::ssize(types)) return types[type];
  if (type == 92) return {72, 64};
  if (type == 93) return {72, 125};
  return {0, 0};
}

}  // namespace glisson::detail
