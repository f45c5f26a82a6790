// The solid elements of up to W members that share a mesh: one element loop computes all of them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/solids/host_blocks.hpp>
#include <glisson/core/solids/solid_forces.hpp>
#include <glisson/cpu/ensemble/lane_table.hpp>

namespace glisson::lanes {

/// "auto": the widest of this machine. Throws like patches::choose_instruction_set.
const LaneTable& choose_lane_table(const std::string& instruction_set);

/// What one member wants to know.
struct Request {
  enum class Kind { none, forces, strain_energy, hourglass_energy };
  Kind kind = Kind::none;
  StepView<float> view;
  double energy = 0;  ///< the answer [J]
};

/// Members may share a group when their host blocks differ in values only: same laws, formulations and
/// numbers of Prony terms. Throws Error(input) for a member with another mesh.
class LaneSolids {
 public:
  /// models: one per lane, at most the width.
  LaneSolids(const LaneTable& table, const std::vector<const Model*>& models, const Numbering& numbering);
  ~LaneSolids();

  /// Answers all requests of a kind at once; requests: one per lane of the constructor.
  void answer(Request::Kind kind, std::span<Request> requests);
  std::vector<double> history(int lane) const;
  void set_history(int lane, const std::vector<double>& history);
  std::size_t memory_bytes() const;

 private:
  struct Block;
  void load(Request::Kind kind, std::span<const Request> requests);
  void set_rates(std::span<const Request> requests);
  void average_pressure();

  const LaneTable& table_;
  int node_count_, lane_count_;
  std::vector<Block> blocks_;
  AverageLists<float> average_;
  struct Arrays;
  std::unique_ptr<Arrays> arrays_;
  LanePass pass_;
};

/// Members with equal keys fit into one group.
std::string group_key(const Model& model);

}  // namespace glisson::lanes
