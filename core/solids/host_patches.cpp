#include <glisson/core/solids/host_patches.hpp>

#include <algorithm>
#include <span>

namespace glisson {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Nodes of a patch in the order in which its elements name them.
class NodeSet {
 public:
  explicit NodeSet(int node_count) : last_(at(node_count), -1) {}
  /// Forgets all nodes.
  void start() {
    ++stamp_;
    nodes_.clear();
  }
  void add(int n) {
    if (last_[at(n)] == stamp_) return;
    last_[at(n)] = stamp_;
    nodes_.push_back(n);
  }
  int missing(std::span<const int> of) const {
    return static_cast<int>(
        std::count_if(of.begin(), of.end(), [&](int n) { return last_[at(n)] != stamp_; }));
  }
  const std::vector<int>& nodes() const { return nodes_; }
  int count() const { return static_cast<int>(nodes_.size()); }

 private:
  std::vector<int> last_, nodes_;
  int stamp_ = -1;
};

template <class R>
std::span<const int> nodes_of(const HostBlock<R>& block, int e) {
  return std::span(block.nodes).subspan(at(e) * at(block.nodes_per_element), at(block.nodes_per_element));
}

/// Fills element_begin and counts in how many patches a node is.
template <class R>
HostPatches cut_block(const HostBlock<R>& block, int node_limit, NodeSet& set,
                      std::vector<int>& patches_of_node) {
  HostPatches patches;
  auto close = [&](int end) {
    if (end > patches.element_begin.back()) patches.element_begin.push_back(end);
    for (const int n : set.nodes()) ++patches_of_node[at(n)];
    set.start();
  };
  set.start();
  for (int e = 0; e < block.element_count; ++e) {
    const auto nodes = nodes_of(block, e);
    const bool full = e - patches.element_begin.back() == patch_threads(block.nodes_per_element);
    if (full || set.count() + set.missing(nodes) > node_limit) close(e);
    for (const int n : nodes) set.add(n);
  }
  close(block.element_count);
  return patches;
}

SharedNodes number_shared(const std::vector<int>& patches_of_node) {
  SharedNodes shared;
  shared.shared_of_node.assign(patches_of_node.size(), -1);
  for (std::size_t n = 0; n < patches_of_node.size(); ++n) {
    if (patches_of_node[n] < 2) continue;
    shared.shared_of_node[n] = shared.count();
    shared.nodes.push_back(static_cast<int>(n));
    shared.begin.push_back(shared.begin.back() + patches_of_node[n]);
  }
  return shared;
}

/// Writes the places, rows and corners of one patch after another.
template <class R>
class PatchWriter {
 public:
  PatchWriter(const HostBlock<R>& block, const SharedNodes& shared, std::vector<int>& next_slot,
              HostPatches& patches, NodeSet& set)
      : block_(block),
        shared_(shared),
        next_slot_(next_slot),
        patches_(patches),
        set_(set),
        local_(shared.shared_of_node.size()),
        valence_(shared.shared_of_node.size()) {
    patches_.corner.resize(block.nodes.size());
  }

  void write(int first, int last) {
    set_.start();
    for (int e = first; e < last; ++e)
      for (const int n : nodes_of(block_, e)) set_.add(n);
    for (const int n : set_.nodes()) valence_[at(n)] = 0;
    for (int e = first; e < last; ++e)
      for (const int n : nodes_of(block_, e)) ++valence_[at(n)];
    auto nodes = set_.nodes();
    std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) {
      const bool shared_a = is_shared(a), shared_b = is_shared(b);
      return shared_a != shared_b ? shared_b : valence_[at(a)] > valence_[at(b)];
    });
    write_places(nodes);
    write_rows(first, last, nodes);
  }

 private:
  bool is_shared(int n) const { return shared_.shared_of_node[at(n)] >= 0; }

  void write_places(const std::vector<int>& nodes) {
    int interior = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int n = nodes[i], s = shared_.shared_of_node[at(n)];
      local_[at(n)] = static_cast<int>(i);
      interior += s < 0;
      patches_.node.push_back(n);
      patches_.shared.push_back(s);
      patches_.slot.push_back(s < 0 ? -1 : next_slot_[at(s)]++);
    }
    patches_.node_begin.push_back(static_cast<int>(patches_.node.size()));
    patches_.interior_count.push_back(interior);
    patches_.largest_node_count = std::max(patches_.largest_node_count, static_cast<int>(nodes.size()));
  }
  void write_rows(int first, int last, const std::vector<int>& nodes) {
    std::vector<std::vector<std::uint16_t>> rows(nodes.size());
    const int threads = patch_threads(block_.nodes_per_element);
    for (int e = first; e < last; ++e) {
      const auto corners = nodes_of(block_, e);
      for (std::size_t a = 0; a < corners.size(); ++a) {
        const int i = local_[at(corners[a])];
        patches_.corner[a * at(block_.element_count) + at(e)] = static_cast<std::uint16_t>(i);
        rows[at(i)].push_back(static_cast<std::uint16_t>(static_cast<int>(a) * threads + e - first));
      }
    }
    for (const auto& of_node : rows) {
      patches_.row.insert(patches_.row.end(), of_node.begin(), of_node.end());
      patches_.row_begin.push_back(static_cast<int>(patches_.row.size()));
    }
  }

  const HostBlock<R>& block_;
  const SharedNodes& shared_;
  std::vector<int>& next_slot_;  ///< [shared_count]
  HostPatches& patches_;
  NodeSet& set_;
  std::vector<int> local_, valence_;  ///< of the nodes of the patch [node_count]
};

/// The middle of the box around the nodes of a patch: what is small against it would be lost in float.
Vec3<double> middle(const std::vector<Vec3<double>>& X) {
  Vec3<double> low = X.front(), high = X.front();
  for (const auto& x : X) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  return 0.5 * (low + high);
}

}  // namespace

template <class R>
PatchCut cut_into_patches(const std::vector<HostBlock<R>>& blocks, int node_count, int node_limit) {
  PatchCut cut;
  NodeSet set(node_count);
  std::vector<int> patches_of_node(at(node_count), 0);
  for (const auto& block : blocks) cut.blocks.push_back(cut_block(block, node_limit, set, patches_of_node));
  cut.shared = number_shared(patches_of_node);
  std::vector<int> next_slot(cut.shared.begin.begin(), cut.shared.begin.end() - 1);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    HostPatches& patches = cut.blocks[b];
    PatchWriter<R> writer(blocks[b], cut.shared, next_slot, patches, set);
    for (std::size_t p = 0; p + 1 < patches.element_begin.size(); ++p)
      writer.write(patches.element_begin[p], patches.element_begin[p + 1]);
  }
  return cut;
}

template <class R>
std::vector<R> rest_positions(const HostPatches& patches, const Mesh& mesh, const Numbering& numbering) {
  const std::size_t count = patches.node.size();
  std::vector<R> X(3 * count);
  for (int p = 0; p < patches.patch_count(); ++p) {
    const std::size_t first = at(patches.node_begin[at(p)]), last = at(patches.node_begin[at(p) + 1]);
    std::vector<Vec3<double>> of_patch;
    for (std::size_t i = first; i < last; ++i)
      of_patch.push_back(mesh.X[at(numbering.user_of_internal[at(patches.node[i])])]);
    const Vec3<double> origin = middle(of_patch);
    for (std::size_t i = first; i < last; ++i) {
      const Vec3<double> x = of_patch[i - first] - origin;
      X[i] = R(x.x), X[count + i] = R(x.y), X[2 * count + i] = R(x.z);
    }
  }
  return X;
}

template <class R>
std::vector<R> inverse_volumes(const std::vector<HostBlock<R>>& blocks, int node_count) {
  std::vector<double> volume(at(node_count), 0.0);
  bool any = false;
  for (const auto& block : blocks) {
    if (block.formulation != Formulation::t4anp) continue;
    any = true;
    for (std::size_t i = 0; i < block.nodes.size(); ++i)
      volume[at(block.nodes[i])] += double(block.volumes[i / 4]);
  }
  std::vector<R> inverse;
  if (!any) return inverse;
  inverse.reserve(volume.size());
  for (const double V : volume) inverse.push_back(V > 0 ? R(1 / V) : R(0));
  return inverse;
}

template PatchCut cut_into_patches(const std::vector<HostBlock<float>>&, int, int);
template PatchCut cut_into_patches(const std::vector<HostBlock<double>>&, int, int);
template std::vector<float> rest_positions(const HostPatches&, const Mesh&, const Numbering&);
template std::vector<double> rest_positions(const HostPatches&, const Mesh&, const Numbering&);
template std::vector<float> inverse_volumes(const std::vector<HostBlock<float>>&, int);
template std::vector<double> inverse_volumes(const std::vector<HostBlock<double>>&, int);

}  // namespace glisson
