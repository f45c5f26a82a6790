// Up to W members on one thread: each runs its own time loop on a fiber of its own; where the loop asks for
// element forces it pauses, and when all have asked they are computed together.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glisson/cpu/ensemble/lane_solids.hpp>
#include <glisson/cpu/ensemble/member_loop.hpp>

namespace glisson::lanes {

/// Makes the ordinary simulation of a model around the given solids.
using MakeMember =
    std::function<std::unique_ptr<AnySimulation>(const Model&, std::unique_ptr<SolidForces<float>>)>;

class LaneGroup {
 public:
  /// The models must outlive the group.
  LaneGroup(const LaneTable& table, const std::vector<const Model*>& models, const Numbering& numbering,
            MakeMember make);
  ~LaneGroup();
  LaneGroup(const LaneGroup&) = delete;
  LaneGroup& operator=(const LaneGroup&) = delete;

  /// Advances every member that runs by `count` steps, 0: only sets it up. Touches nothing outside the group,
  /// so that groups run on different threads.
  void step(std::int64_t count);
  MemberStatus status(int lane) const;
  const std::string& error(int lane) const;
  AnySimulation* simulation(int lane) const;  ///< nullptr if it could not be set up
  std::size_t memory_bytes() const;

 private:
  class Solids;
  void answer(Request::Kind kind);
  bool waiting(Request::Kind kind) const;

  LaneSolids solids_;
  MakeMember make_;
  std::vector<Request> requests_;
  std::vector<std::unique_ptr<MemberLoop>> members_;
};

}  // namespace glisson::lanes
