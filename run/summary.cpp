#include <glisson/run/summary.hpp>

#include <sys/resource.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include <glisson/models/output/atomic_file.hpp>
#include <glisson/version.hpp>

namespace glisson {
namespace {

using Json = nlohmann::ordered_json;

#if defined(__clang__)
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

Json energies_of(const Energies& e) {
  return {{"kinetic", e.kinetic},       {"strain", e.strain},   {"hourglass", e.hourglass},
          {"viscous", e.viscous},       {"damping", e.damping}, {"external", e.external},
          {"prescribed", e.prescribed}, {"contact", e.contact}, {"initial", e.initial},
          {"imbalance", e.imbalance()}};
}

Json step_of(const RunSummary& s) {
  Json step{{"count", s.steps},
            {"planned", s.report.planned_steps},
            {"dt_s", s.report.dt},
            {"stable_dt_s", s.report.stable_step},
            {"limited_by", s.report.limited_by},
            {"added_mass_share", s.report.added_mass}};
  if (!s.report.ending.empty()) step["ending"] = s.report.ending;
  if (s.residuals[0] != 0 || s.residuals[1] != 0) step["residuals"] = s.residuals;
  return step;
}

Json timings_of(const RunSummary& s) {
  const RunTimings& t = s.timings;
  const double steps = s.steps > 0 ? static_cast<double>(s.steps) : 1;
  const double elements = std::max(1, s.element_count + s.triangle_count);
  Json timings{{"read_s", t.read},
               {"set_up_s", t.set_up},
               {"stepping_s", t.stepping},
               {"output_s", t.output},
               {"total_s", t.total()},
               {"ms_per_step", 1e3 * t.stepping / steps},
               {"ns_per_element_and_step", 1e9 * t.stepping / steps / elements}};
  if (s.report.user_seconds > 0) timings["user_providers_s"] = s.report.user_seconds;
  return timings;
}

Json search_of(const ContactSearchReport& s) {
  return {{"volumes", s.volumes},
          {"searches", s.searches},
          {"looks", s.looks},
          {"volumes_refitted", s.volumes_refitted},
          {"subtrees_tested", s.subtrees_tested},
          {"triangle_pairs", s.triangle_pairs},
          {"candidates", s.candidates},
          {"refit_s", s.refit_seconds},
          {"pairs_s", s.pair_seconds},
          {"lists_s", s.list_seconds},
          {"search_s", s.search_seconds},
          {"touches_s", s.touch_seconds},
          {"forces_s", s.force_seconds},
          {"total_s", s.seconds}};
}

Json rigid_search_of(const ContactSearchReport& s) {
  Json its{{"nodes", s.candidates}, {"total_s", s.seconds}};
  if (s.volumes > 0) its["volumes"] = s.volumes;
  return its;
}

Json contacts_of(const std::vector<NamedContact>& contacts) {
  Json list = Json::array();
  for (const auto& [name, report] : contacts) {
    Json its{{"name", name},
             {"largest_depth", report.largest_depth},
             {"depth", report.depth},
             {"touches", report.node_count}};
    if (report.between_bodies || report.start_depth > 0) its["start_depth"] = report.start_depth;
    if (!report.between_bodies) its["force"] = {report.force.x, report.force.y, report.force.z};
    its["search"] = report.between_bodies ? search_of(report.search) : rigid_search_of(report.search);
    list.push_back(std::move(its));
  }
  return list;
}

Json as_json(const RunSummary& s) {
  Json j{{"program", "Glisson"}, {"version", version}, {"compiler", compiler}, {"status", s.status}};
  if (!s.message.empty()) j["message"] = s.message;
  j["model"] = {
      {"name", s.model}, {"units", s.units}, {"nodes", s.node_count}, {"elements", s.element_count}};
  if (s.triangle_count > 0) j["model"]["shell_triangles"] = s.triangle_count;
  if (!s.model_file.empty()) j["model"]["file"] = s.model_file;
  j["device"] = s.device;
  if (!s.device_choice.empty()) j["device_choice"] = s.device_choice;
  j["time_s"] = s.time;
  j["total_time_s"] = s.total_time;
  j["steps"] = step_of(s);
  j["largest_displacement"] = {{"value", s.largest_displacement}, {"node", s.largest_node}};
  j["energies"] = energies_of(s.energies);
  if (s.triangle_count > 0) j["energies"]["shell_strain"] = s.energies.shell;
  if (!s.contacts.empty()) j["contact"] = contacts_of(s.contacts);
  j["snapshots"] = s.snapshots;
  j["timings"] = timings_of(s);
  j["memory"] = {{"simulation_bytes", s.simulation_bytes}, {"peak_bytes", s.peak_bytes}};
  j["warnings"] = s.warnings;
  j["files"] = s.files;
  return j;
}

}  // namespace

void write_summary(const std::filesystem::path& path, const RunSummary& summary) {
  const auto text = as_json(summary).dump(2, ' ', false, Json::error_handler_t::replace);
  write_atomically(path, [&](std::ostream& out) { out << text << '\n'; });
}

std::size_t peak_memory() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace glisson
