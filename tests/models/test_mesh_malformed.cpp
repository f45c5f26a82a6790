// Damaged mesh files: each gives Error(input) that names the file, the place and the reason.
#include <gtest/gtest.h>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/read_mesh.hpp>

#include <filesystem>
#include <fstream>
#include <functional>
#include <tests/models/mesh_files.hpp>

namespace glisson::test {
namespace {

/// A good file with one part replaced, and what the message must say.
struct Case {
  const char* name;
  MeshFormat format;
  std::string text;
  const char* place;   ///< "name:LINE:" for text, a part of the place for bytes
  const char* reason;  ///< part of the message
};

/// The first `old` in a good file becomes `now`. A file without `old` would test nothing.
std::string with(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

std::string cut(std::string text, const std::string& behind, std::size_t more = 0) {
  const auto place = text.find(behind);
  EXPECT_NE(place, std::string::npos) << behind;
  return text.substr(0, place + behind.size() + more);
}

void expect_errors(const std::vector<Case>& cases, bool solid) {
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    try {
      if (solid)
        parse_solid_mesh(c.text, "bad file", c.format);
      else
        parse_surface_mesh(c.text, "bad file", c.format);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.kind(), ErrorKind::input) << what;
      EXPECT_EQ(what.rfind("bad file", 0), 0U) << what;
      EXPECT_NE(what.find(c.place), std::string::npos) << what;
      EXPECT_NE(what.find(c.reason), std::string::npos) << what;
    }
  }
}

TEST(MeshMalformed, GmshText) {
  const auto f = MeshFormat::gmsh;
  const auto v2 = gmsh_2(Code::text), v4 = gmsh_4(Code::text);
  expect_errors(
      {
          {"empty", f, "", "bad file:", "the file is empty"},
          {"other magic", f, "hello\n", "bad file:1:", "no Gmsh mesh file"},
          {"a VTK file", f, vtk_file(Code::text, 3), "bad file:", "begin like a .vtk file"},
          {"gzip", f, "\x1f\x8b rest", "bad file:", "gunzip"},
          {"format 1", f, "$NOD\n1\n", "bad file:1:", "format 1 is not supported"},
          {"version 3", f, with(v2, "2.2", "3.0"), "bad file:2: MeshFormat", "version '3.0'"},
          {"version 4.0", f, with(v4, "4.1", "4"), "bad file:2: MeshFormat", "version '4'"},
          {"file type", f, with(v2, "2.2 0 8", "2.2 2 8"), "bad file:2:", "neither 0 (text) nor 1"},
          {"data size", f, with(v2, "2.2 0 8", "2.2 0 16"), "bad file:2:", "16 bytes"},
          {"no end", f, with(v2, "$EndMeshFormat", "$EndMesh"), "bad file:3: MeshFormat", "$EndMeshFormat"},
          {"other section not closed", f, with(v2, "$EndPhysicalNames", "$End"), "PhysicalNames",
           "truncated"},
          {"count not a number", f, with(v2, "$Nodes\n5", "$Nodes\nfive"), "bad file:9: Nodes", "'five'"},
          {"negative count", f, with(v2, "$Nodes\n5", "$Nodes\n-5"), "bad file:9: Nodes", "-5"},
          {"huge count", f, with(v2, "$Nodes\n5", "$Nodes\n2000000000"), "bad file:9: Nodes", "bytes follow"},
          {"count beyond int", f, with(v2, "$Nodes\n5", "$Nodes\n99999999999"), "bad file:9:", "2147483647"},
          {"count too large", f, with(v2, "$Nodes\n5", "$Nodes\n6"), "bad file:20: Nodes", "'$EndNodes'"},
          {"count too small", f, with(v2, "$Nodes\n5", "$Nodes\n4"), "bad file:18: Nodes", "'99999999'"},
          {"truncated in a node", f, cut(v2, "\n30 "), "Nodes", "truncated"},
          {"not finite", f, with(v2, "0.500000", "nan"), "bad file:19: Nodes", "not finite"},
          {"out of range of double", f, with(v2, "0.500000", "1e999"), "bad file:19: Nodes",
           "beyond the range"},
          {"node twice", f, with(v2, "\n40 ", "\n30 "), "bad file:16: Nodes", "node 30 is there twice"},
          {"no such node", f, with(v2, "10 20 30 40", "10 20 30 41"), "bad file:24: Elements",
           "uses node 41"},
          {"unknown type", f, with(v2, "2 4 2 3 1", "2 77 2 3 1"), "bad file:24: Elements", "type 77"},
          {
              "too few nodes",
              f,
              with(v2, "10 20 30 40", "10 20 30"),
              "Elements",
              "uses node 3",
          },
          {"tag count", f, with(v2, "2 4 2 3 1", "2 4 -2 3 1"), "bad file:24: Elements", "-2"},
          {"label beyond int", f, with(v2, "2 4 2 3 1", "2 4 2 3000000000 1"), "Elements", "3000000000"},
          {"elements first", f, with(v2, "$Nodes", "$Elements"), "bad file:8: Elements", "no nodes before"},
          {"data for no element", f, with(v2, "\n2 \n1000", "\n77 \n1000"), "bad file", "element 77"},
          {"data without columns", f, with(v2, "0\n1\n2\n2 ", "0\n0\n2\n2 "), "ElementData", "0 components"},
          {"4: sum of nodes", f, with(v4, "2 5 10", "2 6 10"), "Nodes", "6 are announced"},
          {"4: sum of elements", f, with(v4, "3 3 1 3", "3 2 1 3"), "Elements", "2 are announced"},
          {"4: dimension", f, with(v4, "2 8 1 \n4", "7 8 1 \n4"), "Nodes", "dimension 7"},
          {"4: huge block", f, with(v4, "2 8 1 \n4", "2 8 1 \n1000000"), "Nodes", "bytes follow"},
      },
      true);
}

TEST(MeshMalformed, GmshBinary) {
  const auto f = MeshFormat::gmsh;
  const auto v2 = gmsh_2(Code::little), v4 = gmsh_4(Code::little);
  expect_errors(
      {
          {"byte order", f, with(v2, std::string("\1\0\0\0", 4), std::string("\1\1\0\0", 4)), "byte 20",
           "byte order"},
          {"truncated in nodes", f, cut(v2, "$Nodes\n5\n", 40), "Nodes, byte ", "truncated"},
          {"truncated in elements", f, cut(v2, "$Elements\n3\n", 30), "Elements, byte ", "truncated"},
          {"block too long", f, with(v2, "$Elements\n3\n", "$Elements\n2\n"), "Elements, byte ",
           "still to come"},
          {"4: truncated", f, cut(v4, "$Nodes\n", 60), "Nodes, byte ", "truncated"},
          {"4: huge", f,
           with(v4, "$Nodes\n" + std::string("\2"), "$Nodes\n" + std::string("\2\0\0\0\0\0\0\1", 8)),
           "Nodes, byte ", "2147483647"},
          {"4: no entities", f, cut(v4, "$Entities\n", 3), "Entities, byte ", "truncated"},
      },
      true);
}

TEST(MeshMalformed, LegacyVtk) {
  const auto f = MeshFormat::vtk;
  const auto v3 = vtk_file(Code::text, 3), v5 = vtk_file(Code::text, 5), b3 = vtk_file(Code::big, 3);
  expect_errors(
      {
          {"magic", f, with(v3, "# vtk", "# vtq"), "bad file:1: header", "no legacy VTK file"},
          {"version 6", f, with(v3, "3.0", "6.0"), "bad file:1: header", "version '6.0'"},
          {"mode", f, with(v3, "ASCII", "UTF8"), "bad file:3: header", "ASCII or BINARY"},
          {"kind", f, with(v3, "UNSTRUCTURED_GRID", "STRUCTURED_POINTS"), "bad file:4:", "UNSTRUCTURED_GRID"},
          {"only a title", f, cut(v3, "title\n"), "bad file:3:", "truncated"},
          {"point type", f, with(v3, "5 double", "5 real"), "POINTS", "'real'"},
          {"negative points", f, with(v3, "POINTS 5", "POINTS -5"), "POINTS", "-5"},
          {"huge points", f, with(v3, "POINTS 5", "POINTS 1000000000"), "POINTS", "bytes follow"},
          {"too many points", f, with(v3, "POINTS 5", "POINTS 6"), "POINTS", "'METADATA' is not a number"},
          {"point not finite", f, with(v3, "0.500000 0.500000 -1", "0.5 inf -1"), "POINTS", "not finite"},
          {"cell beyond list", f, with(v3, "4 0 1 2 4", "5 0 1 2 4"), "CELLS", "ends within cell 2"},
          {"list too long", f, with(v3, "CELLS 3 14", "CELLS 2 14"), "CELLS", "take 9 numbers"},
          {"no such point", f, with(v3, "4 0 1 2 4", "4 0 1 2 5"), "CELLS", "point 5 does not exist"},
          {"types missing", f, with(v3, "CELL_TYPES 3", "CELL_TYPES 2"), "CELL_TYPES", "types for 2"},
          {"no types", f, cut(v3, "4 0 1 2 4 "), "bad file", "CELL_TYPES for 0"},
          {"type beyond", f, with(v3, "5 10 10", "5 10 300"), "CELL_TYPES", "300"},
          {"unknown cell", f, with(v3, "5 10 10", "5 10 99"), "cell 2", "type 99"},
          {"pyramid", f, with(v3, "5 10 10", "5 10 14"), "cell 2", "linear tetrahedra"},
          {"quadratic", f, with(v3, "5 10 10", "5 10 24"), "cell 2", "10-node tetrahedron"},
          {"hexahedron of 4", f, with(v3, "5 10 10", "5 10 12"), "cell 2", "has 8 nodes"},
          {"no solids", f, with(v3, "5 10 10", "5 9 9"), "bad file", "no tetrahedron"},
          {"data count", f, with(v3, "CELL_DATA 3", "CELL_DATA 4"), "CELL_DATA", "has 3"},
          {"data missing", f, cut(v3, "1000 "), "FIELD", "truncated"},
          {"field rows", f, with(v3, "E 1 3 float", "E 1 2 float"), "FIELD", "3 are needed"},
          {"field columns", f, with(v3, "E 1 3 float", "E 0 3 float"), "FIELD", "0 components"},
          {"keyword", f, with(v3, "VECTORS", "VEKTORS"), "VEKTORS", "not known"},
          {"5: offsets decrease", f, with(v5, "0 3 7 11", "0 7 3 11"), "CELLS", "decrease"},
          {"5: offsets end", f, with(v5, "0 3 7 11", "0 3 7 10"), "CELLS", "do not run"},
          {"5: connectivity missing", f, with(v5, "CONNECTIVITY", "CONNECTION"), "CELLS", "'CONNECTION'"},
          {"binary truncated", f, cut(b3, "POINTS 5 double\n", 50), "POINTS, byte ", "bytes follow"},
          {"binary cells truncated", f, cut(b3, "CELLS 3 14\n", 20), "CELLS, byte ", "bytes follow"},
      },
      true);
}

TEST(MeshMalformed, Vtu) {
  const auto f = MeshFormat::vtk_xml;
  const auto& good = vtu_text;
  const auto coded = [&](const std::string& data, const std::string& attributes = "") {
    return with(
        with(good, "format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1 0.5 0.5 -1", "format=\"binary\">" + data),
        "version=\"0.1", attributes + " version=\"0.1");
  };
  expect_errors(
      {
          {"no XML", f, "<VTKFile", "bad file:1:", "not well-formed"},
          {"truncated", f, cut(good, "<Cells>"), "bad file:", "not well-formed"},
          {"other root", f, "<Model/>", "bad file:1:", "<VTKFile>"},
          {"other type", f, with(good, "type=\"UnstructuredGrid\"", "type=\"ImageData\""),
           "bad file:2: VTKFile", "ImageData"},
          {"byte order", f, with(good, "LittleEndian", "Middle"), "bad file:2:", "Middle"},
          {"compressor", f, with(good, "version=\"0.1", "compressor=\"vtkLZMADataCompressor\" version=\"0.1"),
           "bad file:2:", "vtkLZMA"},
          {"header type", f, with(good, "version=\"0.1", "header_type=\"UInt16\" version=\"0.1"),
           "bad file:2:", "UInt16"},
          {"no grid", f, with(with(good, "<UnstructuredGrid>", "<U>"), "</UnstructuredGrid>", "</U>"),
           "bad file:2:", "missing"},
          {"count", f, with(good, "NumberOfPoints=\"5\"", "NumberOfPoints=\"x\""), "bad file:3: Piece",
           "'x'"},
          {"huge count", f, with(good, "NumberOfPoints=\"5\"", "NumberOfPoints=\"2000000000\""),
           "bad file:5:", "needs 6000000000"},
          {"points missing", f, with(good, "NumberOfPoints=\"5\"", "NumberOfPoints=\"6\""),
           "bad file:5:", "needs 18"},
          {"not a number", f, with(good, "0.5 0.5 -1", "0.5 half -1"), "bad file:5:", "'half'"},
          {"not finite", f, with(good, "0.5 0.5 -1", "0.5 inf -1"), "bad file:5:", "not finite"},
          {"number type", f, with(good, "Float64", "Float80"), "bad file:5:", "Float80"},
          {"format", f, with(good, "format=\"ascii\"", "format=\"octal\""), "bad file:5:", "octal"},
          {"no connectivity", f, with(good, "connectivity", "connections"), "Cells", "connectivity"},
          {"no such point", f, with(good, "0 1 2 4<", "0 1 2 5<"), "'connectivity'", "point 5"},
          {"offsets", f, with(good, "3 7 11", "7 3 11"), "'offsets'", "decrease"},
          {"wedge", f, with(good, "5 10 10", "5 10 13"), "cell 2", "wedge"},
          {"cell array", f, with(good, "0 1000 2000.5", "0 1000"), "'E'", "needs 3"},
          {"components", f, with(good, "Name=\"E\"", "Name=\"E\" NumberOfComponents=\"0\""), "'E'",
           "NumberOfComponents"},
          {"base64 of nothing", f, coded("****"), "bad file:5:", "no base64"},
          {"base64 of too few bytes", f, coded("eAAAAAAA"), "bad file:5:", "the file is truncated"},
          {"base64 of another size", f, coded("BAAAAAAA"), "bad file:5:", "has 4 bytes"},
          {"huge compressed blocks", f, coded("/////wAAAQAAAAAA", "compressor=\"vtkZLibDataCompressor\""),
           "bad file:5:", "compressed blocks"},
          {"no zlib", f,
           coded("AQAAAHgAAAAAAAAACAAAAA==AAAAAAAAAAA=", "compressor=\"vtkZLibDataCompressor\""),
           "bad file:5:", "zlib"},
          {"no offset", f, with(good, "format=\"ascii\"", "format=\"appended\""), "bad file:5:", "offset"},
          {"offset beyond", f, with(good, "format=\"ascii\"", "format=\"appended\" offset=\"99\""),
           "bad file:5:", "beyond"},
      },
      true);
}

TEST(MeshMalformed, Surfaces) {
  const auto text = stl_text(), bytes = stl_binary(), ply = ply_file(Code::text),
             ply_bytes = ply_file(Code::little);
  const auto stl = MeshFormat::stl, p = MeshFormat::ply, off = MeshFormat::off, obj = MeshFormat::obj;
  std::string more_facets = bytes.substr(5);
  more_facets = "other" + more_facets + "x";
  expect_errors(
      {
          {"STL: magic", stl, "hello", "bad file:1:", "no STL file"},
          {"STL: keyword", stl, with(text, "facet", "face"), "bad file:2:", "'face'"},
          {"STL: vertex", stl, with(text, "1 0 0", "1 0 x"), "bad file:5:", "'x'"},
          {"STL: not finite", stl, with(text, "1 0 0", "1 0 inf"), "bad file:5:", "not finite"},
          {"STL: two vertices", stl, with(text, "  vertex 1 0 0\n", ""), "bad file:6:", "'endloop'"},
          {"STL: no end", stl, cut(text, "endfacet\n"), "bad file:9:", "truncated"},
          {"STL: no facets", stl, "solid a\nendsolid a\n", "bad file", "no facet"},
          {"STL: length", stl, more_facets, "header, byte 80", "damaged"},
          {"STL: short", stl, "other" + bytes.substr(5, 150), "header, byte 80", "truncated"},
          {"PLY: magic", p, "plyx\n", "bad file:1: header", "no PLY file"},
          {"PLY: format", p, with(ply, "ascii", "utf8"), "bad file:2: header", "'utf8'"},
          {"PLY: version", p, with(ply, " 1.0", " 2.0"), "bad file:2: header", "'2.0'"},
          {"PLY: no format", p, with(ply, "format ascii 1.0\n", ""), "header", "no format"},
          {"PLY: keyword", p, with(ply, "comment", "remark"), "bad file:3: header", "'remark'"},
          {"PLY: type", p, with(ply, "property float x", "property half x"), "bad file:5:", "'half'"},
          {"PLY: no z", p, with(ply, "float z", "float w"), "element vertex", "x, y and z"},
          {"PLY: huge", p, with(ply, "vertex 4", "vertex 1000000000"), "bad file:4:", "bytes follow"},
          {"PLY: no header end", p, cut(ply, "vertex_indices\n"), "header", "truncated"},
          {"PLY: list of floats", p, with(ply, "uchar int vertex", "float int vertex"), "header",
           "whole number"},
          {"PLY: no such vertex", p, with(ply, "0 2 3", "0 2 4"), "face 1", "vertex 4"},
          {"PLY: binary truncated", p, ply_bytes.substr(0, ply_bytes.size() - 3), "face 1, byte ",
           "truncated"},
          {"OFF: magic", off, "OOF\n", "bad file:1: header", "no OFF file"},
          {"OFF: binary", off, "OFF BINARY\n", "bad file:1: header", "binary OFF"},
          {"OFF: counts", off, with(off_text, "4 2 5", "4"), "bad file:8:", "0 facets"},
          {"OFF: huge", off, with(off_text, "4 2 5", "99999999 2 5"), "bad file:2: header", "bytes follow"},
          {"OFF: more vertices", off, with(off_text, "4 2 5", "3 2 5"), "bad file:6: facet 0",
           "without vertices"},
          {"OFF: no such vertex", off, with(off_text, "3 0 2 3", "3 0 2 4"), "bad file:8: facet 1",
           "vertex 4"},
          {"OFF: rest", off, off_text + "3 0 1 2\n", "bad file:9:", "more in the file"},
          {"OBJ: keyword", obj, "w 1 2 3\n", "bad file:1:", "'w'"},
          {"OBJ: coordinate", obj, with(obj_text, "v 0 1 0", "v 0 1"), "bad file:9:", "'usemtl'"},
          {"OBJ: no such vertex", obj, with(obj_text, "2//1", "5//1"), "bad file:10:", "vertex 5"},
          {"OBJ: vertex 0", obj, with(obj_text, "2//1", "0//1"), "bad file:10:", "vertex 0"},
          {"OBJ: backwards", obj, with(obj_text, "-4", "-5"), "bad file:11:", "vertex -5"},
          {"OBJ: two vertices", obj, with(obj_text, "-4 -2 -1", "-4 -2"), "bad file:11:", "at least 3"},
          {"OBJ: solid wanted", obj, with(obj_text, "f -4 -2 -1", "f 1 2 x"), "bad file:11:", "'x'"},
      },
      false);
  EXPECT_THROW(parse_solid_mesh(obj_text, "a.obj", obj), Error);
}

/// Every file cut off anywhere gives a mesh or an Error.
TEST(MeshMalformed, CutAnywhere) {
  const std::pair<MeshFormat, std::string> files[] = {
      {MeshFormat::gmsh, gmsh_2(Code::text)},    {MeshFormat::gmsh, gmsh_2(Code::big)},
      {MeshFormat::gmsh, gmsh_4(Code::text)},    {MeshFormat::gmsh, gmsh_4(Code::big)},
      {MeshFormat::vtk, vtk_file(Code::big, 3)}, {MeshFormat::vtk, vtk_file(Code::big, 5)},
      {MeshFormat::vtk_xml, vtu_text},           {MeshFormat::stl, stl_binary()},
      {MeshFormat::ply, ply_file(Code::big)}};
  for (const auto& [format, text] : files) {
    int errors = 0;
    for (std::size_t size = 0; size < text.size(); ++size) try {
        if (format == MeshFormat::stl || format == MeshFormat::ply)
          parse_surface_mesh(std::string_view(text).substr(0, size), "a", format);
        else
          parse_solid_mesh(std::string_view(text).substr(0, size), "a", format);
      } catch (const Error&) {
        ++errors;
      }
    EXPECT_GT(errors, static_cast<int>(text.size() / 3));
  }
}

TEST(MeshMalformed, Files) {
  const auto reason = [](const std::string& path) -> std::string {
    try {
      read_solid_mesh(path);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(reason("not/there.msh").find("not/there.msh: there is no such file"), std::string::npos);
  EXPECT_NE(reason("not/there.msh").find(std::filesystem::current_path().string()), std::string::npos);
  EXPECT_NE(reason("/").find("folder"), std::string::npos);
  EXPECT_NE(reason("/dev/zero").find("device"), std::string::npos);
  EXPECT_NE(reason(GLISSON_SOURCE_DIR "/CMakeLists.txt").find("Readable are .msh"), std::string::npos);
}

}  // namespace
}  // namespace glisson::test
