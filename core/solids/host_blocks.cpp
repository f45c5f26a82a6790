#include <glisson/core/solids/host_blocks.hpp>

#include <algorithm>
#include <cstring>
#include <functional>

#include <glisson/core/base/error.hpp>
#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/patch_bodies.hpp>
#include <glisson/core/solids/section_laws.hpp>

namespace glisson {
namespace {

bool same_terms(const std::vector<PronyTerm>& a, const std::vector<PronyTerm>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PronyTerm& x, const PronyTerm& y) {
    return x.alpha == y.alpha && x.tau == y.tau;
  });
}

template <class R>
bool belongs(const HostBlock<R>& block, const Section& section) {
  const MaterialSpec& m = section.material;
  const std::size_t isochoric = static_cast<std::size_t>(block.isochoric_count);
  if (block.formulation != section.formulation || block.law != m.law || isochoric != m.isochoric.size())
    return false;
  std::vector<PronyTerm> terms = m.isochoric;
  terms.insert(terms.end(), m.volumetric.begin(), m.volumetric.end());
  return same_terms(block.prony, terms);
}

template <class R>
HostBlock<R> empty_block(const Section& section) {
  HostBlock<R> block;
  block.formulation = section.formulation;
  block.law = section.material.law;
  block.prony = section.material.isochoric;
  block.prony.insert(block.prony.end(), section.material.volumetric.begin(),
                     section.material.volumetric.end());
  block.isochoric_count = static_cast<int>(section.material.isochoric.size());
  block.nodes_per_element = node_count_of(shape_of(section.formulation));
  block.point_count = section.formulation == Formulation::h8_full ? H8Full::point_count : 1;
  return block;
}

template <class E, class R>
void append_constants(const typename E::template Constants<double>& exact, std::vector<std::byte>& bytes) {
  constexpr int count = sizeof(exact) / sizeof(double);
  static_assert(count == E::constant_count);
  double values[count];
  std::memcpy(values, &exact, sizeof exact);
  R rounded[count];
  for (int i = 0; i < count; ++i) rounded[i] = R(values[i]);
  const auto* first = reinterpret_cast<const std::byte*>(rounded);
  bytes.insert(bytes.end(), first, first + sizeof rounded);
}

template <class E>
bool stores(StoredConstants stored) {
  return stored == StoredConstants::all || !forms_constants<E>;
}

template <class R>
void append_tetrahedron(HostBlock<R>& block, const Vec3<double> (&X)[4], StoredConstants stored) {
  const bool averaged = block.formulation == Formulation::t4anp;
  if (!stores<T4>(stored) && !averaged) return;
  const auto c = T4::make(X);
  if (stores<T4>(stored)) append_constants<T4, R>(c, block.constants);
  if (averaged) block.volumes.push_back(R(c.volume));
}

template <class R>
void append_element(HostBlock<R>& block, const Mesh& mesh, int e, double stiffness, StoredConstants stored) {
  Vec3<double> X[8];
  const auto nodes = mesh.element(e);
  for (std::size_t a = 0; a < nodes.size(); ++a) X[a] = mesh.X[static_cast<std::size_t>(nodes[a])];
  if (block.nodes_per_element == 4) {
    append_tetrahedron(block, {X[0], X[1], X[2], X[3]}, stored);
  } else if (block.formulation == Formulation::h8_full) {
    append_constants<H8Full, R>(H8Full::make(X), block.constants);
  } else {
    const bool fixed = block.formulation == Formulation::h8_fixed;
    if (stores<H8>(stored)) append_constants<H8, R>(H8::rest_constants(X, stiffness, fixed), block.constants);
    block.hourglass.push_back(R(stiffness));
  }
}

/// Where each element of the mesh stands: its section, its place there, its block and its first history
/// value.
struct Location {
  int section = -1, place = 0, block = -1;
  std::size_t history = 0;
};

template <class R>
std::vector<Location> locate(const Model& model, std::vector<HostBlock<R>>& blocks) {
  std::vector<Location> locations(static_cast<std::size_t>(model.mesh.element_count()));
  std::size_t history = 0;
  for (std::size_t s = 0; s < model.sections.size(); ++s) {
    const Section& section = model.sections[s];
    auto block =
        std::find_if(blocks.begin(), blocks.end(), [&](const auto& b) { return belongs(b, section); });
    if (block == blocks.end()) block = blocks.insert(blocks.end(), empty_block<R>(section));
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      locations[static_cast<std::size_t>(section.elements[k])] = {
          static_cast<int>(s), static_cast<int>(k), static_cast<int>(block - blocks.begin()), history};
      history += block->prony.size() * 6 * static_cast<std::size_t>(block->point_count);
    }
  }
  return locations;
}

/// One parameter set when all elements share it.
template <class R>
void compress_parameters(HostBlock<R>& block) {
  if (block.element_count == 0) return;
  auto& stiffness = block.hourglass;
  if (!stiffness.empty() &&
      std::adjacent_find(stiffness.begin(), stiffness.end(), std::not_equal_to()) == stiffness.end())
    stiffness.erase(stiffness.begin() + 1, stiffness.end());
  const std::size_t n = block.parameters.size() / static_cast<std::size_t>(block.element_count);
  for (std::size_t i = n; i < block.parameters.size(); ++i)
    if (block.parameters[i] != block.parameters[i % n]) {
      block.per_element = true;
      return;
    }
  block.parameters.resize(n);
  block.parameters.shrink_to_fit();
}

}  // namespace

template <class R>
std::vector<HostBlock<R>> make_host_blocks(const Model& model, const Numbering& numbering,
                                           StoredConstants stored) {
  std::vector<HostBlock<R>> blocks;
  const auto locations = locate(model, blocks);
  std::vector<double> parameters;
  for (const int e : numbering.element_order) {
    const Location& at = locations[static_cast<std::size_t>(e)];
    if (at.section < 0)
      throw Error(ErrorKind::input,
                  "Element " + std::to_string(e) + " is in no section. Give every element a material.");
    HostBlock<R>& block = blocks[static_cast<std::size_t>(at.block)];
    const Section& section = model.sections[static_cast<std::size_t>(at.section)];
    element_parameters(section, static_cast<std::size_t>(at.place), parameters);
    append_element(block, model.mesh, e, hourglass_stiffness(section, parameters), stored);
    for (const double p : parameters) block.parameters.push_back(R(p));
    for (const int n : model.mesh.element(e))
      block.nodes.push_back(numbering.internal_of_user[static_cast<std::size_t>(n)]);
    if (block.viscous()) block.history_place.push_back(at.history);
    ++block.element_count;
  }
  for (auto& block : blocks) compress_parameters(block);
  return blocks;
}

template <class R>
Incidence make_incidence(const std::vector<HostBlock<R>>& blocks, int node_count) {
  Incidence lists;
  lists.begin.assign(static_cast<std::size_t>(node_count) + 1, 0);
  for (const auto& block : blocks)
    for (const int n : block.nodes) ++lists.begin[static_cast<std::size_t>(n) + 1];
  for (std::size_t n = 1; n < lists.begin.size(); ++n) lists.begin[n] += lists.begin[n - 1];
  lists.slot.resize(static_cast<std::size_t>(lists.begin.back()));
  std::vector<int> next(lists.begin.begin(), lists.begin.end() - 1);
  int slot = 0;
  for (const auto& block : blocks)
    for (const int n : block.nodes)
      lists.slot[static_cast<std::size_t>(next[static_cast<std::size_t>(n)]++)] = slot++;
  return lists;
}

template <class R>
AverageLists<R> make_average_lists(const std::vector<HostBlock<R>>& blocks, int node_count) {
  AverageLists<R> lists;
  lists.begin.assign(static_cast<std::size_t>(node_count) + 1, 0);
  std::vector<double> volume(static_cast<std::size_t>(node_count), 0.0);
  auto visit = [&](auto&& use) {
    int first = 0;
    for (const auto& block : blocks) {
      if (block.formulation == Formulation::t4anp)
        for (std::size_t i = 0; i < block.nodes.size(); ++i)
          use(static_cast<std::size_t>(block.nodes[i]), first + static_cast<int>(i / 4),
              double(block.volumes[i / 4]));
      first += block.element_count;
    }
  };
  visit([&](std::size_t n, int, double V) { ++lists.begin[n + 1], volume[n] += V; });
  for (std::size_t n = 1; n < lists.begin.size(); ++n) lists.begin[n] += lists.begin[n - 1];
  lists.element.resize(static_cast<std::size_t>(lists.begin.back()));
  lists.weight.resize(lists.element.size());
  std::vector<int> next(lists.begin.begin(), lists.begin.end() - 1);
  visit([&](std::size_t n, int e, double V) {
    const auto k = static_cast<std::size_t>(next[n]++);
    lists.element[k] = e;
    lists.weight[k] = R(V / volume[n]);
  });
  return lists;
}

namespace {

/// use(index in the block's array, index in the canonical history) for every value of a block.
template <class R, class Use>
void visit_history(const HostBlock<R>& block, const Use& use) {
  const std::size_t elements = static_cast<std::size_t>(block.element_count);
  const std::size_t values = block.prony.size() * 6 * static_cast<std::size_t>(block.point_count);
  for (std::size_t v = 0; v < values; ++v)
    for (std::size_t e = 0; e < elements; ++e) use(v * elements + e, block.history_place[e] + v);
}

}  // namespace

template <class R>
std::vector<double> canonical_history(const std::vector<const HostBlock<R>*>& blocks,
                                      const std::vector<std::vector<R>>& arrays) {
  std::size_t size = 0;
  for (const auto* block : blocks) size += block->history_size();
  std::vector<double> history(size);
  for (std::size_t k = 0; k < blocks.size(); ++k)
    visit_history(*blocks[k], [&](std::size_t own, std::size_t canonical) {
      history[canonical] = double(arrays[k][own]);
    });
  return history;
}

template <class R>
std::vector<std::vector<R>> block_history(const std::vector<const HostBlock<R>*>& blocks,
                                          const std::vector<double>& history) {
  std::size_t size = 0;
  for (const auto* block : blocks) size += block->history_size();
  if (history.size() != size)
    throw Error(ErrorKind::input, std::to_string(history.size()) +
                                      " values of material history for a model that has " +
                                      std::to_string(size) + ": the saved state belongs to another model.");
  std::vector<std::vector<R>> arrays;
  for (const auto* block : blocks) {
    std::vector<R> array(block->history_size());
    visit_history(*block,
                  [&](std::size_t own, std::size_t canonical) { array[own] = R(history[canonical]); });
    arrays.push_back(std::move(array));
  }
  return arrays;
}

template std::vector<HostBlock<float>> make_host_blocks(const Model&, const Numbering&, StoredConstants);
template std::vector<HostBlock<double>> make_host_blocks(const Model&, const Numbering&, StoredConstants);
template Incidence make_incidence(const std::vector<HostBlock<float>>&, int);
template Incidence make_incidence(const std::vector<HostBlock<double>>&, int);
template AverageLists<float> make_average_lists(const std::vector<HostBlock<float>>&, int);
template AverageLists<double> make_average_lists(const std::vector<HostBlock<double>>&, int);
template std::vector<double> canonical_history(const std::vector<const HostBlock<float>*>&,
                                               const std::vector<std::vector<float>>&);
template std::vector<double> canonical_history(const std::vector<const HostBlock<double>*>&,
                                               const std::vector<std::vector<double>>&);
template std::vector<std::vector<float>> block_history(const std::vector<const HostBlock<float>*>&,
                                                       const std::vector<double>&);
template std::vector<std::vector<double>> block_history(const std::vector<const HostBlock<double>*>&,
                                                        const std::vector<double>&);

}  // namespace glisson
