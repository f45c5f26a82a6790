// Small mesh files made in memory: two tetrahedra and a triangle as Gmsh, VTK and VTU, two triangles as
// surfaces, in every encoding. What the tests of the mesh readers share.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <glisson/models/mesh/number_type.hpp>
#include <string>
#include <vector>

namespace glisson::test {

enum class Code { text, little, big };

/// Puts numbers as text or as bytes of either order.
class FileMaker {
 public:
  explicit FileMaker(Code code) : code_(code) {}

  FileMaker& raw(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  template <class T>
  FileMaker& put(std::initializer_list<double> values) {
    for (const double v : values) {
      const T value = static_cast<T>(v);
      if (code_ == Code::text) {
        bytes_ += number(value) + " ";
        continue;
      }
      const T coded = detail::load<T>(reinterpret_cast<const char*>(&value),
                                      (code_ == Code::big) != (std::endian::native == std::endian::big));
      bytes_.append(reinterpret_cast<const char*>(&coded), sizeof coded);
    }
    if (code_ == Code::text) bytes_ += "\n";
    return *this;
  }
  std::string str() const { return bytes_; }

 private:
  static std::string number(double v) {
    return v == static_cast<int>(v) ? std::to_string(static_cast<int>(v)) : std::to_string(v);
  }

  Code code_;
  std::string bytes_;
};

/// Node tags 10 to 50 with a gap; the second tetrahedron is inverted; labels 3 and 4; a triangle before them.
inline std::string gmsh_2(Code code) {
  FileMaker f(code);
  f.raw(code == Code::text ? "$MeshFormat\n2.2 0 8\n" : "$MeshFormat\n2.2 1 8\n");
  if (code != Code::text) f.put<std::int32_t>({1}).raw("\n");
  f.raw("$EndMeshFormat\n$PhysicalNames\n1\n3 3 \"liver\"\n$EndPhysicalNames\n$Nodes\n5\n");
  const double X[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, -1}};
  for (int n = 0; n < 5; ++n) {
    f.put<std::int32_t>({n < 4 ? 10.0 * n + 10 : 99999999.0}).put<double>({X[n][0], X[n][1], X[n][2]});
  }
  f.raw("$EndNodes\n$Elements\n3\n");
  if (code == Code::text) {
    f.raw("1 2 2 8 8 10 20 30\n2 4 2 3 1 10 20 30 40\n3 4 2 0 4 10 20 30 99999999\n");
  } else {
    f.put<std::int32_t>({2, 1, 2, 1, 8, 8, 10, 20, 30, 4, 2, 2, 2, 3, 1, 10, 20, 30, 40});
    f.put<std::int32_t>({3, 0, 4, 10, 20, 30, 99999999}).raw("\n");
  }
  f.raw("$EndElements\n$ElementData\n1\n\"E\"\n1\n0\n3\n0\n1\n2\n");
  f.put<std::int32_t>({2}).put<double>({1000}).put<std::int32_t>({3}).put<double>({2000.5});
  return f.raw("$EndElementData\n").str();
}

/// The same mesh; the label 3 comes from a physical group of volume 1, the label 4 is that of volume 4.
inline std::string gmsh_4(Code code) {
  FileMaker f(code);
  f.raw(code == Code::text ? "$MeshFormat\n4.1 0 8\n" : "$MeshFormat\n4.1 1 8\n");
  if (code != Code::text) f.put<std::int32_t>({1}).raw("\n");
  f.raw("$EndMeshFormat\n$Entities\n").put<std::uint64_t>({1, 0, 1, 2});
  f.put<std::int32_t>({1}).put<double>({0, 0, 0}).put<std::uint64_t>({0});
  f.put<std::int32_t>({8}).put<double>({0, 0, 0, 1, 1, 1}).put<std::uint64_t>({0}).put<std::uint64_t>({0});
  f.put<std::int32_t>({1}).put<double>({0, 0, 0, 1, 1, 1}).put<std::uint64_t>({2}).put<std::int32_t>({-3, 7});
  f.put<std::uint64_t>({1}).put<std::int32_t>({8});
  f.put<std::int32_t>({4}).put<double>({0, 0, 0, 1, 1, 1}).put<std::uint64_t>({0}).put<std::uint64_t>({0});
  f.raw("\n$EndEntities\n$Nodes\n").put<std::uint64_t>({2, 5, 10, 99999999});
  f.put<std::int32_t>({0, 1, 0}).put<std::uint64_t>({1}).put<std::uint64_t>({10}).put<double>({0, 0, 0});
  f.put<std::int32_t>({2, 8, 1}).put<std::uint64_t>({4}).put<std::uint64_t>({20, 30, 40, 99999999});
  f.put<double>({1, 0, 0, 0.1, 0.2, 0, 1, 0, 0.1, 0.2, 0, 0, 1, 0.1, 0.2, 0.5, 0.5, -1, 0.1, 0.2});
  f.raw("\n$EndNodes\n$Elements\n").put<std::uint64_t>({3, 3, 1, 3});
  f.put<std::int32_t>({2, 8, 2}).put<std::uint64_t>({1}).put<std::uint64_t>({1, 10, 20, 30});
  f.put<std::int32_t>({3, 1, 4}).put<std::uint64_t>({1}).put<std::uint64_t>({2, 10, 20, 30, 40});
  f.put<std::int32_t>({3, 4, 4}).put<std::uint64_t>({1}).put<std::uint64_t>({3, 10, 20, 30, 99999999});
  f.raw("\n$EndElements\n$ElementData\n1\n\"E\"\n1\n0\n3\n0\n1\n2\n");
  f.put<std::int32_t>({2}).put<double>({1000}).put<std::int32_t>({3}).put<double>({2000.5});
  return f.raw("\n$EndElementData\n").str();
}

inline std::string vtk_points(FileMaker& f) {
  f.raw("POINTS 5 double\n").put<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, -1});
  return f.str();
}

/// The same mesh as legacy VTK; `version` 5 has offsets.
inline std::string vtk_file(Code code, int version) {
  FileMaker f(code);
  f.raw("# vtk DataFile Version " + std::string(version == 5 ? "5.1" : "3.0") + "\ntitle\n");
  f.raw(code == Code::text ? "ASCII\n" : "BINARY\n")
      .raw("DATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTIME 1 1 double\n");
  f.put<double>({0.25}).raw("\n");
  vtk_points(f);
  f.raw("\nMETADATA\nINFORMATION 0\n\n");
  if (version == 5) {
    f.raw("CELLS 4 11\nOFFSETS vtktypeint64\n").put<std::int64_t>({0, 3, 7, 11});
    f.raw("\nCONNECTIVITY vtktypeint64\n").put<std::int64_t>({0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 4});
  } else {
    f.raw("CELLS 3 14\n").put<std::int32_t>({3, 0, 1, 2, 4, 0, 1, 2, 3, 4, 0, 1, 2, 4});
  }
  f.raw("\nCELL_TYPES 3\n").put<std::int32_t>({5, 10, 10});
  f.raw("\nCELL_DATA 3\nSCALARS Label short\nLOOKUP_TABLE default\n").put<std::int16_t>({8, 3, 4});
  f.raw("\nFIELD FieldData 1\nE 1 3 float\n").put<float>({0, 1000, 2000.5});
  f.raw("\nPOINT_DATA 5\nVECTORS fibre%20axis float\n")
      .put<float>({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5, 0});
  f.raw("\nTENSORS T double\n").put<double>({0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2, 3, 4, 5,
                                             6, 7, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2,
                                             3, 4, 5, 6, 7, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8});
  return f.raw("\n").str();
}

inline const std::string vtu_text =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n<Points>\n"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1 0.5 0.5 "
    "-1</DataArray>\n"
    "</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 2 3 0 1 "
    "2 4</DataArray>\n"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 7 11</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10 10</DataArray>\n</Cells>\n<CellData>\n"
    "<DataArray type=\"Int32\" Name=\"label\" format=\"ascii\">8 3 4</DataArray>\n"
    "<DataArray type=\"Float64\" Name=\"E\" format=\"ascii\">0 1000 2000.5</DataArray>\n</CellData>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

inline const std::string off_text =
    "OFF # a comment\n4 2 5\n0 0 0\n1 0 0 # here too\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n";

inline const std::string obj_text =
    "# comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nusemtl a\nf 1/1/1 "
    "2//1 3/1\nf -4 -2 -1\n";

inline std::string ply_file(Code code) {
  FileMaker f(code);
  const char* name = code == Code::text     ? "ascii"
                     : code == Code::little ? "binary_little_endian"
                                            : "binary_big_endian";
  f.raw("ply\nformat " + std::string(name) + " 1.0\ncomment made here\nelement vertex 4\nproperty float x\n");
  f.raw(
      "property double y\nproperty float z\nproperty uchar red\nelement edge 1\nproperty int a\nproperty "
      "list uchar short b\n");
  f.raw("element face 2\nproperty uchar flag\nproperty list uchar int vertex_indices\nend_header\n");
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    f.put<float>({double(x)}).put<double>({double(y)}).put<float>({0}).put<std::uint8_t>({200});
  f.put<std::int32_t>({7}).put<std::uint8_t>({2}).put<std::int16_t>({5, 6});
  f.put<std::uint8_t>({1, 3}).put<std::int32_t>({0, 1, 2}).put<std::uint8_t>({1, 3}).put<std::int32_t>(
      {0, 2, 3});
  return f.str();
}

inline std::string stl_text() {
  std::string text = "solid two words\n";
  for (const char* corner : {"1 1 -0.0", "0 1 0"})
    text += std::string("facet normal nan 0 1\n outer loop\n  vertex 0 0 0\n  vertex ") +
            (corner[0] == '1' ? "1 0 0\n  vertex 1 1 -0.0" : "1 1 0\n  vertex 0 1 0") +
            "\n endloop\nendfacet\n";
  return text + "endsolid two words\n";
}

inline std::string stl_binary() {
  FileMaker f(Code::little);
  f.raw("solid, but binary all the same" + std::string(50, ' ')).put<std::uint32_t>({2});
  f.put<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0}).put<std::uint16_t>({0});
  f.put<float>({0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0}).put<std::uint16_t>({0});
  return f.str();
}

}  // namespace glisson::test
