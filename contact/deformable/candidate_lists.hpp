// The candidates of the last search in a backend's memory, with what belongs to their slots and nodes.
#pragma once

#include <algorithm>

#include <glisson/contact/deformable/candidates.hpp>
#include <glisson/contact/deformable/deal_touches.hpp>
#include <glisson/contact/deformable/find_touches.hpp>
#include <glisson/contact/deformable/resizable.hpp>

namespace glisson::contact {

template <Backend B, class R>
class CandidateLists {
 public:
  CandidateLists(B& backend, const ContactMesh& mesh)
      : backend_(backend),
        edges_(detail::upload(backend, edges_of(mesh))),
        group_node_(backend),
        group_begin_(backend),
        facets_(backend),
        pairs_(backend),
        nodes_(backend),
        internal_(backend),
        incident_begin_(backend),
        incident_(backend),
        push_count_(backend),
        dealt_slots_(backend),
        dealt_entry_(backend),
        dealt_pushed_(backend),
        dealt_end_(backend),
        pushes_(backend),
        dealt_found_(backend),
        share_(backend),
        mobility_(backend),
        guess_(backend),
        moved_(backend),
        push_(backend),
        bias_(backend),
        friction_(backend),
        entry_(backend),
        touches_(backend),
        used_(backend),
        pressing_(backend),
        rubbing_(backend),
        entry_of_(detail::zeros<int>(backend, mesh.nodes.size())),
        place_of_(detail::zeros<int>(backend, mesh.nodes.size())),
        deepest_(detail::zeros<R>(backend, mesh.nodes.size())),
        force_(detail::zeros<Vec4<R>>(backend, mesh.nodes.size())),
        last_(detail::zeros<Vec4<R>>(backend, mesh.nodes.size())),
        host_(mesh.nodes.size()) {}

  /// Lists of a search. `extra`: rising nodes that no slot pushes but whose last force has yet to end.
  /// internal: internal node of each surface node.
  void put(const Candidates& found, const std::vector<int>& extra, const std::vector<int>& internal) {
    groups_ = found.group_count();
    slots_ = found.slot_count();
    candidates_ = static_cast<std::int64_t>(found.facets.size() + found.edge_pairs.size());
    group_node_.put(found.group_node);
    group_begin_.put(found.group_begin);
    facets_.put(found.facets);
    host_reals_.assign(found.bias.begin(), found.bias.end());
    bias_.put(host_reals_);
    host_pairs_.clear();
    for (const auto& [a, b] : found.edge_pairs) host_pairs_.insert(host_pairs_.end(), {a, b});
    pairs_.put(host_pairs_);
    host_reals_.assign(found.group_friction.begin(), found.group_friction.end());
    host_reals_.insert(host_reals_.end(), found.edge_friction.begin(), found.edge_friction.end());
    friction_.put(host_reals_);
    host_reals_.assign(found.group_entry.begin(), found.group_entry.end());
    host_reals_.insert(host_reals_.end(), found.edge_entry.begin(), found.edge_entry.end());
    entry_.put(host_reals_);
    put_touches(found);
    put_nodes(found, extra, internal);
  }
  int groups() const { return groups_; }
  std::int64_t candidates() const { return candidates_; }  ///< node-facet and edge-edge pairs
  int slots() const { return slots_; }
  int node_count() const { return static_cast<int>(host_nodes_.size()); }
  const std::vector<int>& host_nodes() const { return host_nodes_; }
  const int* internal_nodes() const { return internal_.get(); }
  Touch<R>* touches() const { return touches_.get(); }
  const unsigned char* used() const { return used_.get(); }

  FindFacetTouch<R> find_facets(const SurfaceView<R>& surface, const TouchLimits<R>& limits, R swept) const {
    return {surface,      group_node_.get(), group_begin_.get(), facets_.get(), bias_.get(), friction_.get(),
            entry_.get(), touches_.get(),    used_.get(),        limits,        swept};
  }
  FindEdgeTouch<R> find_edges(const SurfaceView<R>& surface, const TouchLimits<R>& limits) const {
    return {surface,
            edges_.get(),
            pairs_.get(),
            friction_.get() + groups_,
            entry_.get() + groups_,
            touches_.get() + groups_,
            used_.get() + groups_,
            limits};
  }
  PushedNodes<R> pushed() const {
    return {nodes_.get(),  entry_of_.get(),   incident_begin_.get(), incident_.get(),
            pushes_.get(), push_count_.get(), share_.get(),          mobility_.get(),
            guess_.get(),  moved_.get(),      deepest_.get(),        force_.get()};
  }
  PressingTouches<R> pressing(bool rub) const {
    return {touches_.get(), used_.get(), pressing_.get(), rub ? rubbing_.get() : nullptr, push_.get()};
  }
  DealtTouches<R> dealt(int part_count, int* touch_count) const {
    return {dealt_slots_.get(), touch_count,        dealt_entry_.get(), dealt_pushed_.get(), place_of_.get(),
            dealt_end_.get(),   dealt_found_.get(), part_count,         node_count(),        slots_};
  }
  FoundForce<R> found_force() const { return {nodes_.get(), force_.get(), last_.get()}; }
  /// What the next step needs to know of each slot.
  struct Memory {
    R pressing = R(0);  ///< the multiplier, which it starts from [N]
    R came = R(0);      ///< TouchSide; a number like the other, so that nothing saved is padding
  };
  std::vector<Memory> memory() const {
    std::vector<Touch<R>> touches(host_keys_.size());
    if (!touches.empty()) backend_.copy_out(touches_.get(), touches.data(), touches.size());
    std::vector<Memory> result;
    for (const Touch<R>& t : touches) result.push_back({t.pressing, R(t.came)});
    return result;
  }
  void set_memory(const std::vector<Memory>& memory) {
    host_touches_.assign(memory.size(), Touch<R>{});
    for (std::size_t c = 0; c < memory.size(); ++c) {
      host_touches_[c].pressing = memory[c].pressing;
      host_touches_[c].came = static_cast<int>(memory[c].came);
    }
    touches_.put(host_touches_);
    used_.put(std::vector<unsigned char>(memory.size(), 0));
  }
  /// What a step changes in the slots and nodes.
  struct Kept {
    std::vector<Touch<R>> touches;
    std::vector<unsigned char> used;
    std::vector<Vec4<R>> force;
    std::vector<R> deepest;
  };
  Kept keep() const {
    Kept kept{std::vector<Touch<R>>(std::size_t(slots_)), std::vector<unsigned char>(std::size_t(slots_)),
              std::vector<Vec4<R>>(host_.size()), std::vector<R>(host_.size())};
    if (slots_ > 0) backend_.copy_out(touches_.get(), kept.touches.data(), kept.touches.size());
    if (slots_ > 0) backend_.copy_out(used_.get(), kept.used.data(), kept.used.size());
    backend_.copy_out(force_.get(), kept.force.data(), kept.force.size());
    backend_.copy_out(deepest_.get(), kept.deepest.data(), kept.deepest.size());
    return kept;
  }
  void restore(const Kept& kept) {
    touches_.put(kept.touches);
    used_.put(kept.used);
    backend_.copy_in(kept.force.data(), force_.get(), kept.force.size());
    backend_.copy_in(kept.deepest.data(), deepest_.get(), kept.deepest.size());
  }
  const Buffer<Vec4<R>>& force() const { return force_; }
  const Buffer<Vec4<R>>& last() const { return last_; }
  const Buffer<R>& deepest() const { return deepest_; }
  /// Surface nodes that were pushed in the last step, rising; or in the last one whose work was counted.
  void still_pushed(std::vector<int>& nodes) {
    std::vector<Vec4<R>>& its = host_;
    nodes.clear();
    for (const Buffer<Vec4<R>>* forces : {&force_, &last_}) {
      backend_.copy_out(forces->get(), its.data(), its.size());
      for (std::size_t k = 0; k < its.size(); ++k)
        if (its[k].x != R(0) || its[k].y != R(0) || its[k].z != R(0)) nodes.push_back(static_cast<int>(k));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }

 private:
  static std::vector<EdgeCorners> edges_of(const ContactMesh& mesh) {
    std::vector<EdgeCorners> result;
    for (const ContactEdge& e : mesh.edges)
      result.push_back({{e.node[0], e.node[1]}, {e.opposite[0], e.opposite[1]}});
    return result;
  }
  using Key = std::array<int, 3>;  ///< of a slot: what meets what, rising like the slots
  static void append_keys(const Candidates& found, std::vector<Key>& keys) {
    for (std::size_t g = 0; g < found.group_node.size(); ++g)
      keys.push_back({0, found.group_node[g], found.group_region[g]});
    for (const auto& [a, b] : found.edge_pairs) keys.push_back({1, a, b});
  }
  /// Contacts that were candidates before keep their memory.
  void put_touches(const Candidates& found) {
    const std::vector<Memory> before = memory();
    host_old_keys_.swap(host_keys_);
    host_keys_.clear();
    append_keys(found, host_keys_);
    host_memory_.assign(host_keys_.size(), {});
    std::size_t old = 0;
    for (std::size_t c = 0; c < host_keys_.size(); ++c) {
      while (old < before.size() && host_old_keys_[old] < host_keys_[c]) ++old;
      if (old < before.size() && host_old_keys_[old] == host_keys_[c]) host_memory_[c] = before[old];
    }
    set_memory(host_memory_);
  }
  /// Merges both rising lists; the extra ones have no slots.
  void put_nodes(const Candidates& found, const std::vector<int>& extra, const std::vector<int>& internal) {
    host_nodes_.clear();
    host_begin_.assign(1, 0);
    std::size_t i = 0, j = 0;
    while (i < found.nodes.size() || j < extra.size()) {
      const bool pushed = i < found.nodes.size() && (j == extra.size() || found.nodes[i] <= extra[j]);
      const int node = pushed ? found.nodes[i] : extra[j];
      if (j < extra.size() && extra[j] == node) ++j;
      host_nodes_.push_back(node);
      if (pushed) ++i;
      host_begin_.push_back(found.incident_begin[i]);
    }
    host_internal_.clear();
    for (const int k : host_nodes_) host_internal_.push_back(internal[std::size_t(k)]);
    nodes_.put(host_nodes_);
    internal_.put(host_internal_);
    incident_begin_.put(host_begin_);
    incident_.put(found.incident);
    pushes_.resize(found.incident.size());
    if (B::space == Space::host) dealt_found_.resize(found.incident.size());
    const std::size_t packs = (std::size_t(slots_) + touches_abreast - 1) / touches_abreast;
    dealt_slots_.resize(packs * touches_abreast);
    push_.resize(packs * touches_abreast);
    pressing_.resize(packs);
    rubbing_.resize(packs);
    for (auto* by_entry : {&push_count_, &dealt_entry_, &dealt_pushed_, &dealt_end_})
      by_entry->resize(host_nodes_.size());
    share_.resize(host_nodes_.size());
    for (auto* rows : {&mobility_, &guess_, &moved_}) rows->resize(host_nodes_.size());
    host_entry_.assign(host_.size(), 0);
    for (std::size_t e = 0; e < host_nodes_.size(); ++e)
      host_entry_[std::size_t(host_nodes_[e])] = static_cast<int>(e);
    backend_.copy_in(host_entry_.data(), entry_of_.get(), host_entry_.size());
  }

  B& backend_;
  int groups_ = 0, slots_ = 0;
  std::int64_t candidates_ = 0;
  Buffer<EdgeCorners> edges_;
  Resizable<B, int> group_node_, group_begin_, facets_, pairs_, nodes_, internal_, incident_begin_, incident_,
      push_count_, dealt_slots_, dealt_entry_, dealt_pushed_, dealt_end_;
  Resizable<B, Push<R>> pushes_;
  Resizable<B, DealtPush<R>> dealt_found_;
  Resizable<B, R> share_;
  Resizable<B, Vec4<R>> mobility_, guess_, moved_, push_;
  Resizable<B, R> bias_, friction_, entry_;
  Resizable<B, Touch<R>> touches_;
  Resizable<B, unsigned char> used_;
  Resizable<B, PressingPack<R>> pressing_;
  Resizable<B, RubbingPack<R>> rubbing_;
  Buffer<int> entry_of_, place_of_;  ///< [surface nodes], like those below
  Buffer<R> deepest_;
  Buffer<Vec4<R>> force_, last_;
  std::vector<Vec4<R>> host_;
  std::vector<int> host_nodes_, host_begin_, host_internal_, host_entry_, host_pairs_;
  std::vector<R> host_reals_;
  std::vector<Memory> host_memory_;
  std::vector<Touch<R>> host_touches_;
  std::vector<Key> host_keys_, host_old_keys_;
};

}  // namespace glisson::contact
