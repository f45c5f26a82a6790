#include <glisson/cpu/solids/patch_builder.hpp>

#include <algorithm>
#include <cmath>

#include <glisson/cpu/solids/columns.hpp>
#include <glisson/cpu/solids/element_constants.hpp>
#include <glisson/cpu/solids/strips.hpp>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Layout layout_of(Kind kind) {
  const int constants = constant_count_of(kind);
  switch (kind) {
    case Kind::t4:
    case Kind::t4anp:
      return {strip_corners, strip_length, constants, 1, 256, 1};
    case Kind::h8_full:
      return {8, 1, constants, 8, 256, 8};
    default:
      return {column_corners, column_length, constants, 1, 144, 4};
  }
}

PatchBuilder::PatchBuilder(const Model& model, const Numbering& numbering, ElementParameters& parameters,
                           int width, Arena& arena)
    : model_(model),
      numbering_(numbering),
      parameters_(parameters),
      width_(width),
      arena_(arena),
      lists_(model.mesh.node_count(), width),
      local_(model.mesh.X.size(), -1) {
  for (const Section& section : model.sections)
    for (const int e : section.elements)
      for (const int n : model.mesh.element(e)) lists_.count(numbering.internal_of_user[at(n)]);
}

void PatchBuilder::add(Block& block, std::vector<int> elements, std::vector<Patch>& patches) {
  const Layout layout = layout_of(block.kind);
  const auto items_per_patch = at(layout.items_per_patch);
  const std::size_t window = items_per_patch * at(layout.elements_per_item);
  block.first_patch = static_cast<int>(patches.size());
  std::vector<int> candidates, left_over;
  std::size_t next = 0;
  while (next < elements.size() || !left_over.empty()) {
    std::sort(left_over.begin(), left_over.end());
    candidates = left_over;
    const std::size_t old = candidates.size(), fresh = std::min(window - old, elements.size() - next);
    candidates.insert(candidates.end(), elements.begin() + static_cast<std::ptrdiff_t>(next),
                      elements.begin() + static_cast<std::ptrdiff_t>(next + fresh));
    next += fresh;
    std::vector<Item> items = items_of(layout, candidates);
    // Strips and columns that came out short get a second chance with the next elements, but only one: else
    // they would stay for ever.
    const std::span<const int> waited(candidates.data(), old);
    for (Item& item : items) {
      auto has_waited = [&](int e) { return std::binary_search(waited.begin(), waited.end(), e); };
      item.urgency = std::any_of(item.element.begin(), item.element.end(), has_waited) ? 100 : item.corners;
    }
    left_over.clear();
    if (items.size() > items_per_patch && next < elements.size()) {
      std::stable_sort(items.begin(), items.end(),
                       [&](const Item& a, const Item& b) { return a.urgency > b.urgency; });
      for (std::size_t i = items_per_patch; i < items.size(); ++i)
        for (const int e : items[i].element)
          if (e >= 0) left_over.push_back(e);
      items.resize(items_per_patch);
    }
    add_patch(block, items, patches);
  }
  block.patch_count = static_cast<int>(patches.size()) - block.first_patch;
}

/// Corners of elements as places in `internal`, which gets their internal numbers.
template <std::size_t corners>
std::vector<std::array<int, corners>> PatchBuilder::in_local_numbers(std::span<const int> elements,
                                                                     std::vector<int>& internal) {
  std::vector<std::array<int, corners>> result;
  result.reserve(elements.size());
  for (const int e : elements) {
    std::array<int, corners> nodes;
    for (std::size_t a = 0; a < corners; ++a) {
      const int n = numbering_.internal_of_user[at(model_.mesh.element(e)[a])];
      if (local_[at(n)] < 0) {
        local_[at(n)] = static_cast<int>(internal.size());
        internal.push_back(n);
      }
      nodes[a] = local_[at(n)];
    }
    result.push_back(nodes);
  }
  for (const int n : internal) local_[at(n)] = -1;
  return result;
}

std::vector<Item> PatchBuilder::items_of(const Layout& layout, std::span<const int> elements) {
  std::vector<int> internal;
  std::vector<Item> items;
  auto add = [&](const auto& nodes, const auto& places, int corners) {
    Item item;
    item.corners = corners;
    for (std::size_t k = 0; k < nodes.size(); ++k) item.node[k] = internal[at(nodes[k])];
    for (std::size_t j = 0; j < places.size(); ++j)
      item.element[j] = places[j] < 0 ? -1 : elements[at(places[j])];
    items.push_back(item);
  };
  if (layout.new_corners == 1) {
    for (const Strip<4>& s : build_strips<4>(in_local_numbers<4>(elements, internal)))
      add(s.node, s.element, s.corners());
  } else if (layout.elements_per_item > 1) {
    for (const Column& c : build_columns(in_local_numbers<8>(elements, internal)))
      add(c.node, c.element, c.corners());
  } else {
    int place = 0;
    for (const auto& nodes : in_local_numbers<8>(elements, internal)) add(nodes, std::array{place++}, 8);
  }
  return items;
}

bool PatchBuilder::same_parameters(std::span<const Item> items) {
  const int first = items[0].element[0], section = parameters_.section_of(first);
  const std::vector<float> values = parameters_(first).parameters;
  for (const Item& item : items)
    for (const int e : item.element) {
      if (e < 0 || (parameters_.section_of(e) == section && parameters_.uniform(section))) continue;
      if (parameters_(e).parameters != values) return false;
    }
  return true;
}

void PatchBuilder::write_elements(const Block& block, const Layout& layout, std::span<const Item> items,
                                  bool uniform, const Patch& patch, const Arrays& to) {
  const auto W = at(width_);
  const std::vector<float> first = parameters_(items[0].element[0]).parameters;  // also for empty lanes
  const std::size_t places = at(patch.tiles * layout.elements_per_item), count = first.size();
  for (std::size_t i = 0; i < (uniform ? 1 : places) * count * W; ++i)
    to.parameters[i] = first[i / W % count];
  if (to.element) std::fill_n(to.element, places * W, -1);
  std::vector<double> constants;
  std::array<Vec3<double>, 8> X;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = 0; j < at(layout.elements_per_item); ++j) {
      const int e = items[i].element[j];
      if (e < 0) continue;
      const std::size_t place = i / W * at(layout.elements_per_item) + j, lane = i % W;
      const ElementParameters::Values& values = parameters_(e);
      if (!uniform)
        for (std::size_t k = 0; k < count; ++k)
          to.parameters[(place * count + k) * W + lane] = values.parameters[k];
      for (std::size_t a = 0; a < at(layout.corners_of_element(layout.corners)); ++a) {
        const int n = items[i].node[a + j * at(layout.new_corners)];
        X[a] = model_.mesh.X[at(numbering_.user_of_internal[at(n)])];
      }
      element_constants(block.kind, X, values.stiffness, constants);
      for (std::size_t c = 0; c < constants.size(); ++c)
        to.constants[(place * constants.size() + c) * W + lane] = static_cast<float>(constants[c]);
      if (to.element) to.element[place * W + lane] = e;
    }
}

void PatchBuilder::add_patch(const Block& block, std::span<const Item> items, std::vector<Patch>& patches) {
  const Layout layout = layout_of(block.kind);
  const PatchOutline outline = lists_.outline(layout, items);
  Patch patch = outline.patch;
  const bool uniform = same_parameters(items);
  const int places = patch.tiles * layout.elements_per_item, parameter_count = block.law->parameter_count;
  const auto W = at(width_);
  patch.parameter_stride = uniform ? 0 : parameter_count * width_;
  MemoryPlan plan;
  const std::size_t node = plan.add<int>(outline.nodes.size()), run = plan.add<SumRun>(outline.runs.size()),
                    row = plan.add<std::uint16_t>(outline.rows),
                    corner = plan.add<std::uint16_t>(at(patch.tiles * layout.corners) * W),
                    element = plan.add<int>(block.terms() > 0 ? at(places) * W : 0),
                    parameters = plan.add<float>(at(uniform ? 1 : places) * at(parameter_count) * W),
                    history = plan.add<float>(at(places * layout.points) * at(block.terms()) * 6 * W),
                    constants = plan.add<float>(at(places) * at(layout.constants) * W);
  std::byte* memory = arena_.allocate(plan.bytes());
  auto* its_nodes = reinterpret_cast<int*>(memory + node);
  auto* its_runs = reinterpret_cast<SumRun*>(memory + run);
  auto* its_rows = reinterpret_cast<std::uint16_t*>(memory + row);
  auto* its_corners = reinterpret_cast<std::uint16_t*>(memory + corner);
  const Arrays arrays{block.terms() > 0 ? reinterpret_cast<int*>(memory + element) : nullptr,
                      reinterpret_cast<float*>(memory + parameters),
                      reinterpret_cast<float*>(memory + constants)};
  patch.history = reinterpret_cast<float*>(memory + history);
  lists_.write(outline, layout, items, {its_nodes, its_runs, its_rows, its_corners});
  write_elements(block, layout, items, uniform, patch, arrays);
  patch.node = its_nodes;
  patch.run = its_runs;
  patch.row = its_rows;
  patch.corner = its_corners;
  patch.element = arrays.element;
  patch.parameters = arrays.parameters;
  patch.constants = arrays.constants;
  patches.push_back(patch);
}

}  // namespace glisson::patches
