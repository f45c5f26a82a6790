// The tables 5.1 and 5.2 of Johnsen 2016 from generated geometry: what surface-normal cones and update nodes
// save. Prints JSON:
//   glisson_contact_bench [CASE...]      C, Zipper, "Ball-slab", "Two spheres", "Rigid bar"; none: all
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <bench/contact_cases.hpp>
#include <bench/hierarchy_counts.hpp>
#include <glisson/run/make_simulation.hpp>

namespace glisson::bench {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(contact::ConeRule cones) {
  switch (cones) {
    case contact::ConeRule::provot:
      return "Provot";
    case contact::ConeRule::provot_or_child:
      return "Provot or child";
    default:
      return "narrowest";
  }
}

Json json_of(const HierarchyCounts& c) {
  return {{"hierarchy", "AABB" + std::to_string(c.arity)},
          {"cones", name_of(c.cones)},
          {"volumes", c.volumes()},
          {"update_nodes", c.update_nodes()},
          {"subtrees_per_step", c.per_step(c.subtrees)},
          {"refitted_per_step", c.per_step(c.refitted)},
          {"translated_per_step", c.per_step(c.translated)},
          {"update_ms_per_step", 1e3 * c.per_step(c.update_seconds)},
          {"exhaustive_ms_per_step", 1e3 * c.per_step(c.exhaustive_seconds)}};
}

/// What the contact of the engine does itself, which refits everything, but only when it searches.
Json engine_of(const AnySimulation& simulation, int steps) {
  Json list = Json::array();
  for (const auto& [name, report] : simulation.contacts())
    list.push_back({{"name", name},
                    {"largest_depth", report.largest_depth},
                    {"touches_at_end", report.node_count},
                    {"searches", report.search.searches},
                    {"refitted_per_step", double(report.search.volumes_refitted) / steps},
                    {"subtrees_per_step", double(report.search.subtrees_tested) / steps},
                    {"search_s", report.search.search_seconds},
                    {"contact_s", report.search.seconds}});
  return list;
}

Json measured(const ContactCase& its) {
  const Mesh& mesh = its.model.mesh;
  const auto triangles = surface_triangles(mesh);
  std::vector<HierarchyCounts> all;
  for (const int arity : {2, 4})
    for (const auto cones :
         {contact::ConeRule::narrowest, contact::ConeRule::provot, contact::ConeRule::provot_or_child})
      all.emplace_back(triangles, mesh.X, arity, cones);
  const auto simulation = make_simulation(its.model);
  follow_run(mesh, *simulation, all);
  const int steps = all[0].steps;
  Json result{
      {"case", its.name}, {"facets", triangles.size()}, {"elements", mesh.element_count()}, {"steps", steps}};
  for (const HierarchyCounts& one : all) result["hierarchies"].push_back(json_of(one));
  result["engine"] = engine_of(*simulation, steps);
  return result;
}

}  // namespace
}  // namespace glisson::bench

int main(int argc, char** argv) {
  using namespace glisson::bench;
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  try {
    Json all = Json::array();
    for (const ContactCase& its :
         {closing_c(), closing_zipper(), ball_and_slab(), two_spheres(), rigid_bar()})
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), its.name) != wanted.end())
        all.push_back(measured(its));
    std::printf("%s\n", Json{{"results", all}}.dump(1).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
