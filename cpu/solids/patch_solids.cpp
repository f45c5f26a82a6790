#include <glisson/cpu/solids/patch_solids.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/patch_solids.hpp>
#include <glisson/cpu/solids/element_constants.hpp>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Backend memory as rows of floats.
const float* floats(const Vec4<float>* rows) { return reinterpret_cast<const float*>(rows); }
float* floats(Vec4<float>* rows) { return reinterpret_cast<float*>(rows); }

std::vector<PronyCoefficients<float>> coefficients(const Block& block, double dt) {
  auto result = prony_terms(block.isochoric, dt);
  const auto volumetric = prony_terms(block.volumetric, dt);
  result.insert(result.end(), volumetric.begin(), volumetric.end());
  return result;
}

}  // namespace

PatchSolids::PatchSolids(Threads& threads, const Model& model, const Numbering& numbering,
                         const InstructionSet& set)
    : threads_(threads), set_(set), kernels_(*set.formulations) {
  const int node_count = model.mesh.node_count(), width = kernels_.width;
  {
    ElementParameters parameters(model);
    PatchBuilder builder(model, numbering, parameters, width, arena_);
    make_blocks(model, numbering, parameters, builder);
    local_floats_ = (4 * builder.lists().largest_node_count() + 15) / 16 * 16;
    scratch_floats_ = local_floats_ + 16 + (4 * builder.lists().largest_row_count() + 15) / 16 * 16 + 1024;
    shared_ = SharedNodes(patches_, node_count, builder.lists().slot_count());
  }
  const auto team = at(threads_.thread_count()), slots = shared_.slots.size();
  scratch_ = threads_.allocate<float>(team * at(scratch_floats_));
  slot_force_ = threads_.allocate<float>(4 * slots);
  if (averages_pressure_) find_volumes(model, numbering);
  keep_history_order(model);
  streams_ = arena_.used() > team * second_cache;
  patch_energy_.resize(patches_.size());
  cut_.resize(team + 1);
  for (std::size_t t = 0; t <= team; ++t) cut_[t] = static_cast<int>(patches_.size() * t / team);
}

const LawTable& PatchSolids::law_named(const std::string& name) const {
  for (std::size_t i = 0; i < set_.law_count; ++i)
    if (name == set_.laws[i]->name) return *set_.laws[i];
  throw Error(ErrorKind::input,
              "The law " + name + " does not exist. See the list of laws in the documentation.");
}

void PatchSolids::make_blocks(const Model& model, const Numbering& numbering,
                              const ElementParameters& parameters, PatchBuilder& builder) {
  auto pairs = [](const std::vector<PronyTerm>& terms) {
    std::vector<std::pair<double, double>> result;
    result.reserve(terms.size());
    for (const PronyTerm& t : terms) result.emplace_back(t.alpha, t.tau);
    return result;
  };
  using Key = std::tuple<Kind, std::string, decltype(pairs({})), decltype(pairs({}))>;
  std::map<Key, int> numbers;
  std::vector<std::vector<int>> elements;  // of each block, in internal order
  std::vector<int> last(model.sections.size() * kind_count, -1);
  std::vector<Vec3<double>> X;
  for (const int e : numbering.element_order) {
    if (parameters.section_of(e) < 0) continue;
    const Section& section = model.sections[at(parameters.section_of(e))];
    X.clear();
    for (const int n : model.mesh.element(e)) X.push_back(model.mesh.X[at(n)]);
    const Kind kind = kind_of(section.formulation, X);
    int& number = last[at(parameters.section_of(e) * kind_count + static_cast<int>(kind))];
    if (number < 0) {
      const MaterialSpec& material = section.material;
      const auto [it, is_new] =
          numbers.emplace(Key{kind, material.law, pairs(material.isochoric), pairs(material.volumetric)},
                          static_cast<int>(blocks_.size()));
      number = it->second;
      if (is_new) {
        blocks_.push_back({kind, &law_named(material.law), material.isochoric, material.volumetric});
        elements.emplace_back();
      }
    }
    elements[at(number)].push_back(e);
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    builder.add(block, std::move(elements[b]), patches_);
    block_of_patch_.resize(patches_.size(), static_cast<int>(b));
    const auto f = static_cast<std::size_t>(block.kind);
    const PatchKernel own = block.terms() > 0 ? block.law->viscous_forces[f] : block.law->forces[f];
    block_passes_.push_back({own ? own : kernels_.forces[f], {}});
    averages_pressure_ = averages_pressure_ || block.kind == Kind::t4anp;
  }
}

/// 1 / (4 sum of V_e) around the nodes of T4ANP elements; 0 elsewhere.
void PatchSolids::find_volumes(const Model& model, const Numbering& numbering) {
  const auto node_count = at(model.mesh.node_count());
  pressure_ = threads_.allocate<float>(node_count);
  pressure_weight_ = threads_.allocate<float>(node_count);
  slot_pressure_ = threads_.allocate<float>(shared_.slots.size());
  std::vector<double> volume(node_count), constants;
  for (const Section& section : model.sections) {
    if (section.formulation != Formulation::t4anp) continue;
    for (const int e : section.elements) {
      std::array<Vec3<double>, 4> X;
      const auto nodes = model.mesh.element(e);
      for (std::size_t a = 0; a < 4; ++a) X[a] = model.mesh.X[at(nodes[a])];
      element_constants(Kind::t4, X, {}, constants);
      for (const int n : nodes) volume[at(numbering.internal_of_user[at(n)])] += constants[9];
    }
  }
  for (std::size_t n = 0; n < node_count; ++n)
    pressure_weight_[n] = volume[n] > 0 ? static_cast<float>(0.25 / volume[n]) : 0.0f;
}

Pass PatchSolids::pass_of(const StepView<float>& step, int thread) const {
  Pass pass;
  pass.u = floats(step.u);
  pass.f = floats(step.f);
  pass.slot_force = slot_force_.get();
  pass.pressure = pressure_.get();
  pass.slot_pressure = slot_pressure_.get();
  pass.pressure_weight = pressure_weight_.get();
  pass.local_rows = scratch_.get() + at(thread) * at(scratch_floats_);
  pass.force_rows = pass.local_rows + local_floats_;
  pass.advance = step.advance;
  return pass;
}

void PatchSolids::for_block(Pass& pass, const Block& block, const BlockPass& block_pass) const {
  pass.prony = block_pass.prony.data();
  pass.isochoric = static_cast<int>(block.isochoric.size());
  pass.volumetric = static_cast<int>(block.volumetric.size());
  pass.law = block.terms() > 0 ? block.law->viscous : block.law->elastic;
}

void PatchSolids::load(const Block& block, const Patch& patch, const Pass& pass) const {
  kernels_.load_displacements(patch, pass);
  if (block.kind == Kind::t4anp) kernels_.load_pressures(patch, pass);
}

/// First sweep of T4ANP (Joldes et al. 2009): volume-weighted mean of the element pressures at the nodes.
void PatchSolids::average_pressures(Pass pass, int thread) {
  for (int p = cut_[at(thread)]; p < cut_[at(thread) + 1]; ++p) {
    if (blocks_[at(block_of_patch_[at(p)])].kind != Kind::t4anp) continue;
    pass.next = streams_ && p + 1 < cut_[at(thread) + 1] ? &patches_[at(p + 1)] : nullptr;
    kernels_.load_displacements(patches_[at(p)], pass);
    kernels_.pressures(patches_[at(p)], pass);
    kernels_.sum_pressures(patches_[at(p)], pass);
  }
  threads_.team().barrier();
  const Share share = shared_.share(thread, threads_.thread_count());
  for (int i = share.first; i < share.last; ++i) {
    float sum = 0;
    for (int k = shared_.begin[at(i)]; k < shared_.begin[at(i) + 1]; ++k)
      sum += pass.slot_pressure[shared_.slots[at(k)]];
    const int node = shared_.node[at(i)];
    pass.pressure[node] = sum * pass.pressure_weight[node];
  }
  threads_.team().barrier();
}

void PatchSolids::add_forces(const StepView<float>& step) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockPass& block_pass = block_passes_[b];
    if (blocks_[b].terms() == 0 || block_pass.dt == step.dt) continue;
    block_pass.dt = step.dt;
    block_pass.prony = coefficients(blocks_[b], step.dt);
  }
  threads_.team().run([&](int thread) {
    Pass pass = pass_of(step, thread);
    if (averages_pressure_) average_pressures(pass, thread);
    for (int p = cut_[at(thread)]; p < cut_[at(thread) + 1]; ++p) {
      const std::size_t b = at(block_of_patch_[at(p)]);
      pass.next = streams_ && p + 1 < cut_[at(thread) + 1] ? &patches_[at(p + 1)] : nullptr;
      for_block(pass, blocks_[b], block_passes_[b]);
      load(blocks_[b], patches_[at(p)], pass);
      block_passes_[b].forces(patches_[at(p)], pass);
      kernels_.sum_forces(patches_[at(p)], pass);
    }
    threads_.team().barrier();
    shared_.sum_forces(pass, shared_.share(thread, threads_.thread_count()));
  });
}

template <class Energy>
double PatchSolids::sum_energy(const StepView<float>& step, Energy&& energy) {
  threads_.team().run([&](int thread) {
    Pass pass = pass_of(step, thread);
    if (averages_pressure_) average_pressures(pass, thread);
    for (int p = cut_[at(thread)]; p < cut_[at(thread) + 1]; ++p) {
      const std::size_t b = at(block_of_patch_[at(p)]);
      pass.law = blocks_[b].law->energy;
      const EnergyKernel kernel = energy(blocks_[b]);
      if (kernel) load(blocks_[b], patches_[at(p)], pass);
      patch_energy_[at(p)] = kernel ? kernel(patches_[at(p)], pass) : 0;
    }
  });
  return std::accumulate(patch_energy_.begin(), patch_energy_.end(), 0.0);
}

PendingSum PatchSolids::strain_energy(const StepView<float>& step) {
  return sum_energy(step,
                    [&](const Block& b) { return kernels_.strain_energy[static_cast<std::size_t>(b.kind)]; });
}

PendingSum PatchSolids::hourglass_energy(const StepView<float>& step) {
  auto kernel = [&](const Block& b) { return kernels_.hourglass_energy[static_cast<std::size_t>(b.kind)]; };
  if (std::none_of(blocks_.begin(), blocks_.end(), [&](const Block& b) { return kernel(b) != nullptr; }))
    return 0;
  return sum_energy(step, kernel);
}

void PatchSolids::keep_history_order(const Model& model) {
  for (const Section& section : model.sections) {
    const std::size_t terms = section.material.isochoric.size() + section.material.volumetric.size();
    const auto points = at(layout_of(static_cast<Kind>(section.formulation)).points);
    if (terms == 0) continue;
    history_begin_.resize(at(model.mesh.element_count()));
    for (const int e : section.elements) {
      history_begin_[at(e)] = history_size_;
      history_size_ += points * terms * 6;
    }
  }
}

/// visit(place in canonical order, value in a tile) for every number.
template <class Visit>
void PatchSolids::visit_history(Visit&& visit) const {
  const auto W = at(kernels_.width);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const Block& block = blocks_[at(block_of_patch_[p])];
    const Layout layout = layout_of(block.kind);
    const std::size_t per_element = at(layout.points * block.terms()) * 6;
    if (per_element == 0) continue;
    for (std::size_t place = 0; place < at(patches_[p].tiles * layout.elements_per_item) * W; ++place) {
      const int e = patches_[p].element[place];
      if (e < 0) continue;
      float* first = patches_[p].history + place / W * per_element * W + place % W;
      for (std::size_t i = 0; i < per_element; ++i) visit(history_begin_[at(e)] + i, first[i * W]);
    }
  }
}

std::vector<double> PatchSolids::history() const {
  std::vector<double> values(history_size_);
  visit_history([&](std::size_t place, float& value) { values[place] = static_cast<double>(value); });
  return values;
}

void PatchSolids::set_history(const std::vector<double>& values) {
  if (values.size() != history_size_)
    throw Error(ErrorKind::input, "The saved history has " + std::to_string(values.size()) +
                                      " values, but the model needs " + std::to_string(history_size_) +
                                      ": it belongs to another model.");
  visit_history([&](std::size_t place, float& value) { value = static_cast<float>(values[place]); });
}

std::size_t PatchSolids::memory_bytes() const {
  auto ints = [](const std::vector<int>& v) { return v.capacity() * sizeof(int); };
  const std::size_t slots = shared_.slots.size();
  std::size_t floats = at(threads_.thread_count()) * at(scratch_floats_) + 4 * slots;
  if (averages_pressure_)
    floats += slots + pressure_.get_deleter().count + pressure_weight_.get_deleter().count;
  return arena_.used() + patches_.capacity() * sizeof(Patch) + ints(block_of_patch_) + ints(shared_.node) +
         ints(shared_.begin) + ints(shared_.slots) + floats * sizeof(float) +
         history_begin_.capacity() * sizeof(std::size_t) + patch_energy_.capacity() * sizeof(double);
}

}  // namespace glisson::patches

namespace glisson {

std::unique_ptr<SolidForces<float>> make_patch_solids(Threads& threads, const Model& model,
                                                      const Numbering& numbering,
                                                      const std::string& instruction_set) {
  return std::make_unique<patches::PatchSolids>(threads, model, numbering,
                                                patches::choose_instruction_set(instruction_set.c_str()));
}

std::string widest_instruction_set() { return patches::choose_instruction_set("auto").name; }

}  // namespace glisson
