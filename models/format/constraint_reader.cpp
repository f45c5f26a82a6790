#include <glisson/models/format/constraint_reader.hpp>

#include <glisson/core/mesh/triangles.hpp>
#include <glisson/models/format/suggest.hpp>

#include <algorithm>

namespace glisson::detail {

void ConstraintReader::require_any(std::size_t count) {
  selected_count_ = count;
  if (nothing_) reader_.warn(element_, "it acts on nothing (a count of 0) and has been left out");
  if (count == 0 && !nothing_)
    element_.fail(
        "the selection is empty, so it would act on nothing; check the direction, the region and the units "
        "of its numbers, or remove it");
}

std::vector<int> ConstraintReader::nodes() {
  for (const auto name : {"NumFaces", "FaceType"})
    if (const auto attribute = element_.attribute(name))
      element_.fail(attribute->line,
                    std::string(name) + " belongs to Pressure and Traction; this one acts on nodes");
  const Choice choice = read_choice(reader_, element_, mesh_.mesh());
  nothing_ = choice.empty_on_purpose;
  if (!nothing_ && !choice.list && choice.filter.parts.empty())
    element_.fail(
        "it does not say on which nodes it acts; add NumNodes and <Nodes>, or <Normal>, <Box>, <Label>, ...");
  std::vector<int> nodes;
  if (choice.list) {
    const auto mask = mesh_.node_mask(choice.filter);
    std::vector<char> seen(mask.size(), 0);
    listed_count_ = choice.list->size();
    std::size_t twice = 0;
    for (std::size_t i = 0; i < choice.list->size(); ++i) {
      const int n = (*choice.list)[i];
      auto& met = seen[static_cast<std::size_t>(n)];
      twice += met != 0;
      if (mask[static_cast<std::size_t>(n)] != 0 && met == 0) {
        nodes.push_back(n);
        listed_.push_back(i);
      }
      met = 1;
    }
    if (twice > 0)
      reader_.warn(element_, std::to_string(twice) + " nodes are listed again; each counts once");
  } else if (!nothing_) {
    nodes = mesh_.nodes(choice.filter);
  }
  require_any(nodes.size());
  return nodes;
}

std::vector<Facet> ConstraintReader::facets() {
  const auto faces = element_.child("Faces");
  const auto count = element_.attribute("NumFaces");
  const bool all =
      count != nullptr && (count->value == "all" || element_.integer_attribute("NumFaces").value_or(0) < 0);
  if (all && faces != nullptr) faces->fail("a list stands beside NumFaces=\"all\"; remove one of them");
  if (faces != nullptr) return listed_facets(count != nullptr ? count->value : "");
  Choice choice = read_choice(reader_, element_, mesh_.mesh());
  if (count != nullptr && count->value == "0" && choice.filter.parts.empty()) nothing_ = true;
  if (count != nullptr && !all && !nothing_ && choice.filter.parts.empty())
    element_.fail("NumFaces=\"" + count->value + "\" needs the element <Faces> inside it");
  const Selection filter = facet_filter(std::move(choice));
  if (!nothing_ && !all && filter.parts.empty())
    element_.fail(
        "it does not say on which facets it acts; add NumFaces=\"all\", <Faces>, <Normal>, <Box>, <Label>, "
        "...");
  auto facets = nothing_ ? std::vector<Facet>() : mesh_.facets(filter);
  require_any(facets.size());
  return facets;
}

std::vector<Facet> ConstraintReader::listed_facets(const std::string& count) {
  const auto& faces = *element_.child("Faces");
  if (element_.required_attribute("FaceType") == "Shell") return listed_triangles(faces);
  const std::size_t width = element_.required_attribute("FaceType") == "Tri" ? 3 : 4;
  const auto nodes = index_list(faces, {}, mesh_.mesh().node_count(), "nodes");
  if (nodes.size() % width != 0)
    faces.fail("it lists " + std::to_string(nodes.size()) + " nodes, which is not a multiple of " +
               std::to_string(width) + " for this FaceType");
  if (!count.empty() && count != std::to_string(nodes.size() / width))
    faces.fail("it lists " + std::to_string(nodes.size() / width) + " faces, but NumFaces=\"" + count + "\"");
  std::vector<Facet> facets(nodes.size() / width);
  for (std::size_t i = 0; i < nodes.size(); ++i) facets[i / width].nodes[i % width] = nodes[i];
  for (const auto& facet : facets)
    for (std::size_t a = 0; a < width; ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (facet.nodes[a] == facet.nodes[b])
          faces.fail("a face names node " + std::to_string(facet.nodes[a]) + " twice");
  listed_count_ = facets.size();
  for (std::size_t i = 0; i < facets.size(); ++i) listed_.push_back(i);
  require_any(facets.size());
  return facets;
}

/// Of shells, by their numbers.
std::vector<Facet> ConstraintReader::listed_triangles(const XmlElement& faces) {
  const auto all = facets_of(mesh_.mesh().triangles);
  std::vector<Facet> facets;
  for (const int e : index_list(faces, element_.integer_attribute("NumFaces"), static_cast<int>(all.size()),
                                "shell triangles"))
    facets.push_back(all[static_cast<std::size_t>(e)]);
  listed_count_ = facets.size();
  for (std::size_t i = 0; i < facets.size(); ++i) listed_.push_back(i);
  require_any(facets.size());
  return facets;
}

Axes ConstraintReader::axes() const {
  const auto attribute = element_.attribute("DOF");
  if (attribute == nullptr || attribute->value == "all") return all_axes;
  return 1U << static_cast<unsigned>(attribute->value[0] - '0');  // the grammar allows 0, 1, 2
}

// A list in the file keeps its order: value i belongs to entry i of it, also where a restriction drops
// entries.
std::vector<double> ConstraintReader::values(const XmlElement& element, std::size_t width) const {
  const auto& type = element.required_attribute("Type");
  if (type == "UNIFORM") return element.numbers(width);
  const std::size_t count = listed_.empty() ? selected_count_ : listed_count_;
  const auto all = type == "FILE" ? reader_.numbers_in_file(element, element.required_text(), width * count)
                                  : element.numbers();
  if (all.size() != width * count)
    element.fail("it holds " + std::to_string(all.size()) + " values where " + std::to_string(width * count) +
                 " are needed, " + std::to_string(width) + " for each of " + std::to_string(count) +
                 " selected items");
  if (listed_.empty() || listed_.size() == listed_count_) return all;
  std::vector<double> kept;
  for (const auto i : listed_)
    for (std::size_t c = 0; c < width; ++c) kept.push_back(all[i * width + c]);
  return kept;
}

std::vector<Vec3<double>> ConstraintReader::vectors(const XmlElement& element) const {
  const auto flat = values(element, 3);
  std::vector<Vec3<double>> result;
  for (std::size_t i = 0; i + 2 < flat.size(); i += 3) result.push_back({flat[i], flat[i + 1], flat[i + 2]});
  return result;
}

namespace {

LoadShape shape_named(const std::string& name) {  // the grammar allows these six
  if (name == "POLY345") return LoadShape::poly345;
  if (name == "RAMP") return LoadShape::ramp;
  if (name == "RAMPHOLD") return LoadShape::ramp_hold;
  if (name == "STEP") return LoadShape::step;
  if (name == "HILLY") return LoadShape::hilly;
  return LoadShape::table;
}

std::vector<std::pair<double, double>> read_table(const XmlElement& element) {
  const auto values = element.numbers();
  if (values.empty() || values.size() % 2 != 0)
    element.fail("a table is pairs of time and value, but it holds " + std::to_string(values.size()) +
                 " numbers");
  std::vector<std::pair<double, double>> table;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    if (!table.empty() && values[i] <= table.back().first)
      element.fail("the times of a table must increase, but entry " + std::to_string(i / 2) +
                   " is not after the one before it");
    table.emplace_back(values[i], values[i + 1]);
  }
  return table;
}

}  // namespace

LoadCurve read_curve(const Reader& reader, const XmlElement& element, const char* shape_attribute,
                     const char* table_element, std::optional<LoadShape> otherwise) {
  LoadCurve curve;
  const auto shape = element.attribute(shape_attribute);
  const auto table = element.child(table_element);
  if (shape == nullptr && !otherwise && table == nullptr) element.required_attribute(shape_attribute);
  curve.shape = shape != nullptr   ? shape_named(shape->value)
                : table != nullptr ? LoadShape::table
                                   : otherwise.value_or(LoadShape::ramp);
  if ((curve.shape == LoadShape::table) != (table != nullptr))
    element.fail(std::string(shape_attribute) + "=\"TABLE\" and the element <" + table_element +
                 "> belong together; one of them is missing");
  if (table != nullptr) curve.table = read_table(*table);
  curve.start = element.number_attribute("StartTime").value_or(0);
  curve.end = element.number_attribute("EndTime").value_or(std::max(reader.total_time, curve.start));
  if (curve.end < curve.start) element.fail("EndTime is before StartTime");
  const auto release = element.attribute("Release");
  curve.release_after_end = release != nullptr && release->value == "1";
  return curve;
}

}  // namespace glisson::detail
