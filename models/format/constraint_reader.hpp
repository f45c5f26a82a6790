// One Constraint element in the reading: what it acts on and the values on that.
#pragma once

#include <glisson/models/format/reader.hpp>

#include <span>
#include <string>
#include <vector>

namespace glisson::detail {

class ConstraintReader {
 public:
  ConstraintReader(const Reader& reader, const XmlElement& element, const SelectionMesh& mesh)
      : reader_(reader), element_(element), mesh_(mesh) {}

  /// Selected nodes; an error when there is none. With `all_is_empty`, every node of the mesh is the empty
  /// list.
  std::vector<int> nodes();
  std::vector<Facet> facets();
  /// True after nodes() or facets() if the file says that it acts on nothing (NumNodes="0").
  bool acts_on_nothing() const { return nothing_; }

  Axes axes() const;
  LoadCurve curve() const { return read_curve(reader_, element_, "LoadShape", "Table", {}); }
  /// One value (UNIFORM) or one per selected item of `width` numbers (DIFFORM, FILE), in the order of the
  /// selection.
  std::vector<double> values(const XmlElement& element, std::size_t width) const;
  std::vector<Vec3<double>> vectors(const XmlElement& element) const;

 private:
  std::vector<Facet> listed_facets(const std::string& count);
  std::vector<Facet> listed_triangles(const XmlElement& faces);
  void require_any(std::size_t count);

  const Reader& reader_;
  const XmlElement& element_;
  const SelectionMesh& mesh_;
  bool nothing_ = false;
  std::vector<std::size_t> listed_;  ///< place in the file's list of each selected item; empty: no list
  std::size_t listed_count_ = 0;
  std::size_t selected_count_ = 0;
};

}  // namespace glisson::detail
