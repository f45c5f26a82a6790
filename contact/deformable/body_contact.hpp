// Contact of deformable bodies with each other and with themselves (Johnsen 2016, chapter 5) as a provider of
// a backend. Include it only where a backend is instantiated.
//
// A step: positions as predicted; one contact at most per slot; forces of all contacts together. Candidates
// come from a bounding volume hierarchy, which devices refit and search themselves, and hold until a node has
// moved farther than `room`; the host lists them. All sums have a fixed order.
#pragma once

#include <chrono>
#include <memory>

#include <glisson/contact/bvh/device_search.hpp>
#include <glisson/contact/deformable/candidate_lists.hpp>
#include <glisson/contact/deformable/contact_loops.hpp>
#include <glisson/contact/deformable/load_jumps.hpp>
#include <glisson/contact/deformable/prescribed_motion.hpp>
#include <glisson/contact/deformable/start_overlap.hpp>
#include <glisson/contact/deformable/surface_state.hpp>
#include <glisson/core/base/number_text.hpp>
#include <glisson/core/contact_report.hpp>

namespace glisson::contact {

constexpr int contact_iterations = 10;  // touch.hpp says why
/// After how many steps a device's host looks again at the latest.
constexpr int most_quiet_steps = 8;

/// Devices find the pairs themselves. The backend must outlive the result.
template <Backend B>
PairSource pair_source(B& backend, const ContactMesh& mesh, const ContactRules& rules,
                       const Hierarchy& hierarchy) {
  if constexpr (B::space == Space::host) {
    return {};
  } else {
    const SearchRegions regions{mesh.region, static_cast<int>(mesh.part_of_region.size()),
                                [&](int a, int b) { return rules.may_touch(a, b); }};
    auto search = std::make_shared<DeviceSearch<B>>(backend, hierarchy, mesh.triangles, regions);
    return [search](const std::vector<Vec3<double>>& x, double margin, double threshold, Pairs& found) {
      search->find(x, margin, threshold, found);
    };
  }
}

template <Backend B, class R>
class BodyContact final : public ForceProvider<R>, public ContactSource {
 public:
  /// The backend must outlive it. parts: who shares the searches; loops: of this machine. Throws Error(input)
  /// for a surface without an inside, a pair that names no body and bodies that start in each other too deep.
  BodyContact(B& backend, const Model& model, const Numbering& numbering, HostParts parts = {},
              const ContactLoops<R>& loops = {})
      : backend_(backend),
        mesh_(contact_mesh(model, numbering)),
        rules_(model, mesh_),
        distances_(contact_distances(model.contact, mesh_)),
        search_(mesh_, rules_, distances_.reach),
        parts_(std::move(parts)),
        loops_(loops),
        pair_source_(pair_source(backend, mesh_, rules_, search_.hierarchy())),
        start_depth_(start_depth(mesh_, rules_, distances_, search_.hierarchy())),
        prescribed_(model),
        loads_(model),
        surface_(backend, mesh_, model, numbering),
        lists_(backend, mesh_),
        work_(backend, mesh_.node_count()) {
    if (distances_.penalty > 0) refuse_start_depth();
    for (const int n : mesh_.nodes) internal_.push_back(detail::internal_node(numbering, n));
  }

  std::string_view name() const override { return "contact of deformable bodies"; }
  Space space() const override { return B::space; }
  bool needs_prediction() const override { return true; }
  std::vector<int> nodes_to_predict() const override { return internal_; }
  /// A node that something rigid holds would otherwise seem to move as fast as it is pressed against it.
  bool needs_forces_before() const override { return true; }
  double work() const override { return work_.total(); }

  void add_forces(const StepView<R>& step) override {
    if (!step.advance) return add_next_forces(step);
    const auto start = std::chrono::steady_clock::now();
    surface_.place(step, lists_.force().get(), !leaves_points());
    surface_.keep_extent();
    if (steps_to_look_ > 0)
      --steps_to_look_;
    else
      look(step);
    if (!lost_) resolve(motion_);
    work_.run(step, lists_.internal_nodes(), lists_.found_force(), lists_.node_count());
    seconds_ += since(start);
  }

  ContactReport report() const override;
  void add_node_forces(std::vector<Vec3<double>>& f) const override {
    std::vector<Vec4<R>> last(internal_.size());
    backend_.copy_out(lists_.force().get(), last.data(), last.size());
    for (std::size_t k = 0; k < last.size(); ++k) {
      Vec3<double>& sum = f[std::size_t(internal_[k])];
      sum = sum + Vec3<double>{double(last[k].x), double(last[k].y), double(last[k].z)};
    }
  }
  std::vector<std::byte> save() const override;
  void load(std::span<const std::byte> bytes) override;

 private:
  void refuse_start_depth() const {
    if (!(start_depth_ > distances_.slack)) return;
    throw Error(ErrorKind::input,
                "bodies start " + number_text(start_depth_) +
                    " in each other, and penalty forces would throw them apart; move them apart, or use "
                    "multipliers, which resolve it in several steps",
                {"", 0, contact_place});
  }
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  /// The forces that the next step will find with the candidates of the last one; leaves no trace.
  void add_next_forces(const StepView<R>& step) {
    const auto kept = lists_.keep();
    surface_.place(step, lists_.force().get(), !leaves_points());
    const double motion = steps_to_look_ > 0 ? motion_ : std::sqrt(double(surface_.extent().motion));
    if (!lost_ && std::isfinite(motion)) resolve(motion);
    work_.run(step, lists_.internal_nodes(), lists_.found_force(), lists_.node_count());
    lists_.restore(kept);
  }
  /// Searches if a node went too far.
  void look(const StepView<R>& step) {
    const Extent<R> extent = surface_.extent();
    surface_.forget_extent();
    ++looks_;
    lost_ = !std::isfinite(double(extent.motion));  // the energy account names the node
    if (lost_) return;
    const double motion = std::sqrt(double(extent.motion));
    const double growth = std::max(0.0, (motion - motion_) / (quiet_steps_ + 1));
    motion_ = motion;
    double drift = extent.drift();
    if (!listed_ || !(drift < room_)) {
      if (leaves_points()) surface_.place(step, lists_.force().get(), true);
      search(motion_);
      drift = 0;
    }
    quiet_steps_ = steps_to_look_ = B::space == Space::host ? 0 : quiet_steps(step, room_ - drift, growth);
  }
  /// Steps without a look, for which a device has to wait; hosts need none.
  /// growth: of the motion in a step since the look before [m]
  int quiet_steps(const StepView<R>& step, double left, double growth) const {
    int steps = most_quiet_steps;
    while (steps > 0 && !stays_quiet(step, left, growth, steps)) --steps;
    return steps;
  }
  /// Whether no node uses up what is left of the room, or could pass a facet unseen, in so many steps: at
  /// twice the speed, with what it gained since the last look, and where its motion is prescribed.
  bool stays_quiet(const StepView<R>& step, double left, double growth, int steps) const {
    const double dt = step.t_next - step.t, motion = motion_ + steps * growth;
    // after a fast step there may be room for more than a facet is looked for behind it
    return 8 * motion <= distances_.reach && 2 * steps * motion <= left &&
           prescribed_.ahead(step.t_next, dt, steps) <= std::min(left, 0.5 * distances_.reach) &&
           !loads_.within(step.t, dt, steps);
  }
  bool leaves_points() const { return listed_ && surface_.may_leave_points(); }
  /// Candidates for nodes that move some such steps or `room` without another search.
  void search(double motion) {
    const auto start = Clock::now();
    room_ = std::max(distances_.room, distances_.steps * motion);
    surface_.mark();
    lists_.still_pushed(extra_);
    list(extra_);
    search_seconds_ += since(start);
  }
  void list(const std::vector<int>& extra) {
    surface_.reference_to(x_);
    const double margin = room_ * distances_.swing + 0.5 * distances_.reach;
    const Candidates& found = search_.find(x_, margin, parts_, pair_source_);
    lists_.put(found, extra, internal_);
    surface_.want(lists_.host_nodes(), found);
    listed_ = true;
  }
  /// motion: of the fastest node in the step [m]
  void resolve(double motion) {
    const SurfaceView<R> surface = surface_.view();
    const TouchLimits<R> limits{R(distances_.reach), R(distances_.offset), R(distances_.close),
                                R(distances_.slack), R(distances_.penalty)};
    const int slots = lists_.slots();
    if (lists_.node_count() == 0) return;
    const double swept = 4 * motion > distances_.reach ? 2 * distances_.swing * motion + distances_.slack : 0;
    const auto start = Clock::now();
    run_loops(backend_, long(FindFacetTouch<R>::cost) * slots, [&](auto&& loop) {
      loop_ranged(loop, lists_.groups(), lists_.find_facets(surface, limits, R(swept)), loops_.find_facets);
      loop(slots - lists_.groups(), lists_.find_edges(surface, limits));
    });
    touch_seconds_ += since(start);
    const auto found = Clock::now();
    iterate(surface);
    force_seconds_ += since(found);
  }
  /// All multipliers of the touches that were found.
  void iterate(const SurfaceView<R>& surface) {
    const PushedNodes<R> nodes = lists_.pushed();
    const PressingTouches<R> touches = lists_.pressing(rules_.any_friction());
    const ListPushes<R> list{nodes, touches, surface};
    run_loops(backend_, long(PushTouches<R>::cost) * touch_count_, [&](auto&& loop) {
      if constexpr (B::space == Space::host) {
        const DealtTouches<R> dealt = lists_.dealt(loop.team_size, &touch_count_);
        DealtCounts count;
        loop(loop.team_size, DealTouches<R>{list, dealt, &count});
        loop(count.packs() * touches_abreast,
             StartPressing<R>{touches, dealt.slots, nodes.entry, dealt.place, nodes.share});
        const auto push = [&](const PushTouches<R>& its) {
          loop_ranged(loop, count.packs(), PushDealt<R>{its.template with_lanes<FacetLanes<R>>()},
                      loops_.push);
        };
        const auto move = [&](const MovePushed<R>& its) {
          loop_ranged(loop, loop.team_size, MoveDealt<R>{its, dealt, count}, loops_.move);
        };
        iterate(touches, nodes, push, move);
      } else {
        loop(lists_.node_count(), list);
        loop(lists_.slots(), StartPressing<R>{touches, nullptr, nodes.entry, nodes.entry, nodes.share});
        const auto push = [&](const PushTouches<R>& its) { loop(lists_.slots(), its); };
        const auto move = [&](const MovePushed<R>& its) { loop(lists_.node_count(), its); };
        iterate(touches, nodes, push, move);
      }
    });
  }
  template <class RunPush, class RunMove>
  void iterate(const PressingTouches<R>& touches, const PushedNodes<R>& nodes, const RunPush& push,
               const RunMove& move) const {
    const bool penalty = distances_.penalty > 0;
    const int iterations = penalty && !rules_.any_friction() ? 1 : contact_iterations;
    if (!penalty) move({nodes, touches.push, false});  // by the multipliers of the last step
    double momentum = 1;  // Nesterov's t
    for (int i = 0; i < iterations; ++i) {
      const bool last = i + 1 == iterations;
      const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
      const double ahead = last ? 0 : (momentum - 1) / next;
      const double share = !penalty ? 1 : i == 0 ? distances_.penalty : 0;
      momentum = next;
      push({touches, nodes.moved, R(ahead), R(share), last ? lists_.touches() : nullptr});
      move({nodes, touches.push, last});
    }
  }

  B& backend_;
  ContactMesh mesh_;
  ContactRules rules_;
  ContactDistances distances_;
  CandidateSearch search_;
  HostParts parts_;
  ContactLoops<R> loops_;
  PairSource pair_source_;
  double start_depth_;
  PrescribedMotion prescribed_;
  LoadJumps loads_;
  SurfaceState<B, R> surface_;
  CandidateLists<B, R> lists_;
  ListWork<B, R> work_;
  std::vector<int> internal_;  ///< internal node of each surface node
  std::vector<int> extra_;
  std::vector<Vec3<double>> x_;
  bool listed_ = false, lost_ = false;
  double room_ = 0;    ///< of the present candidates [m]
  double motion_ = 0;  ///< of the fastest node in a step, when somebody looked last [m]
  int steps_to_look_ = 0;
  int quiet_steps_ = 0;  ///< what it was at the last look
  int touch_count_ = 0;  ///< of the last step, on hosts
  std::int64_t looks_ = 0;
  double seconds_ = 0, search_seconds_ = 0, touch_seconds_ = 0, force_seconds_ = 0;
};

template <Backend B, class R>
ContactReport BodyContact<B, R>::report() const {
  ContactReport report;
  const std::size_t slots = std::size_t(lists_.slots());
  std::vector<Touch<R>> touches(slots);
  std::vector<unsigned char> used(slots);
  if (slots > 0) backend_.copy_out(lists_.touches(), touches.data(), slots);
  if (slots > 0) backend_.copy_out(lists_.used(), used.data(), slots);
  for (std::size_t c = 0; c < slots; ++c) {
    if (!used[c]) continue;
    report.depth = std::max(report.depth, -double(touches[c].before));
    report.node_count += touches[c].pressing > R(0);
  }
  std::vector<R> deepest(internal_.size());
  backend_.copy_out(lists_.deepest().get(), deepest.data(), deepest.size());
  for (const R depth : deepest) report.largest_depth = std::max(report.largest_depth, double(depth));
  report.start_depth = start_depth_;
  const SearchCounts& counts = search_.counts();
  report.between_bodies = true;
  report.search = {search_.hierarchy().node_count(),
                   counts.searches,
                   looks_,
                   counts.volumes_refitted,
                   counts.subtrees_tested,
                   counts.triangle_pairs,
                   lists_.candidates(),
                   counts.refit_seconds,
                   counts.pair_seconds,
                   counts.list_seconds,
                   search_seconds_,
                   touch_seconds_,
                   force_seconds_,
                   seconds_};
  return report;
}

/// The candidates are found again from the positions that they were found from.
template <Backend B, class R>
std::vector<std::byte> BodyContact<B, R>::save() const {
  std::vector<std::uint8_t> listed(internal_.size(), 0);
  for (const int k : lists_.host_nodes()) listed[std::size_t(k)] = 1;
  detail::ByteWriter out;
  out.value(std::int64_t(listed_)).value(room_).value(motion_);
  out.value(std::int64_t(steps_to_look_)).value(std::int64_t(quiet_steps_));
  for (const std::uint8_t its : listed) out.value(its);
  surface_.save(out);
  out.buffer(backend_, lists_.force(), internal_.size())
      .buffer(backend_, lists_.last(), internal_.size())
      .buffer(backend_, lists_.deepest(), internal_.size());
  work_.save(out);
  for (const auto& slot : lists_.memory()) out.value(slot);
  return out.take();
}

template <Backend B, class R>
void BodyContact<B, R>::load(std::span<const std::byte> bytes) {
  detail::ByteReader in(bytes, std::string(name()));
  std::int64_t listed = 0, steps_to_look = 0, quiet_steps = 0;
  in.value(listed);
  in.value(room_);
  in.value(motion_);
  in.value(steps_to_look);
  in.value(quiet_steps);
  steps_to_look_ = static_cast<int>(steps_to_look);
  quiet_steps_ = static_cast<int>(quiet_steps);
  std::vector<int> nodes;
  for (std::size_t k = 0; k < internal_.size(); ++k) {
    std::uint8_t its = 0;
    in.value(its);
    if (its) nodes.push_back(static_cast<int>(k));
  }
  surface_.load(in);
  in.buffer(backend_, lists_.force(), internal_.size());
  in.buffer(backend_, lists_.last(), internal_.size());
  in.buffer(backend_, lists_.deepest(), internal_.size());
  work_.load(in);
  if (listed) list(nodes);
  std::vector<typename CandidateLists<B, R>::Memory> memory(std::size_t(lists_.slots()));
  for (auto& slot : memory) in.value(slot);
  in.end();
  lists_.set_memory(memory);
}

}  // namespace glisson::contact
