// The mesh as the user gave it: nodes, solid elements of one or several shapes, labels and named arrays.
// Host data in double; constant once a Model is built.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

enum class Shape : std::uint8_t { tetrahedron, hexahedron };

constexpr int node_count_of(Shape shape) { return shape == Shape::tetrahedron ? 4 : 8; }

/// A named array that came with a mesh file, kept for material parameters and for the output.
struct NamedArray {
  int components = 1;
  std::vector<double> values;  ///< [-]  [count][components]
};

/// Tetrahedra: nodes a b c d with (b-a) x (c-a) . (d-a) > 0. Hexahedra: 0-1-2-3 counter-clockwise seen from
/// above (from 4-5-6-7), then 4-5-6-7 above them.
struct Mesh {
  std::vector<Vec3<double>> X;                ///< rest position [m]                      [node_count]
  std::vector<Shape> shape;                   ///< shape of each element [-]              [element_count]
  std::vector<int> begin{0};                  ///< first entry in nodes of element e [-]  [element_count + 1]
  std::vector<int> nodes;                     ///< connectivity, 0-based [-]              [begin.back()]
  std::vector<std::array<int, 3>> triangles;  ///< of membranes and shells, 0-based [-]  [triangle_count]
  std::vector<int> label;  ///< region of each element [-]             [element_count] or empty: all 0
  std::map<std::string, NamedArray> cell_arrays;   ///< per element
  std::map<std::string, NamedArray> point_arrays;  ///< per node

  int node_count() const { return static_cast<int>(X.size()); }
  int element_count() const { return static_cast<int>(shape.size()); }
  std::span<const int> element(int e) const {
    return {nodes.data() + begin[static_cast<std::size_t>(e)],
            static_cast<std::size_t>(node_count_of(shape[static_cast<std::size_t>(e)]))};
  }
  void add_element(Shape s, std::span<const int> its_nodes) {
    shape.push_back(s);
    nodes.insert(nodes.end(), its_nodes.begin(), its_nodes.end());
    begin.push_back(static_cast<int>(nodes.size()));
  }
};

/// A facet of the outer surface or of a file: 3 or 4 nodes, outward by the right-hand rule; a triangle has
/// nodes[3] = -1.
struct Facet {
  std::array<int, 4> nodes{-1, -1, -1, -1};
  int element = -1;  ///< the solid element it belongs to; -1: none
  int node_count() const { return nodes[3] < 0 ? 3 : 4; }
};

/// Triangle (and quadrilateral) surfaces from STL, PLY, OFF, OBJ or legacy VTK polydata.
struct SurfaceMesh {
  std::vector<Vec3<double>> X;  ///< vertex position [m]  [vertex_count]
  std::vector<Facet> facets;    ///< [facet_count]
};

}  // namespace glisson
