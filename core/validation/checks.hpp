// The parts of validate(): each throws for what cannot be simulated and appends warnings for what looks
// wrong.
#pragma once

#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>
#include <glisson/core/model.hpp>

#include <string>
#include <vector>

namespace glisson::detail {

using Warnings = std::vector<std::string>;

[[noreturn]] inline void refuse(const std::string& what, const std::string& message) {
  throw Error(ErrorKind::input, message, {"", 0, what});
}

/// Sizes of the arrays, node indices, finite positions.
void check_mesh_arrays(const Mesh& mesh);
/// Volumes and shapes; needs each element's formulation.  [element_count]
void check_elements(const Mesh& mesh, const std::vector<Formulation>& formulation, Warnings& warnings);
/// Nodes without an element, nodes at the same place.
void check_nodes(const Model& model, Warnings& warnings);
/// Every element in one section, laws and their parameters. Returns the formulation of each element.
std::vector<Formulation> check_sections(const Model& model, Warnings& warnings);
/// Nodes and area of the triangles of membranes and shells; none twice.
void check_triangles(const Mesh& mesh);
/// Law, parameters, Prony terms, thickness and density of a set; `where` is named in messages.
void check_shell_section(const ShellSection& section, const std::string& where);
/// One orientation, and edges that the formulations of the triangles can use. A triangle may be in no set
/// yet.
void check_shell_edges(const Model& model);
/// All of it, every triangle in one set, and what is probably a mistake.
void check_shells(const Model& model, Warnings& warnings);
/// Lists, values and curves of loads, constraints and bodies.
void check_loads(const Model& model, Warnings& warnings);
/// Coulomb's coefficient of whatever `where` names.
void check_friction(double friction, const std::string& where);
/// A share in (0, 1], if there is one.
void check_penalty(const PenaltyShare& share, const std::string& where);
/// Friction and facets of rigid surfaces: corners that exist, area, at most two owners of an edge, one
/// orientation, and what check_volumes asks for.
void check_rigid_surfaces(const Model& model);
/// What is closed has an inside, or an outside if its facets face inwards; needs facets that are fine.
void check_volumes(const RigidSurface& surface, const std::string& where);
/// Friction, distances, nodes and names of contact between deformable bodies.
void check_deformable_contact(const Model& model, Warnings& warnings);
void check_time(const Model& model, Warnings& warnings);
/// Orders of magnitude, when the units are known.
void check_units(const Model& model, Warnings& warnings);

}  // namespace glisson::detail
