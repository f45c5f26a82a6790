// Loads, constraints, bodies and time settings: lists within the mesh, values that fit them, curves that can
// be evaluated.
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::detail {
namespace {

bool finite(const Vec3<double>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool finite(double v) { return std::isfinite(v); }

class LoadChecks {
 public:
  LoadChecks(const Model& model, std::string where) : model_(model), where_(std::move(where)) {}

  void nodes(const std::vector<int>& list, bool empty_is_all = false) const {
    if (list.empty() && !empty_is_all)
      refuse(where_, "its selection of nodes is empty, so it would act on nothing");
    for (const int n : list) node(n);
  }
  void facets(const std::vector<Facet>& list) const {
    if (list.empty()) refuse(where_, "its selection of facets is empty, so it would act on nothing");
    for (const auto& facet : list) {
      for (int a = 0; a < facet.node_count(); ++a) node(facet.nodes[static_cast<std::size_t>(a)]);
      if (facet.element < -1 || facet.element >= model_.mesh.element_count())
        refuse(where_, "a facet names element " + std::to_string(facet.element) + ", which does not exist");
    }
  }
  void axes(Axes mask) const {
    if (mask < 1 || mask > all_axes) refuse(where_, "it acts along no axis");
  }
  template <class T>
  void values(const std::vector<T>& list, std::size_t count) const {
    if (list.size() != 1 && list.size() != count)
      refuse(where_, "it has " + std::to_string(list.size()) + " values for " + std::to_string(count) +
                         " nodes or facets; give 1 or as many");
    for (const auto& value : list) is_finite(value);
  }
  template <class T>
  void is_finite(const T& value) const {
    if (!finite(value)) refuse(where_, "one of its numbers is not finite");
  }
  void curve(const LoadCurve& c) const {
    if (!std::isfinite(c.start) || !std::isfinite(c.end) || c.end < c.start)
      refuse(where_,
             "its time interval " + number_text(c.start) + " to " + number_text(c.end) + " is not one");
    if (c.shape != LoadShape::table) return;
    if (c.table.empty()) refuse(where_, "its load table is empty");
    for (std::size_t i = 0; i < c.table.size(); ++i) {
      is_finite(c.table[i].first);
      is_finite(c.table[i].second);
      if (i > 0 && !(c.table[i].first > c.table[i - 1].first))
        refuse(where_, "the times of its load table do not increase");
    }
  }
  void unit(const Vec3<double>& v, const char* name) const {
    is_finite(v);
    if (std::abs(dot(v, v) - 1) > 1e-6) refuse(where_, std::string("its ") + name + " is not a unit vector");
  }
  const std::string& where() const { return where_; }

 private:
  void node(int n) const {
    if (n < 0 || n >= model_.mesh.node_count())
      refuse(where_, "it names node " + std::to_string(n) + ", but the nodes are 0 to " +
                         std::to_string(model_.mesh.node_count() - 1));
  }
  const Model& model_;
  std::string where_;
};

template <class List, class Check>
void check_each(const Model& model, const std::string& kind, const List& list, Check check) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::string where = kind + " " + std::to_string(i);
    if constexpr (requires { list[i].name; })
      if (!list[i].name.empty()) where = list[i].name;  // with its line in the file
    check(LoadChecks(model, std::move(where)), list[i]);
  }
}

void check_node_constraints(const Model& model) {
  check_each(model, "Fix", model.fixed, [](const LoadChecks& check, const FixedNodes& c) {
    check.nodes(c.nodes);
    check.axes(c.axes);
  });
  const auto on_axes = [](const LoadChecks& check, const auto& c) {
    check.nodes(c.nodes);
    check.axes(c.axes);
    check.values(c.values, c.nodes.size());
    check.curve(c.curve);
  };
  check_each(model, "Disp", model.displacements, on_axes);
  check_each(model, "Force", model.forces, on_axes);
  check_each(model, "Symmetry", model.planes, [](const LoadChecks& check, const SlidingPlane& c) {
    check.nodes(c.nodes);
    check.unit(c.normal, "normal");
  });
  check_each(model, "InitialVelocity", model.initial_velocities,
             [](const LoadChecks& check, const InitialVelocity& c) {
               check.nodes(c.nodes);
               check.is_finite(c.velocity);
             });
}

void check_springs(const LoadChecks& check, const Springs& c) {
  check.nodes(c.nodes);
  check.values(c.targets, c.nodes.size());
  check.values(c.stiffness, c.nodes.size());
  check.curve(c.curve);
  check.curve(c.target_curve);
  if (std::any_of(c.stiffness.begin(), c.stiffness.end(), [](double k) { return k < 0; }))
    refuse(check.where(), "a stiffness is negative; the spring would push away from its target");
  if (c.strain_energy_cap && !(*c.strain_energy_cap > 0))
    refuse(check.where(), "its strain-energy cap is not greater than 0");
}

void check_forces(const Model& model) {
  check_each(model, "Gravity", model.gravity, [](const LoadChecks& check, const Gravity& c) {
    check.nodes(c.nodes, true);
    check.is_finite(c.acceleration);
    check.curve(c.curve);
  });
  check_each(model, "Pressure", model.pressures, [](const LoadChecks& check, const Pressure& c) {
    check.facets(c.facets);
    check.is_finite(c.magnitude);
    check.curve(c.curve);
  });
  check_each(model, "Traction", model.tractions, [](const LoadChecks& check, const Traction& c) {
    check.facets(c.facets);
    check.values(c.values, c.facets.size());
    check.curve(c.curve);
  });
  check_each(model, "Spring", model.springs, check_springs);
}

void check_body(const LoadChecks& check, const RigidBody& body) {
  check.nodes(body.nodes, true);
  check.curve(body.motion);
  check.is_finite(body.displacement);
  check_friction(body.friction, check.where());
  if (body.shape == RigidShape::plate) {
    for (const auto& corner : body.corners) check.is_finite(corner);
    const auto normal = cross(body.corners[1] - body.corners[0], body.corners[2] - body.corners[0]);
    if (!(dot(normal, normal) > 0)) refuse(check.where(), "the corners of the plate lie on one line");
    return;
  }
  check.is_finite(body.origin);
  check.unit(body.axis, "axis");
  if (!(body.radius > 0) || !(body.length > 0) || !std::isfinite(body.radius) || !std::isfinite(body.length))
    refuse(check.where(), "its radius and length must be greater than 0");
  if (!(body.radius + body.radius_change >= 0)) refuse(check.where(), "its radius would become negative");
}

void check_poses(const LoadChecks& check, const std::vector<RigidPose>& poses) {
  if (poses.size() == 1) refuse(check.where(), "its table has one pose, but a motion needs two or more");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    check.is_finite(poses[i].time);
    check.is_finite(poses[i].shift);
    if (!(std::abs(length_of(poses[i].turn) - 1) < 1e-6))
      refuse(check.where(), "the quaternion of pose " + std::to_string(i) + " does not have length 1");
    if (i > 0 && !(poses[i].time > poses[i - 1].time))
      refuse(check.where(), "the times of its poses do not increase: pose " + std::to_string(i) + " is at " +
                                number_text(poses[i].time));
  }
}

}  // namespace

void check_loads(const Model& model, Warnings& warnings) {
  check_node_constraints(model);
  check_forces(model);
  check_each(model, "contact body", model.bodies, check_body);
  check_each(model, "ContactSurface", model.surfaces, [](const LoadChecks& check, const RigidSurface& s) {
    check.nodes(s.nodes, true);
    check.curve(s.motion);
    for (const auto& v : {s.displacement, s.angles, s.centre}) check.is_finite(v);
    for (const auto& X : s.surface.X) check.is_finite(X);
    check_poses(check, s.poses);
  });
  const bool moved = !model.displacements.empty() || !model.forces.empty() || !model.gravity.empty() ||
                     !model.pressures.empty() || !model.tractions.empty() || !model.springs.empty() ||
                     !model.bodies.empty() || !model.surfaces.empty() || !model.initial_velocities.empty();
  if (!moved)
    warnings.push_back("the model has no load, prescribed displacement or moving body: nothing will happen");
  const bool held =
      !model.fixed.empty() || !model.displacements.empty() || !model.springs.empty() || !model.planes.empty();
  if (!held && model.time.quasi_static)
    warnings.push_back("nothing holds the body, so a quasi-static run may not come to rest; fix some nodes");
}

void check_time(const Model& model, Warnings& warnings) {
  const TimeSettings& time = model.time;
  const auto positive = [](double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value))
      refuse("time settings",
             std::string(name) + " is " + number_text(value) + ", but must be greater than 0");
  };
  if (!time.quasi_static || time.total != 0) positive(time.total, "the total time");
  if (time.step) positive(*time.step, "the time step");
  positive(time.safety, "the safety factor");
  if (time.safety > 1)
    refuse("time settings",
           "the safety factor is " + number_text(time.safety) + ": above 1 the step is not stable");
  if (!(time.damping >= 0) || !std::isfinite(time.damping))
    refuse("time settings",
           "the damping coefficient is " + number_text(time.damping) + ", but must not be negative");
  if (time.mass_scaling_step) positive(*time.mass_scaling_step, "the step of mass scaling");
  if (time.quasi_static) {
    positive(time.quasi_static->force_tolerance, "the force tolerance");
    positive(time.quasi_static->displacement_tolerance, "the displacement tolerance");
    if (time.quasi_static->max_steps < 1)
      refuse("time settings", "the largest number of steps must be at least 1");
  }
  if (!std::isfinite(time.energy_tolerance)) refuse("time settings", "the energy tolerance is not finite");
  if (time.monitor_every < 0 || model.output.every < 0)
    refuse("time settings", "a number of steps between reports is negative");
  if (time.step && time.total > 0 && time.total / *time.step > 1e9)
    warnings.push_back("the run needs " + number_text(time.total / *time.step) +
                       " steps; TimeStep may be too small");
}

}  // namespace glisson::detail
