#include <glisson/viz/series.hpp>

#include <tinyxml2.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/formats.hpp>

namespace glisson::viz {
namespace fs = std::filesystem;
namespace {

std::string bytes_of(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(ErrorKind::input, "this is a directory; name the .pvd file in it", {path});
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorKind::input, "the file cannot be opened. Check the name.", {path});
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw Error(ErrorKind::input, "the file cannot be read", {path});
  return bytes;
}

bool ends_with(const std::string& path, std::string_view extension) {
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower.ends_with(extension);
}

void require_drawable(const std::string& path) {
  for (const char* extension : {".vtu", ".vtp", ".vtk"})
    if (ends_with(path, extension)) return;
  throw Error(ErrorKind::input, "only .pvd, .vtu, .vtp and .vtk files can be drawn", {path});
}

void add_entry(const tinyxml2::XMLElement& entry, const std::string& path, std::vector<Step>& steps) {
  const Place place{path, entry.GetLineNum(), "DataSet"};
  const char* file = entry.Attribute("file");
  if (file == nullptr) throw Error(ErrorKind::input, "the attribute file is missing", place);
  double time = 0;
  const auto status = entry.QueryDoubleAttribute("timestep", &time);
  if (status == tinyxml2::XML_WRONG_ATTRIBUTE_TYPE || !std::isfinite(time))
    throw Error(ErrorKind::input, "timestep is not a number", place);
  const std::string full = (fs::path(path).parent_path() / file).string();
  require_drawable(full);
  const auto same = [&](const Step& s) { return s.time == time; };
  auto found = std::find_if(steps.begin(), steps.end(), same);
  if (found == steps.end()) found = steps.insert(steps.end(), Step{time, {}});
  found->files.push_back(full);
}

void check_nodes(const detail::RawMesh& raw, const std::string& path) {
  const auto count = static_cast<int>(raw.X.size());
  for (std::size_t c = 0; c < raw.cell_count(); ++c) {
    for (const int node : raw.cell(c))
      if (node < 0 || node >= count)
        throw Error(ErrorKind::input,
                    "cell " + std::to_string(c) + " has the node " + std::to_string(node) + " of " +
                        std::to_string(count) + "; the file is damaged",
                    {path});
    const int needed = detail::nodes_of_cell(raw.code[c]);
    if (needed > 0 && raw.cell(c).size() != static_cast<std::size_t>(needed))
      throw Error(ErrorKind::input, "cell " + std::to_string(c) + " has a wrong number of nodes", {path});
  }
}

}  // namespace

std::vector<Step> read_series(const std::string& path) {
  if (!ends_with(path, ".pvd")) {
    bytes_of(path);
    require_drawable(path);
    return {{0, {path}}};
  }
  const std::string text = bytes_of(path);
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    throw Error(ErrorKind::input, "this is not well-formed XML; the file is truncated or damaged",
                {path, document.ErrorLineNum(), {}});
  const auto* root = document.RootElement();
  const auto* list = root == nullptr ? nullptr : root->FirstChildElement("Collection");
  if (list == nullptr) throw Error(ErrorKind::input, "it holds no Collection: this is no PVD file", {path});
  std::vector<Step> steps;
  for (const auto* e = list->FirstChildElement("DataSet"); e != nullptr; e = e->NextSiblingElement("DataSet"))
    add_entry(*e, path, steps);
  if (steps.empty()) throw Error(ErrorKind::input, "it lists no snapshot; did the run end at once?", {path});
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.time < b.time; });
  return steps;
}

std::vector<detail::RawMesh> read_step(const Step& step) {
  std::vector<detail::RawMesh> parts;
  for (const auto& path : step.files) {
    const std::string text = bytes_of(path);
    parts.push_back(ends_with(path, ".vtk") ? detail::parse_vtk(text, path)
                                            : detail::parse_vtk_xml(text, path));
    check_nodes(parts.back(), path);
  }
  const bool empty =
      std::all_of(parts.begin(), parts.end(), [](const auto& p) { return p.cell_count() == 0; });
  if (empty) throw Error(ErrorKind::input, "it holds no cells, so there is nothing to draw", {step.files[0]});
  return parts;
}

std::vector<int> faces_of_parts(const Step& step) {
  std::vector<int> places;
  for (const auto& file : step.files) {
    const fs::path path(file), faces = path.parent_path() / (path.stem().string() + "_faces.vtp");
    const auto found = std::find(step.files.begin(), step.files.end(), faces.string());
    const bool is_mid = ends_with(file, ".vtp") && found != step.files.end();
    places.push_back(is_mid ? static_cast<int>(found - step.files.begin()) : -1);
  }
  return places;
}

int step_index(int wanted, std::size_t count) {
  const int steps = static_cast<int>(count);
  if (wanted >= steps || wanted < -steps)
    throw Error(ErrorKind::usage, "There is no step " + std::to_string(wanted) + ": the results hold " +
                                      std::to_string(steps) + " snapshots, 0 to " +
                                      std::to_string(steps - 1) + " (or -1 for the last).");
  return wanted < 0 ? wanted + steps : wanted;
}

RunFacts facts_beside(const std::string& results) {
  std::ifstream in(fs::path(results).parent_path() / "summary.json");
  const auto json = nlohmann::json::parse(in, nullptr, false);
  RunFacts facts;
  if (!json.is_object() || !json.contains("model") || !json["model"].is_object()) return facts;
  const auto text = [&](const char* key) {
    const auto found = json["model"].find(key);
    return found != json["model"].end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  return {text("units"), text("file")};
}

}  // namespace glisson::viz
