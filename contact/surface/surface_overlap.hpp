// Rigid surfaces that nodes lie behind in the file.
#pragma once

#include <vector>

#include <glisson/contact/surface/surface_data.hpp>

namespace glisson::contact {

/// Throws Error(input) that names the deepest of the nodes when it starts behind the surface by more than a
/// hundredth of the contact distance or a tenth of the shortest edge of the elements around it: behind closed
/// parts at any depth, behind open ones, beside which a body may reach, up to four contact distances; and
/// when no node is in front of the surface but some lie behind it at whatever depth, because then the facets
/// are turned the wrong way. Nodes of shells are held half of their thickness in front of it: those that
/// start nearer by more than the same are refused too. half_thickness: [node_count of the mesh]. Gives how
/// much nearer than they are held the others start [m]  [node_count of the mesh].
std::vector<double> start_depths(const RigidSurface& surface, const SurfaceData& data,
                                 const std::vector<int>& nodes, const std::vector<double>& half_thickness,
                                 const Mesh& mesh);

}  // namespace glisson::contact
