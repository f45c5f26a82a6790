// Nodes with the loads of models on a backend. Backend and precision are a value: what depends on them is
// compiled in loaded_nodes.cpp only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glisson/core/force_provider.hpp>
#include <glisson/core/model.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson {

/// A load on a backend. It takes steps that its nodes have made, and of these only numbers, no arrays.
class BenchLoad : public ForceProvider<double> {
 public:
  virtual double stiffness_amplitude() const = 0;  ///< of springs [-]
};
using BenchLoads = std::vector<std::unique_ptr<BenchLoad>>;

class LoadedNodes : public BenchNodes {
 public:
  using BenchNodes::BenchNodes;
  virtual ~LoadedNodes() = default;

  /// In the order of make_loads. mass: what gravity acts on, in internal order [kg]  [node_count]
  virtual BenchLoads loads(const Model& model, std::span<const double> mass) = 0;
  BenchLoads loads(const Model& model) { return loads(model, masses); }
  std::unique_ptr<BenchLoad> load(const NodalForce& force);
  std::unique_ptr<BenchLoad> load(const Gravity& gravity, std::span<const double> mass);
  std::unique_ptr<BenchLoad> load(const Springs& springs);
  std::unique_ptr<BenchLoad> load(const Pressure& pressure, const Mesh& mesh);
  std::unique_ptr<BenchLoad> load(const Traction& traction, const Mesh& mesh);

  /// The step that the backend would see for these u and v; f starts at 0.
  virtual StepView<double> view(double t, double dt) = 0;
  /// f after the load has added to it.
  virtual const std::vector<Vec3<double>>& forces(BenchLoad& load, const StepView<double>& step) = 0;
  const std::vector<Vec3<double>>& forces(BenchLoad& load, double t = 1) { return forces(load, view(t, 1)); }
};

std::unique_ptr<LoadedNodes> loaded_nodes(BenchCase row, int count, double mass = 1);

}  // namespace glisson
