// ContactSurface: a rigid surface mesh, inline or from a file, that stands or moves.
#include <glisson/models/format/pose_table.hpp>

#include <glisson/core/mesh/surface.hpp>

#include <algorithm>

namespace glisson::detail {
std::vector<Facet> facet_list(const XmlElement& element, int node_count) {
  const std::string& type = element.required_attribute("Type");
  if (type != "T3" && type != "Q4")
    element.fail("Type=\"" + type + "\" is not one of a surface; use T3 or Q4");
  const auto corners = static_cast<std::size_t>(type == "T3" ? 3 : 4);
  const auto entries = element.integers();
  if (const auto wanted = element.integer_attribute("NumEls"); wanted && *wanted <= 0)
    element.fail("NumEls is " + std::to_string(*wanted) + ", but a surface needs a facet");
  const std::int64_t fit = static_cast<std::int64_t>(entries.size() / corners);
  const std::int64_t count =
      element.integer_attribute("NumEls").value_or(static_cast<int>(std::max<std::int64_t>(fit, 1)));
  if (static_cast<std::int64_t>(entries.size()) != count * static_cast<std::int64_t>(corners))
    element.fail("it holds " + std::to_string(entries.size()) + " numbers, but " + std::to_string(count) +
                 " facets (NumEls) of " + type + " need " +
                 std::to_string(count * static_cast<std::int64_t>(corners)));
  std::vector<Facet> facets;
  for (std::size_t i = 0; i < entries.size(); i += corners) {
    Facet facet;
    for (std::size_t a = 0; a < corners; ++a) {
      const int n = entries[i + a];
      if (n < 0 || n >= node_count)
        element.fail("facet " + std::to_string(i / corners) + " uses node " + std::to_string(n) +
                     ", but there are only nodes 0 to " + std::to_string(node_count - 1));
      facet.nodes[a] = n;
    }
    facets.push_back(facet);
  }
  return facets;
}

namespace {

/// Of the first number of each facet.
std::vector<int> facet_lines(const XmlElement& elements, const std::vector<Facet>& facets) {
  std::vector<int> lines;
  int token = 0;
  for (const XmlText& chunk : elements.texts)
    for_each_token(chunk, [&](std::string_view, int line) {
      if (token++ % facets[0].node_count() == 0) lines.push_back(line);
    });
  return lines;
}

void read_surface(const Reader& reader, const XmlElement& element, RigidSurface& to) {
  for (const auto name : {"SurfaceFile", "VTKSurface"})
    if (const auto file = element.child(name)) {
      for (const auto other_name : {"Nodes", "VTKSurface"})
        if (const auto other = element.child(other_name); other != nullptr && other != file)
          other->fail("a second geometry: <" + std::string(name) + "> is there too; keep one of them");
      to.surface = surface_from_file(reader, *file, &to.file);
      transform_as_told(*file, to.surface.X);
      return;
    }
  to.file = *element.file;
  to.surface.X = read_positions(element.required_child("Nodes"));
  const auto& elements = element.required_child("Elements");
  elements.required_attribute("NumEls");
  to.surface.facets = facet_list(elements, static_cast<int>(to.surface.X.size()));
  to.facet_lines = facet_lines(elements, to.surface.facets);
}

/// SlaveNodes counts the nodes of the outer surface in rising order, as NiftySim does; SlvNodes those of the
/// mesh.
std::vector<int> read_slaves(const XmlElement& element, const Mesh& mesh) {
  std::vector<int> nodes;
  for (const auto name : {"SlaveNodes", "SlvNodes"})
    if (const auto slaves = element.child(name); slaves != nullptr && !slaves->has_text())
      slaves->fail("the list of nodes is empty; without the element all surface nodes may touch the surface");
  if (const auto slaves = element.child("SlaveNodes")) {
    const auto surface = nodes_of(outer_surface(mesh));
    for (const int i : index_list(*slaves, slaves->integer_attribute("NumNodes"),
                                  static_cast<int>(surface.size()), "surface nodes"))
      nodes.push_back(surface[static_cast<std::size_t>(i)]);
  }
  if (const auto slaves = element.child("SlvNodes"))
    for (const int n : index_list(*slaves, slaves->integer_attribute("NumNodes"), mesh.node_count(), "nodes"))
      nodes.push_back(n);
  return nodes;
}

void read_pose_motion(const Reader& reader, const XmlElement& motion, RigidSurface& surface) {
  surface.poses = read_poses(reader, motion);
  if (const auto centre = motion.child("Centre")) surface.centre = vector_of(*centre);
  if (!(surface.poses.back().time > 0) || !(surface.poses.front().time < reader.total_time))
    reader.warn(motion, "all its times lie outside of the run, so the surface stands still");
}

void read_motion(const Reader& reader, const XmlElement& motion, RigidSurface& surface) {
  if (motion.required_attribute("Type") == "Poses") return read_pose_motion(reader, motion, surface);
  if (const auto attribute = motion.attribute("Rotation"))
    motion.fail(attribute->line, "the attribute Rotation belongs to Type=\"Poses\"");
  for (const auto name : {"TableFile", "Centre"})
    if (const auto child = motion.child(name)) child->fail("it belongs to a Motion with Type=\"Poses\"");
  surface.motion = read_curve(reader, motion, "LoadShape", "Table", LoadShape::ramp);
  if (motion.required_attribute("Type") == "Translation") {
    surface.displacement = vector_of(motion);
    return;
  }
  const auto v = motion.numbers(6);
  surface.angles = {v[0], v[1], v[2]};
  surface.centre = {v[3], v[4], v[5]};
}

}  // namespace

void read_contact_surfaces(const Reader& reader, const XmlElement& model, Part& part) {
  const auto response = model.required_child("SystemParams").child("ContactResponse");
  const PenaltyShare common = response != nullptr ? read_response(*response, "Type", {}) : PenaltyShare();
  for (const auto& element : model.children) {
    if (!element.is("ContactSurface")) continue;
    RigidSurface surface;
    surface.name = "ContactSurface at line " + std::to_string(element.line);
    read_surface(reader, element, surface);
    if (const auto friction = element.child("FrictionCoefficient"))
      surface.friction = not_negative(*friction);
    if (const auto distance = element.child("RateConstraintDistance"))
      surface.distance = not_negative(*distance);
    surface.penalty = read_response(element, "Response", common);
    surface.nodes = read_slaves(element, part.model.mesh);
    if (const auto motion = element.child("Motion")) read_motion(reader, *motion, surface);
    part.model.surfaces.push_back(std::move(surface));
  }
}

}  // namespace glisson::detail
