// What starts a little behind something rigid comes out evenly: in one step it would leave with a speed that
// nothing has.
#pragma once

#include <algorithm>
#include <vector>

#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>
#include <glisson/core/model.hpp>

namespace glisson::contact {

/// For loop bodies: how deep nodes may be at the end of the step.
template <class R>
struct AllowedDepth {
  const R* start = nullptr;  ///< how deep they start [m]  [entry_count]; null: none may be behind
  R share = R(0);            ///< of that which they may still be

  GLISSON_HD R operator()(int i) const { return start != nullptr ? share * start[i] : R(0); }
};

/// Takes that away with equal speed over the first tenth of the run, or of the ramp of a quasi-static one. It
/// follows from the time alone, so that a restart needs nothing of it.
template <Backend B, class R>
class StartRelease {
 public:
  /// depth: of all nodes of the mesh at the start, 0 in front [m]; nodes: those that may touch, in any order
  StartRelease(B& backend, const std::vector<double>& depth, const std::vector<int>& nodes,
               const Numbering& numbering, const TimeSettings& time)
      : until_(0.1 * (time.total > 0 || !time.quasi_static ? time.total : pseudo_time)) {
    for (const int n : nodes) deepest_ = std::max(deepest_, depth[std::size_t(n)]);
    if (deepest_ > 0) depth_ = detail::upload(backend, entries_of(depth, nodes, numbering));
  }

  double deepest() const { return deepest_; }  ///< at the start [m]
  AllowedDepth<R> at(double t) const {
    if (!(deepest_ > 0 && t < until_)) return {};
    return {depth_.get(), R(1 - t / until_)};
  }

 private:
  static std::vector<R> entries_of(const std::vector<double>& depth, const std::vector<int>& nodes,
                                   const Numbering& numbering) {
    const auto by_node = detail::by_node<R>(
        numbering, nodes, [&](std::size_t k) { return R(depth[std::size_t(nodes[k])]); }, [](R&, R) {});
    std::vector<R> result;
    for (const auto& [node, its] : by_node) result.push_back(its);
    return result;
  }

  double until_, deepest_ = 0;
  Buffer<R> depth_;
};

}  // namespace glisson::contact
