// What the parts of the format reader share: where files are looked up, how complaints are made, and the
// model in work.
#pragma once

#include <glisson/core/model.hpp>
#include <glisson/models/format/read_model.hpp>
#include <glisson/models/format/xml_tree.hpp>
#include <glisson/models/mesh/read_mesh.hpp>
#include <glisson/models/selection/selection.hpp>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glisson::detail {

struct FileText {
  std::string path;  ///< as it was found
  std::string text;
};

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
  /// The file that find_file finds, whole.
  FileText text_in_file(const XmlElement& element, const std::string& path) const;
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
  std::vector<int> triangle_label;  ///< of the solid or file that a triangle comes from  [triangle_count]
  std::map<std::string, NamedArray> triangle_arrays;  ///< likewise, from arrays of cells [triangle_count]
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
/// Triangles of membranes and shells, then their sets.
void read_shell_elements(const Reader& reader, const XmlElement& level, Part& part);
void read_shell_sets(const Reader& reader, const XmlElement& level, Part& part);
/// One orientation, and edges that the sets can use; `place` is named in errors.
void check_shell_mesh(const Reader& reader, const XmlElement& place, Part& part);
/// Law, parameters, thickness and density of the section's triangles.
void read_shell_material(const Reader& reader, const XmlElement& material, const Part& part,
                         ShellSection& section);
void read_constraints(const Reader& reader, const XmlElement& level, Part& part);
void read_contact(const Reader& reader, const XmlElement& model, Part& part);
void read_contact_surfaces(const Reader& reader, const XmlElement& model, Part& part);
/// Contact of deformable bodies; after the sub-models, whose names pairs use.
void read_deformable_contact(const Reader& reader, const XmlElement& model, Part& part);
/// Notes the name of a sub-model for pairs of bodies.
void name_body(const XmlElement& sub_model, Part& part);
/// By `attribute`, Multiplier or Penalty, and Stiffness; `otherwise` where it is absent.
PenaltyShare read_response(const XmlElement& element, const char* attribute, const PenaltyShare& otherwise);
void read_system_params(Reader& reader, const XmlElement& model, TimeSettings& time);
void read_output(const XmlElement& model, OutputSettings& output);

MaterialSpec read_material(const Reader& reader, const XmlElement& material, const Mesh& mesh,
                           const std::vector<int>& elements);

/// A level of the tree with its sub-models, joined and merged.
Part read_level(const Reader& reader, const XmlElement& level);

/// The child that names the mesh file of a level; nullptr when the geometry is inline.
const XmlElement* mesh_file_of(const XmlElement& level);
/// The one place that calls the mesh readers.
LabelledSurface labelled_surface_from_file(const Reader& reader, const XmlElement& element);
Mesh mesh_from_file(const Reader& reader, const XmlElement& element);
/// found: gets the path of the file.
SurfaceMesh surface_from_file(const Reader& reader, const XmlElement& element, std::string* found = nullptr);
/// Moves positions by the element's Rotation, ScaleFactor and Translation.
void transform_as_told(const XmlElement& element, std::span<Vec3<double>> X);
std::shared_ptr<const SurfaceDistance> distance_from_file(const Reader& reader, const XmlElement& element,
                                                          double reach);

/// The coordinates of a Nodes element of a mesh.
std::vector<Vec3<double>> read_positions(const XmlElement& nodes);
/// A list of indices, or a single start index for `count` consecutive ones; checked against [0, size).
std::vector<int> index_list(const XmlElement& element, std::optional<int> count, int size, const char* what);
/// Whole numbers of an attribute such as Label="255 127".
std::vector<int> integers_of(const XmlElement& element, const XmlAttribute& attribute);
/// Which of `count` items have one of the labels that the attribute lists; an error when none has.
std::vector<int> labelled(const XmlElement& set, const XmlAttribute& attribute, const std::vector<int>& label,
                          int count, const char* what);
/// Facets of Type T3 or Q4 listed in the text; NumEls must fit where it is given.
std::vector<Facet> facet_list(const XmlElement& element, int node_count);
double positive_number(const XmlElement& element);
/// An array by the name that the element's text gives, with a suggestion when there is none.
const NamedArray& named_array(const XmlElement& element, const std::map<std::string, NamedArray>& arrays,
                              int components);
/// One component of the rows of an array.
std::vector<double> picked(const NamedArray& array, const std::vector<int>& rows, int component);

/// What a constraint acts on: a list in the order of the file (if there is one) and conditions that must hold
/// too.
struct Choice {
  std::optional<std::vector<int>> list;
  Selection filter{Selection::Kind::both, {}, {}, {}, {}};
  bool empty_on_purpose = false;  ///< NumNodes="0"
};
Choice read_choice(const Reader& reader, const XmlElement& constraint, const Mesh& mesh);
/// The choice as one condition on facets, lists included.
Selection facet_filter(Choice choice);
Selection read_leaf(const Reader& reader, const XmlElement& leaf, const std::string& type, const Mesh& mesh);

LoadCurve read_curve(const Reader& reader, const XmlElement& element, const char* shape_attribute,
                     const char* table_element, std::optional<LoadShape> otherwise);

/// An error for a number below 0.
double not_negative(const XmlElement& element);
Vec3<double> vector_of(const XmlElement& element);
/// Unit vector; an error for the zero vector.
Vec3<double> direction_of(const XmlElement& element);

}  // namespace glisson::detail
