#include <glisson/run/model_hash.hpp>

#include <type_traits>

namespace glisson {
namespace {

/// Values are hashed one by one, never as whole structs, whose padding is not defined.
class Hasher {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(const T& value) { hash_ = hash_bytes(&value, sizeof value, hash_); }
  void add(const std::string& text) {
    add(text.size());
    hash_ = hash_bytes(text.data(), text.size(), hash_);
  }
  void add(const Vec3<double>& v) { all(v.x, v.y, v.z); }
  template <class A, class B>
  void add(const std::pair<A, B>& pair) {
    all(pair.first, pair.second);
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const auto& value : values) add(value);
  }
  template <class T, std::size_t n>
  void add(const std::array<T, n>& values) {
    for (const auto& value : values) add(value);
  }

  void add(const LoadCurve& c) { all(c.shape, c.start, c.end, c.release_after_end, c.table); }
  void add(const Facet& f) { all(f.nodes, f.element); }
  void add(const PronyTerm& p) { all(p.alpha, p.tau); }
  void add(const MaterialSpec& m) {
    all(m.law, m.parameters, m.density, m.isochoric, m.volumetric, m.element_parameters);
  }
  void add(const Section& s) { all(s.formulation, s.material, s.elements, s.hourglass); }
  void add(const ShellSection& s) {
    all(s.formulation, s.law, s.parameters, s.bending_E, s.bending_nu, s.density, s.thickness,
        s.element_density, s.element_thickness, s.direction, s.element_direction, s.wrinkling, s.prony,
        s.elements);
  }
  void add(const FixedNodes& c) { all(c.nodes, c.axes); }
  void add(const PrescribedDisplacement& c) { all(c.nodes, c.axes, c.values, c.curve); }
  void add(const NodalForce& c) { all(c.nodes, c.axes, c.values, c.curve); }
  void add(const Gravity& c) { all(c.nodes, c.acceleration, c.curve); }
  void add(const Pressure& c) { all(c.facets, c.magnitude, c.curve); }
  void add(const Traction& c) { all(c.facets, c.values, c.curve); }
  void add(const Springs& c) {
    all(c.nodes, c.targets, c.stiffness, c.curve, c.target_curve, c.strain_energy_cap);
  }
  void add(const SlidingPlane& c) { all(c.nodes, c.normal); }
  void add(const RigidBody& b) {
    all(b.shape, b.corners, b.origin, b.axis, b.radius, b.length, b.displacement, b.radius_change, b.motion,
        b.friction, b.nodes);
  }
  void add(const RigidPose& p) { all(p.time, p.shift, p.turn); }
  void add(const RigidSurface& s) {
    all(s.surface.X, s.surface.facets, s.friction, s.displacement, s.angles, s.centre, s.motion, s.poses,
        s.penalty, s.distance, s.nodes);
  }
  void add(const TiedSurfaces& t) { all(t.a, t.b, t.distance); }
  void add(const NamedElements& b) { all(b.name, b.first, b.count, b.first_triangle, b.triangle_count); }
  void add(const ContactPair& p) { all(p.a, p.b, p.touch, p.friction); }
  void add(const DeformableContact& c) {
    all(c.between_bodies, c.self, c.friction, c.offset, c.distance, c.nodes, c.pairs, c.penalty);
  }
  void add(const InitialVelocity& c) { all(c.nodes, c.velocity); }
  void add(const QuasiStatic& q) { all(q.force_tolerance, q.displacement_tolerance, q.max_steps); }
  void add(const TimeSettings& t) {
    all(t.total, t.step, t.safety, t.stepper, t.damping, t.mass_scaling_step, t.quasi_static,
        t.monitor_every);
  }
  void add(const Mesh& m) { all(m.X, m.shape, m.nodes, m.triangles); }

  template <class... T>
  void all(const T&... values) {
    (add(values), ...);
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037u;
};

}  // namespace

std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t start) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) start = (start ^ bytes[i]) * 1099511628211u;
  return start;
}

std::uint64_t model_hash(const Model& m) {
  Hasher hasher;
  hasher.all(m.mesh, m.sections, m.shells, m.clamped_nodes, m.fixed, m.displacements, m.forces, m.gravity,
             m.pressures, m.tractions, m.springs, m.planes, m.bodies, m.surfaces, m.contact, m.ties,
             m.bodies_by_name, m.initial_velocities, m.time);
  return hasher.hash();
}

}  // namespace glisson
