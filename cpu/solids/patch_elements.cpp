#include <glisson/cpu/patch_elements.hpp>

#include <algorithm>
#include <numeric>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

PatchElements::PatchElements(Threads& threads, std::vector<ElementBlock> blocks, int node_count,
                             const std::string& instruction_set)
    : threads_(threads), kernels_(*choose_instruction_set(instruction_set.c_str()).formulations) {
  PatchLists lists(node_count, kernels_.width);
  for (const ElementBlock& block : blocks)
    for (const Item& item : block.items) {
      const int per_element = block.layout.corners_of_element(item.corners);
      for (int j = 0, first = 0; j < block.layout.elements(item.corners);
           ++j, first += block.layout.new_corners)
        for (int k = first; k < first + per_element; ++k) lists.count(item.node[at(k)]);
    }
  for (ElementBlock& block : blocks) {
    add_patches(block, lists);
    history_size_ += block.history_place.size() * block.history_per_element();
    blocks_.push_back({block.forces,
                       block.energy,
                       block.stress,
                       block.energy_of_law,
                       block.layout,
                       std::move(block.prony),
                       {},
                       block.history_components,
                       std::move(block.history_place)});
    block = {};  // its constants are copied
  }
  shared_ = SharedNodes(patches_, node_count, lists.slot_count());
  local_floats_ = (4 * lists.largest_node_count() + 15) / 16 * 16;
  scratch_floats_ = local_floats_ + 16 + (4 * lists.largest_row_count() + 15) / 16 * 16 + 1024;
  const auto team = at(threads_.thread_count());
  scratch_ = threads_.allocate<float>(team * at(scratch_floats_));
  slot_force_ = threads_.allocate<float>(4 * shared_.slots.size());
  streams_ = arena_.used() > team * second_cache;
  patch_energy_.resize(patches_.size());
  share_out();
}

void PatchElements::add_patches(const ElementBlock& block, PatchLists& lists) {
  const auto per_patch = at(block.layout.items_per_patch);
  for (std::size_t first = 0; first < block.items.size(); first += per_patch) {
    const std::span<const Item> all(block.items);
    patches_.push_back(
        make_patch(block, all.subspan(first, std::min(per_patch, block.items.size() - first)), lists));
    block_of_patch_.push_back(static_cast<int>(blocks_.size()));
  }
}

Patch PatchElements::make_patch(const ElementBlock& block, std::span<const Item> items, PatchLists& lists) {
  const Layout& layout = block.layout;
  const PatchOutline outline = lists.outline(layout, items);
  Patch patch = outline.patch;
  const auto W = at(kernels_.width), places = at(patch.tiles * layout.elements_per_item) * W,
             history_rows = block.history_per_element();
  MemoryPlan plan;
  const std::size_t node = plan.add<int>(outline.nodes.size()), run = plan.add<SumRun>(outline.runs.size()),
                    row = plan.add<std::uint16_t>(outline.rows),
                    corner = plan.add<std::uint16_t>(at(patch.tiles * layout.corners) * W),
                    element = plan.add<int>(history_rows > 0 ? places : 0),
                    parameters = plan.add<float>(block.parameters.size() * W),
                    history = plan.add<float>(places * history_rows),
                    constants = plan.add<float>(places * at(layout.constants));
  std::byte* memory = arena_.allocate(plan.bytes());
  const PatchListArrays lists_at{
      reinterpret_cast<int*>(memory + node), reinterpret_cast<SumRun*>(memory + run),
      reinterpret_cast<std::uint16_t*>(memory + row), reinterpret_cast<std::uint16_t*>(memory + corner)};
  lists.write(outline, layout, items, lists_at);
  auto* elements = reinterpret_cast<int*>(memory + element);
  auto* numbers = reinterpret_cast<float*>(memory + constants);
  if (history_rows > 0) std::fill_n(elements, places, -1);
  auto* uniform = reinterpret_cast<float*>(memory + parameters);
  for (std::size_t k = 0; k < block.parameters.size(); ++k)
    std::fill_n(uniform + k * W, W, block.parameters[k]);
  const auto count = at(layout.constants);
  for (std::size_t i = 0; i < places * block.idle.size(); ++i)
    numbers[i] = block.idle[i / W % block.idle.size()];
  for (std::size_t i = 0; i < items.size(); ++i)
    for (int j = 0; j < layout.elements_per_item; ++j) {
      const int e = items[i].element[at(j)];
      if (e < 0) continue;
      const std::size_t place = i / W * at(layout.elements_per_item) + at(j), lane = i % W;
      for (std::size_t c = 0; c < count; ++c)
        numbers[(place * count + c) * W + lane] = block.constants[at(e) * count + c];
      if (history_rows > 0) elements[place * W + lane] = e;
    }
  patch.node = lists_at.node;
  patch.run = lists_at.run;
  patch.row = lists_at.row;
  patch.corner = lists_at.corner;
  patch.element = elements;
  patch.parameters = uniform;
  patch.history = reinterpret_cast<float*>(memory + history);
  patch.constants = numbers;
  return patch;
}

/// Equal shares of the corners, which cost most of the time.
void PatchElements::share_out() {
  std::vector<double> done{0};
  for (std::size_t p = 0; p < patches_.size(); ++p)
    done.push_back(done.back() + patches_[p].tiles * blocks_[at(block_of_patch_[p])].layout.corners);
  const auto team = at(threads_.thread_count());
  for (std::size_t t = 0; t <= team; ++t) {
    const double share = done.back() * static_cast<double>(t) / static_cast<double>(team);
    cut_.push_back(static_cast<int>(std::lower_bound(done.begin(), done.end(), share) - done.begin()));
  }
}

Pass PatchElements::pass_of(const StepView<float>& step, int thread) const {
  Pass pass;
  pass.u = reinterpret_cast<const float*>(step.u);
  pass.f = reinterpret_cast<float*>(step.f);
  pass.slot_force = slot_force_.get();
  pass.local_rows = scratch_.get() + at(thread) * at(scratch_floats_);
  pass.force_rows = pass.local_rows + local_floats_;
  pass.advance = step.advance;
  return pass;
}

void PatchElements::add_forces(const StepView<float>& step) {
  for (Kernels& block : blocks_)
    if (!block.prony.empty() && block.dt != step.dt) {
      block.terms = prony_terms(block.prony, step.dt);
      block.dt = step.dt;
    }
  threads_.team().run([&](int thread) {
    Pass pass = pass_of(step, thread);
    for (int p = cut_[at(thread)]; p < cut_[at(thread) + 1]; ++p) {
      const Kernels& block = blocks_[at(block_of_patch_[at(p)])];
      pass.next = streams_ && p + 1 < cut_[at(thread) + 1] ? &patches_[at(p + 1)] : nullptr;
      pass.prony = block.terms.data();
      pass.isochoric = static_cast<int>(block.terms.size());
      pass.law = block.stress;
      kernels_.load_displacements(patches_[at(p)], pass);
      block.forces(patches_[at(p)], pass);
      kernels_.sum_forces(patches_[at(p)], pass);
    }
    threads_.team().barrier();
    shared_.sum_forces(pass, shared_.share(thread, threads_.thread_count()));
  });
}

double PatchElements::energy(const StepView<float>& step) {
  threads_.team().run([&](int thread) {
    Pass pass = pass_of(step, thread);
    for (int p = cut_[at(thread)]; p < cut_[at(thread) + 1]; ++p) {
      const Kernels& block = blocks_[at(block_of_patch_[at(p)])];
      pass.law = block.energy_of_law;
      kernels_.load_displacements(patches_[at(p)], pass);
      patch_energy_[at(p)] = block.energy(patches_[at(p)], pass);
    }
  });
  return std::accumulate(patch_energy_.begin(), patch_energy_.end(), 0.0);
}

/// visit(place among all, value in a tile) for every number.
template <class Visit>
void PatchElements::visit_history(Visit&& visit) const {
  const auto W = at(kernels_.width);
  std::size_t p = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Kernels& block = blocks_[b];
    const std::size_t rows = block.prony.size() * at(block.history_components);
    for (; p < patches_.size() && block_of_patch_[p] == static_cast<int>(b); ++p) {
      if (rows == 0) continue;
      for (std::size_t place = 0; place < at(patches_[p].tiles * block.layout.elements_per_item) * W;
           ++place) {
        const int e = patches_[p].element[place];
        if (e < 0) continue;
        float* first = patches_[p].history + place / W * rows * W + place % W;
        for (std::size_t i = 0; i < rows; ++i) visit(at(block.history_place[at(e)]) + i, first[i * W]);
      }
    }
  }
}

void PatchElements::get_history(double* values) const {
  visit_history([&](std::size_t place, float& value) { values[place] = static_cast<double>(value); });
}

void PatchElements::set_history(const double* values) {
  visit_history([&](std::size_t place, float& value) { value = static_cast<float>(values[place]); });
}

std::size_t PatchElements::memory_bytes() const {
  return arena_.used() + patches_.capacity() * sizeof(Patch) +
         (block_of_patch_.capacity() + shared_.node.capacity() + shared_.begin.capacity() +
          shared_.slots.capacity()) *
             sizeof(int) +
         (at(threads_.thread_count()) * at(scratch_floats_) + 4 * shared_.slots.size()) * sizeof(float);
}

}  // namespace glisson::patches
