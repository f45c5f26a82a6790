// All analytic rigid bodies of a model as contact providers of a backend. Include it only where a backend is
// instantiated.
#pragma once

#include <memory>
#include <vector>

#include <glisson/contact/analytic/body_overlap.hpp>
#include <glisson/contact/analytic/rigid_contact.hpp>
#include <glisson/contact/shell_thickness.hpp>

namespace glisson::contact {

/// The backend must outlive the result; the model need not. Every provider is also a ContactSource. The node
/// masses, if given, are not needed: the inertial ones come with each step (v.w). Throws Error(input) when
/// nodes start deep in a body.
template <Backend B, class R>
std::vector<std::unique_ptr<ForceProvider<R>>> make_rigid_bodies(B& backend, const Model& model,
                                                                 const Numbering& numbering,
                                                                 std::span<const double> = {}) {
  std::vector<std::unique_ptr<ForceProvider<R>>> result;
  if (model.bodies.empty()) return result;
  const std::vector<double> half = half_thickness_at_nodes(model);
  const auto add = [&]<class Shape>(const RigidBody& body, Shape) {
    const RigidMotion motion(body);
    const std::vector<int> nodes = candidate_nodes(body.nodes, model.mesh);
    StartRelease<B, R> start(backend, start_depths(motion, nodes, model.mesh), nodes, numbering, model.time);
    const std::vector<double> gaps = gaps_to_keep(motion, nodes, half, model.mesh);
    result.push_back(std::make_unique<RigidContact<B, R, Shape>>(backend, motion, nodes, gaps,
                                                                 std::move(start), model.mesh, numbering));
  };
  for (const RigidBody& body : model.bodies) switch (body.shape) {
      case RigidShape::plate:
        add(body, Plate<R>{});
        break;
      case RigidShape::cylinder:
        add(body, Cylinder<R>{});
        break;
      case RigidShape::probe:
        add(body, Probe<R>{});
        break;
    }
  return result;
}

}  // namespace glisson::contact
