#include <glisson/run/shell_packs/packed_shells.hpp>

#include <algorithm>
#include <array>
#include <bit>

#include <glisson/core/base/error.hpp>
#include <glisson/cpu/patch_elements.hpp>
#include <glisson/run/shell_packs/kernel_table.hpp>
#include <glisson/run/shell_packs/strip_layout.hpp>
#include <glisson/run/shell_packs/triangle_strips.hpp>
#include <glisson/shells/internal_forces.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {
namespace {

using patches::ElementBlock;
using patches::Item;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<float> law_members(const ShellSection& section) {
  std::vector<float> members;
  for_each_type(MembraneLaws<float>{}, [&]<class L>() {
    if (section.law != L::name) return;
    const std::vector<float> parameters(section.parameters.begin(), section.parameters.end());
    const auto numbers =
        std::bit_cast<std::array<float, sizeof(L) / sizeof(float)>>(L::load(parameters.data()));
    members.assign(numbers.begin(), numbers.end());
  });
  return members;
}

const ShellLawFunctions& functions_of(const ShellKernels& kernels, const std::string& law) {
  for (const ShellLawFunctions& functions : kernels.laws)
    if (law == functions.name) return functions;
  throw Error(ErrorKind::input, "There are no kernels for the membrane law " + law + ".");
}

/// All numbers of E's constants.
template <class E>
constexpr int numbers_of = sizeof(typename E::template Constants<double>) / sizeof(double);

template <class Constants>
void append(const Constants& constants, std::vector<float>& to) {
  constexpr std::size_t count = sizeof(Constants) / sizeof(double);
  for (const double number : std::bit_cast<std::array<double, count>>(constants))
    to.push_back(static_cast<float>(number));
}

/// For lanes without an element: no force, and no division by zero whatever their nodes do.
ShellPatch<double> idle_shell() {
  ShellPatch<double> c{};
  c.a = {1e6, 0, 0}, c.b = {0, 1e6, 0};
  c.inverse_double_area = 1e-12;
  return c;
}

class BlockMaker {
 public:
  BlockMaker(const ShellKernels& kernels, const Model& model, const Numbering& numbering)
      : kernels_(kernels), numbering_(numbering), rank_(model.mesh.triangles.size()) {
    for (std::size_t i = 0; i < rank_.size(); ++i)
      rank_[at(numbering.triangle_order[i])] = static_cast<int>(i);
  }

  void add(const HostShells& host, std::vector<ElementBlock>& blocks) {
    std::vector<int> order(host.section->elements.size());  // places in the section along the curve
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return rank_[at(host.section->elements[at(a)])] < rank_[at(host.section->elements[at(b)])];
    });
    if (!host.bends()) {
      add_membranes(host, order, blocks);
    } else {
      const auto border = std::stable_partition(order.begin(), order.end(),
                                                [&](int k) { return !at_border(host.shells[at(k)]); });
      add_inner_shells(host, {order.begin(), border}, blocks);
      add_border_shells(host, {border, order.end()}, blocks);
    }
    history_begin_ += static_cast<int>(3 * host.section->prony.size() * order.size());
  }

 private:
  ElementBlock start(const HostShells& host, const patches::Layout& layout) const {
    const ShellSection& section = *host.section;
    const ShellLawFunctions& law = functions_of(kernels_, section.law);
    ElementBlock block;
    block.stress = law.stress[section.wrinkling ? 1 : 0];
    block.energy_of_law = law.energy[section.wrinkling ? 1 : 0];
    block.layout = layout;
    block.parameters = law_members(section);
    block.prony = section.prony;
    block.history_components = 3;
    return block;
  }
  int internal(const HostShells& host, std::size_t slot) const {
    return numbering_.internal_of_user[at(host.nodes[slot])];
  }
  static bool plain(const ShellSection& section) { return section.prony.empty() && !section.wrinkling; }
  static int next_element(const ElementBlock& block) {
    return static_cast<int>(block.constants.size()) / block.layout.constants;
  }
  /// One more element of the block: number k of the section.
  void keep_history(ElementBlock& block, int k) const {
    if (!block.prony.empty())
      block.history_place.push_back(history_begin_ + k * static_cast<int>(block.history_per_element()));
  }

  /// Own corners of the elements `order` of the section.
  std::vector<std::array<int, 3>> corners(const HostShells& host, std::span<const int> order) const {
    std::vector<std::array<int, 3>> result;
    for (const int k : order) {
      const std::size_t first = at(k) * at(host.slots());
      result.push_back({internal(host, first), internal(host, first + 1), internal(host, first + 2)});
    }
    return result;
  }

  void add_membranes(const HostShells& host, std::span<const int> order,
                     std::vector<ElementBlock>& blocks) const {
    ElementBlock block = start(host, {corners_of_strip, triangles_per_strip, numbers_of<Membrane>, 1, 256});
    const patches::PatchKernel own = functions_of(kernels_, host.section->law).membrane_forces;
    block.forces = plain(*host.section) && own ? own : kernels_.membrane_forces;
    block.energy = kernels_.membrane_energy;
    const auto triangles = corners(host, order);
    for (const TriangleStrip& strip : triangle_strips(triangles)) {
      Item item;
      for (std::size_t j = 0; j < strip.size() && strip[j].number >= 0; ++j) {
        item.element[j] = next_element(block);
        for (std::size_t a = 0; a < 3; ++a)
          item.node[j + a] = triangles[at(strip[j].number)][at(strip[j].corner[a])];
        item.corners = static_cast<int>(j) + 3;
        const int k = order[at(strip[j].number)];
        append(turned(host.membranes[at(k)], strip[j].corner), block.constants);
        keep_history(block, k);
      }
      repeat_last_corner(item);
      block.items.push_back(item);
    }
    blocks.push_back(std::move(block));
  }

  static bool at_border(const RotationFree::Constants<double>& c) {
    return std::any_of(std::begin(c.image), std::end(c.image), [](const SideImage<double>& image) {
      return image.turned != 0 || dot(image.mirror, image.mirror) > 0;
    });
  }
  /// Triangles with images, one per lane.
  void add_border_shells(const HostShells& host, std::span<const int> order,
                         std::vector<ElementBlock>& blocks) const {
    ElementBlock block = start(host, {RotationFree::node_count, 1, numbers_of<RotationFree>, 1, 256});
    block.forces = kernels_.border_forces;
    block.energy = kernels_.border_energy;
    for (const int k : order) {
      Item item;
      item.corners = RotationFree::node_count;
      item.element[0] = next_element(block);
      for (std::size_t a = 0; a < 6; ++a) item.node[a] = internal(host, 6 * at(k) + a);
      block.items.push_back(item);
      append(host.shells[at(k)], block.constants);
      keep_history(block, k);
    }
    blocks.push_back(std::move(block));
  }
  /// Triangles between three others, in strips.
  void add_inner_shells(const HostShells& host, std::span<const int> order,
                        std::vector<ElementBlock>& blocks) const {
    ElementBlock block =
        start(host, {nodes_of_shell_strip, triangles_per_strip, numbers_of<RotationFreeInner>, 1, 144});
    block.layout.new_corners = 0;
    const patches::PatchKernel own = functions_of(kernels_, host.section->law).shell_forces;
    block.forces = plain(*host.section) && own ? own : kernels_.shell_forces;
    block.energy = kernels_.shell_energy;
    append(idle_shell(), block.idle);
    for (const TriangleStrip& strip : triangle_strips(corners(host, order))) {
      Item item;
      for (std::size_t j = 0; j < strip.size() && strip[j].number >= 0; ++j) {
        item.element[j] = next_element(block);
        const int k = order[at(strip[j].number)];
        for (std::size_t a = 0; a < 6; ++a) {
          const std::size_t old = at(strip[j].corner[a % 3]) + a / 3 * 3;
          item.node[at(shell_strip_nodes[j][a])] = internal(host, 6 * at(k) + old);
        }
        item.corners = 6 + 2 * static_cast<int>(j);
        append(turned(host.shells[at(k)], strip[j].corner), block.constants);
        keep_history(block, k);
      }
      repeat_last_corner(item);
      block.items.push_back(item);
    }
    blocks.push_back(std::move(block));
  }
  static void repeat_last_corner(Item& item) {
    std::fill(item.node.begin() + item.corners, item.node.end(), item.node[at(item.corners) - 1]);
  }

  const ShellKernels& kernels_;
  const Numbering& numbering_;
  std::vector<int> rank_;  ///< place of a triangle along the curve [triangles]
  int history_begin_ = 0;  ///< of the section
};

class PackedShells final : public InternalForces<float> {
 public:
  PackedShells(Threads& threads, const Model& model, const Numbering& numbering,
               std::unique_ptr<SolidForces<float>> solids, const std::string& instruction_set)
      : InternalForces<float>(std::move(solids)),
        elements_(threads, blocks_of(model, numbering, instruction_set), model.mesh.node_count(),
                  instruction_set) {}

 private:
  static std::vector<ElementBlock> blocks_of(const Model& model, const Numbering& numbering,
                                             const std::string& instruction_set) {
    std::vector<ElementBlock> blocks;
    BlockMaker maker(shell_kernels(instruction_set.c_str()), model, numbering);
    for (const HostShells& host : make_shell_blocks(model)) maker.add(host, blocks);
    return blocks;
  }
  void add_shell_forces(const StepView<float>& step) override { elements_.add_forces(step); }
  PendingSum energy_of_shells(const StepView<float>& step) override { return elements_.energy(step); }
  std::size_t shell_history_size() const override { return elements_.history_size(); }
  void get_shell_history(double* values) const override { elements_.get_history(values); }
  void set_shell_history(const double* values) override { elements_.set_history(values); }
  std::size_t shell_bytes() const override { return elements_.memory_bytes(); }

  patches::PatchElements elements_;
};

}  // namespace

std::unique_ptr<SolidForces<float>> make_packed_shells(Threads& threads, const Model& model,
                                                       const Numbering& numbering,
                                                       std::unique_ptr<SolidForces<float>> solids,
                                                       const std::string& instruction_set) {
  return std::make_unique<PackedShells>(threads, model, numbering, std::move(solids), instruction_set);
}

}  // namespace glisson::shells
