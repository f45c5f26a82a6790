// Nodes with the constraints of a model on a backend. Backend and precision are a value: what depends on them
// is compiled in constrained_nodes.cpp only.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glisson/core/model.hpp>

#include "tests/core/bench_nodes.hpp"

namespace glisson {

class ConstrainedNodes : public BenchNodes {
 public:
  using BenchNodes::BenchNodes;
  virtual ~ConstrainedNodes() = default;

  /// Takes the model's constraints instead of those before.
  virtual void constrain(const Model& model) = 0;
  /// Constrains u and v.
  virtual void apply(double t_next, double dt) = 0;
  /// Constrains v.
  virtual void project() = 0;
  /// Sets f to these forces and the reactions to them in the central difference's step from t.
  virtual void react(const std::vector<Vec3<double>>& forces, double t, double t_next, double dt) = 0;
  virtual double work() const = 0;
  virtual std::vector<std::byte> save() const = 0;
  virtual void load(std::span<const std::byte> bytes) = 0;
};

std::unique_ptr<ConstrainedNodes> constrained_nodes(BenchCase row, int count, double mass = 1);

}  // namespace glisson
