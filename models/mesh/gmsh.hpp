// What the Gmsh readers of both versions share: numbers as text or bytes, tags, and sections with values.
#pragma once

#include <map>
#include <unordered_map>

#include <glisson/models/mesh/raw_mesh.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {

/// From the tags of a file, which may have gaps and any order, to indices.
class Tags {
 public:
  /// False when the tag is there already.
  bool add(std::int64_t tag, int index);
  /// -1: no such tag.
  int find(std::int64_t tag) const;
  std::size_t size() const { return size_; }

 private:
  std::vector<int> near_;  ///< by tag, for tags not much larger than their number
  std::unordered_map<std::int64_t, int> far_;
  std::size_t size_ = 0;
};

/// Rows of values for tags, as $NodeData and $ElementData hold them.
struct GmshData {
  bool of_nodes = false;
  std::string name;
  NamedArray rows;
  std::vector<std::int64_t> tags;  ///< [-]  [row_count]
};

/// A file in work.
struct GmshReader {
  Scanner scanner;
  RawMesh raw;
  bool is_version_4 = false;
  int size_bytes = 8;  ///< of a size in a binary file
  Tags nodes, elements;
  std::vector<GmshData> data;
  std::map<std::pair<std::int64_t, std::int64_t>, int> physical;  ///< label by dimension and tag of an entity

  std::int64_t integer(const char* what);  ///< int32 when binary
  std::int64_t size(const char* what);     ///< size_t when binary
  std::int64_t count(const char* what, std::size_t least_text, std::size_t least_bytes);  ///< a size, checked
  double real(const char* what);
  void read_position();
  void add_node_tag(std::int64_t tag, int index);
  /// The tag is read already.
  void add_element(std::int64_t tag, std::int64_t type, std::int64_t label);
  int label_of(std::int64_t value) const;
};

void read_nodes_2(GmshReader& reader);
void read_elements_2(GmshReader& reader);
void read_entities_4(GmshReader& reader);
void read_nodes_4(GmshReader& reader);
void read_elements_4(GmshReader& reader);
void read_data(GmshReader& reader, bool of_nodes);
/// Turns the sections with values into arrays, now that nodes and elements are known.
void add_data(GmshReader& reader);

}  // namespace glisson::detail
