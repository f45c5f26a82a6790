#include <glisson/app/contact_case.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glisson/core/mesh/box_mesh.hpp>

namespace glisson::app {
namespace {

constexpr double side = 0.1, gap = 1e-5, press = 0.01 * side, speed = 0.005;  // [m], [m/s]
constexpr double press_time = 0.02;                                           // [s]

void add_block(Model& model, int cells, const Vec3<double>& corner) {
  const Mesh block = box_mesh({cells, cells, cells}, {side, side, side}, Shape::tetrahedron, 0.1);
  const int first = model.mesh.element_count(), node = model.mesh.node_count();
  for (const auto& X : block.X) model.mesh.X.push_back(X + corner);
  for (int e = 0; e < block.element_count(); ++e) {
    std::array<int, 4> nodes{};
    std::transform(block.element(e).begin(), block.element(e).end(), nodes.begin(),
                   [node](int n) { return n + node; });
    model.mesh.add_element(Shape::tetrahedron, nodes);
  }
  Section section;
  section.name = first == 0 ? "lower" : "upper";
  section.formulation = Formulation::t4;
  section.material.law = "NH";
  section.material.parameters = {2000, 20000};
  section.material.density = 1000;
  section.elements.resize(static_cast<std::size_t>(block.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), first);
  model.sections.push_back(section);
}

std::vector<int> nodes_at_height(const Mesh& mesh, double z) {
  std::vector<int> nodes;
  for (int n = 0; n < mesh.node_count(); ++n)
    if (std::abs(mesh.X[static_cast<std::size_t>(n)].z - z) < 1e-9) nodes.push_back(n);
  return nodes;
}

}  // namespace

Model contact_model(int elements, double total_time, bool touch) {
  const int cells = std::max(2, static_cast<int>(std::lround(std::cbrt(elements / 12.0))));
  // of 6 n^2 + 2 surface nodes of a cube of n cells, (m + 1)^2 lie on m by m cells
  const double wanted = std::sqrt(0.05 * (6.0 * cells * cells + 2)) - 1;
  const double aside = side * (1 - std::max(wanted, 1.0) / cells), top = 2 * side + gap;
  Model model;
  model.name = "two blocks";
  model.units = "SI";
  add_block(model, cells, {});
  add_block(model, cells, {aside, aside, side + gap});
  const std::vector<int> upper = nodes_at_height(model.mesh, top);
  model.fixed.push_back({nodes_at_height(model.mesh, 0), all_axes});
  model.fixed.push_back({upper, 2});
  model.displacements.push_back(
      {upper, 4, {-press}, {LoadShape::table, 0, total_time, false, {{0, 0}, {press_time, 1}}}});
  model.displacements.push_back(
      {upper,
       1,
       {-speed * total_time},
       {LoadShape::table, 0, total_time, false, {{press_time, 0}, {total_time, 1}}}});
  model.contact.between_bodies = touch;
  model.time.total = total_time;
  model.time.damping = 20;
  return model;
}

nlohmann::ordered_json contact_per_step(const ContactReport& before, const ContactReport& after,
                                        std::int64_t steps, double step) {
  const ContactSearchReport &a = before.search, &b = after.search;
  const auto per_step = [&](double ContactSearchReport::*seconds) {
    return (b.*seconds - a.*seconds) / static_cast<double>(steps);
  };
  const double touches = per_step(&ContactSearchReport::touch_seconds),
               forces = per_step(&ContactSearchReport::force_seconds),
               search = per_step(&ContactSearchReport::search_seconds),
               all = per_step(&ContactSearchReport::seconds);
  fmt::print(
      "  contact: {:.1f} us a step ({:.1f} touches, {:.1f} forces, {:.1f} search, {:.1f} rest), {:.1f} % "
      "of the rest of the step; {} touches press, {} candidates, {} searches in {} steps\n",
      1e6 * all, 1e6 * touches, 1e6 * forces, 1e6 * search, 1e6 * (all - touches - forces - search),
      100 * all / (step - all), after.node_count, b.candidates, b.searches - a.searches, steps);
  return {{"ms_per_step", 1e3 * all},
          {"touches_ms", 1e3 * touches},
          {"forces_ms", 1e3 * forces},
          {"search_ms", 1e3 * search},
          {"share_of_rest_of_step", all / (step - all)},
          {"touches", after.node_count},
          {"candidates", b.candidates},
          {"searches", b.searches - a.searches},
          {"steps", steps}};
}

}  // namespace glisson::app
