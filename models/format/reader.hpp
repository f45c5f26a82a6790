// What the parts of the format reader share: where files are looked up, how complaints are made, and the
// model in work.
#pragma once

#include <glisson/core/model.hpp>
#include <glisson/models/format/read_model.hpp>
#include <glisson/models/format/xml_tree.hpp>
#include <glisson/models/selection/selection.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glisson::detail {

/// Settings of one reading and of the whole file that its parts need.
class Reader {
 public:
  Reader(const ReadOptions& options, std::string file) : options_(options), file_(std::move(file)) {}

  std::optional<double> density;    ///< SystemParams/Density
  std::optional<double> hourglass;  ///< SystemParams/HGKappa
  double total_time = 0;            ///< [s]

  void warn(const XmlElement& element, const std::string& message) const;
  /// Error, or a warning in lenient mode.
  void complain(const XmlElement& element, int line, const std::string& message) const;
  /// Beside the simulation file, else in the working directory (with a warning), else an error that names
  /// both.
  std::string find_file(const XmlElement& element, const std::string& path) const;
  /// Whole text of a file of numbers, at most `most` of them.
  std::vector<double> numbers_in_file(const XmlElement& element, const std::string& path,
                                      std::size_t most) const;

 private:
  const ReadOptions& options_;
  std::string file_;
};

/// The two halves of read_model.
void read_document(const std::string& path, XmlDocument& document);
Model model_of(const XmlDocument& document, const std::string& file_name, const ReadOptions& options);

/// A model in work: a whole file or one sub-model, in its own numbering.
struct Part {
  Model model;
  std::vector<Formulation> formulation;  ///< as the mesh element asked for it  [element_count]
};

/// Which formulation a mesh element's Type gives each shape; empty: elements of that shape are not wanted.
struct FormulationChoice {
  std::optional<Formulation> tetrahedron, hexahedron;
  std::optional<Formulation> of(Shape shape) const {
    return shape == Shape::tetrahedron ? tetrahedron : hexahedron;
  }
};
FormulationChoice formulation_choice(const XmlElement& element, const std::string& type);
std::optional<Formulation> formulation_named(std::string_view name);

void read_geometry(const Reader& reader, const XmlElement& level, Part& part);
void read_element_sets(const Reader& reader, const XmlElement& level, Part& part);
void read_constraints(const Reader& reader, const XmlElement& level, Part& part);
void read_contact(const Reader& reader, const XmlElement& model, Part& part);
void read_contact_surfaces(const Reader& reader, const XmlElement& model, Part& part);
void read_system_params(Reader& reader, const XmlElement& model, TimeSettings& time);
void read_output(const XmlElement& model, OutputSettings& output);

MaterialSpec read_material(const Reader& reader, const XmlElement& material, const Mesh& mesh,
                           const std::vector<int>& elements);

/// A level of the tree with its sub-models, joined and merged.
Part read_level(const Reader& reader, const XmlElement& level);

/// The one place that calls the mesh readers.
Mesh mesh_from_file(const Reader& reader, const XmlElement& element);
SurfaceMesh surface_from_file(const Reader& reader, const XmlElement& element);
/// Moves positions by the element's Rotation, ScaleFactor and Translation.
void transform_as_told(const XmlElement& element, std::span<Vec3<double>> X);
std::shared_ptr<const SurfaceDistance> distance_from_file(const Reader& reader, const XmlElement& element,
                                                          double reach);

/// The coordinates of a Nodes element of a mesh.
std::vector<Vec3<double>> read_positions(const XmlElement& nodes);
/// A list of indices, or a single start index for `count` consecutive ones; checked against [0, size).
std::vector<int> index_list(const XmlElement& element, std::optional<int> count, int size, const char* what);

/// What a constraint acts on: a list in the order of the file (if there is one) and conditions that must hold
/// too.
struct Choice {
  std::optional<std::vector<int>> list;
  Selection filter{Selection::Kind::both, {}, {}, {}, {}};
  bool empty_on_purpose = false;  ///< NumNodes="0"
};
Choice read_choice(const Reader& reader, const XmlElement& constraint, const Mesh& mesh);
Selection read_leaf(const Reader& reader, const XmlElement& leaf, const std::string& type, const Mesh& mesh);

LoadCurve read_curve(const Reader& reader, const XmlElement& element, const char* shape_attribute,
                     const char* table_element, std::optional<LoadShape> otherwise);

Vec3<double> vector_of(const XmlElement& element);
/// Unit vector; an error for the zero vector.
Vec3<double> direction_of(const XmlElement& element);

}  // namespace glisson::detail
