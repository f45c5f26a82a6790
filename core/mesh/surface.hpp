// The outer surface of a solid mesh: facets that belong to one element only, with their areas and normals.
#pragma once

#include <glisson/core/mesh/mesh.hpp>

#include <span>
#include <vector>

namespace glisson {

/// Facets with one owner, outward for elements in the orientation that Mesh asks for, ordered by element.
/// Triangles and quadrilaterals may mix. Needs 4 bytes per element facet and 4 per node besides the result.
/// [facet_count]
std::vector<Facet> outer_surface(const Mesh& mesh);

/// Half the cross product of two edges (triangle) or of the diagonals (quadrilateral): its length is the area
/// of a flat facet [m^2], its direction the normal by the right-hand rule.
Vec3<double> area_vector(const Facet& facet, std::span<const Vec3<double>> X);

/// Unit normal; the zero vector for a facet without area.
Vec3<double> facet_normal(const Facet& facet, std::span<const Vec3<double>> X);

/// Mean of the facet's nodes [m].
Vec3<double> facet_centre(const Facet& facet, std::span<const Vec3<double>> X);

/// Nodes of the facets, sorted, each once.
std::vector<int> nodes_of(std::span<const Facet> facets);

/// Nodes of the outer surface and of the triangles of membranes and shells, sorted, each once.
std::vector<int> outer_nodes(const Mesh& mesh);

}  // namespace glisson
