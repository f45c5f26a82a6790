// What is simulated: mesh, materials, loads, constraints, contact bodies and time settings, as plain host
// data in double. Built by a reader (models/) or by hand, checked once by validate(), constant afterwards.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glisson/core/load_curve.hpp>
#include <glisson/core/mesh/mesh.hpp>
#include <glisson/core/rigid_poses.hpp>

namespace glisson {

/// Element formulations. Names in files: T4, T4ANP, H8, H8FixedHourglass, H8Full.
enum class Formulation {
  t4,     ///< linear tetrahedron
  t4anp,  ///< tetrahedron with nodal-averaged pressure (Joldes et al. 2009)
  h8,     ///< one-point hexahedron with mean gradients and stiffness hourglass control (Joldes et al. 2008)
  h8_fixed,  ///< the same with gradients of the centre and hourglass modulus lambda + 2 mu, as NiftySim has
             ///< it
  h8_full,  ///< 2x2x2 points with the mean dilatation against volumetric locking (Simo, Taylor & Pister 1985)
};
const char* name_of(Formulation formulation);
Shape shape_of(Formulation formulation);

/// One Prony term: relative modulus alpha [-] that relaxes with time constant tau [s].
struct PronyTerm {
  double alpha = 0, tau = 1;
};

/// A constitutive law by name and its parameters in the order of the NiftySim format.
struct MaterialSpec {
  std::string law;                 ///< LE, NH, AB, PY, TI, OG: see core/materials/laws.hpp
  std::vector<double> parameters;  ///< [law's count]
  double density = 0;              ///< rest density [kg/m^3]
  std::vector<PronyTerm> isochoric, volumetric;
  /// Per-element values of single parameters (heterogeneous tissue): parameter index -> [section's element
  /// count].
  std::vector<std::pair<int, std::vector<double>>> element_parameters;
};

/// Elements that share a formulation and a material; every element belongs to exactly one section.
struct Section {
  std::string name;  ///< for messages: "ElementSet at line 12"
  Formulation formulation = Formulation::t4;
  MaterialSpec material;
  std::vector<int> elements;
  double hourglass = 0.075;  ///< hourglass coefficient of h8 and h8_fixed [-]
};

enum class ShellFormulation {
  membrane,       ///< constant-strain triangle without bending (Bonet et al. 2000)
  rotation_free,  ///< EBST1: curvature from the three neighbours, displacements only (Flores & Onate 2005)
};

const char* name_of(ShellFormulation formulation);

/// Triangles that share a formulation, a law and its parameters; every triangle belongs to exactly one.
struct ShellSection {
  std::string name;  ///< for messages: "ShellElementSet at line 12"
  ShellFormulation formulation = ShellFormulation::membrane;
  std::string law;                       ///< Linear, NeoHookean, ...: see shell_law_table
  std::vector<double> parameters;        ///< [law's count]
  double bending_E = 0, bending_nu = 0;  ///< rotation_free: plate stiffness E h^3 / (12 (1 - nu^2)) [Pa, -]
  double density = 0;                    ///< rest density [kg/m^3]
  double thickness = 0;                  ///< at rest [m]
  std::vector<double> element_density, element_thickness;  ///< [elements], or empty: the values above
  Vec3<double> direction;  ///< of the first local axis, projected onto each triangle; zero: its first edge
  std::vector<Vec3<double>> element_direction;  ///< [elements], or empty: the one above
  bool wrinkling = false;        ///< membrane: compression makes wrinkles instead of stress (tension field)
  std::vector<PronyTerm> prony;  ///< on the whole stress in the plane
  std::vector<int> elements;     ///< triangles of Mesh::triangles

  double thickness_of(std::size_t k) const {
    return element_thickness.empty() ? thickness : element_thickness[k];
  }
  double density_of(std::size_t k) const { return element_density.empty() ? density : element_density[k]; }
  const Vec3<double>& direction_of(std::size_t k) const {
    return element_direction.empty() ? direction : element_direction[k];
  }
};

/// Axes bit mask: 1 = x, 2 = y, 4 = z.
using Axes = unsigned;
constexpr Axes all_axes = 7;

struct FixedNodes {
  std::vector<int> nodes;
  Axes axes = all_axes;
};

/// Prescribed displacement; several on one node and axis add up and beat a Fix.
struct PrescribedDisplacement {
  std::vector<int> nodes;
  Axes axes = all_axes;
  std::vector<double> values;  ///< at amplitude 1 [m]  [1] for all nodes or [nodes]
  LoadCurve curve;
};

struct NodalForce {
  std::vector<int> nodes;
  Axes axes = all_axes;
  std::vector<double> values;  ///< on each node at amplitude 1 [N]  [1] or [nodes]
  LoadCurve curve;
};

struct Gravity {
  std::vector<int> nodes;     ///< empty: all nodes
  Vec3<double> acceleration;  ///< at amplitude 1 [m/s^2]
  LoadCurve curve;
};

/// Follower pressure on the current facets; positive pushes against the outward normal.
struct Pressure {
  std::vector<Facet> facets;
  double magnitude = 0;  ///< at amplitude 1 [Pa]
  LoadCurve curve;
};

/// Force per current area with a direction fixed in space, acting in the direction as written.
struct Traction {
  std::vector<Facet> facets;
  std::vector<Vec3<double>> values;  ///< at amplitude 1 [Pa]  [1] or [facets]
  LoadCurve curve;
};

/// Springs that pull nodes to target displacements, R = k(t) (u_target - u): Johnsen 2016, eq. 3.14, with the
/// strain-energy cap of eq. 3.15: k(t) stays at its last value while the strain energy exceeds the cap.
struct Springs {
  std::vector<int> nodes;
  std::vector<Vec3<double>> targets;        ///< displacement at amplitude 1 [m]  [1] or [nodes]
  std::vector<double> stiffness;            ///< at amplitude 1 [N/m]             [1] or [nodes]
  LoadCurve curve;                          ///< of the stiffness (eq. 3.14: ramp)
  LoadCurve target_curve{LoadShape::step};  ///< of the targets: step, or a curve for moving targets
  std::optional<double> strain_energy_cap;  ///< [J]
};

/// Symmetry or sliding plane: the displacement along `normal` stays 0.
struct SlidingPlane {
  std::vector<int> nodes;
  Vec3<double> normal;  ///< unit
};

/// Analytic rigid bodies (Johnsen 2016, section 4.5.8.1).
enum class RigidShape { plate, cylinder, probe };
struct RigidBody {
  RigidShape shape = RigidShape::plate;
  std::string name;
  std::array<Vec3<double>, 3> corners{};  ///< plate: a b c; nodes on the side of -(b-a)x(c-a) are pushed back
  Vec3<double> origin, axis;              ///< cylinder, probe: axis is unit
  double radius = 0, length = 0;          ///< [m]
  Vec3<double> displacement;              ///< at amplitude 1 [m]
  double radius_change = 0;               ///< at amplitude 1 [m]
  LoadCurve motion{LoadShape::poly345};
  double friction = 0;     ///< Coulomb's coefficient [-]
  std::vector<int> nodes;  ///< nodes that may touch it; empty: all surface nodes
};

/// Contact by penalty instead of multipliers: of the depth that a step would end at, the force takes back
/// this share within the step, were the contact alone: stiffness = share mass / step^2. In (0, 1] [-]
using PenaltyShare = std::optional<double>;
constexpr double default_penalty = 0.9;

/// Rigid surface of triangles or quadrilaterals that nodes stay in front of, with Coulomb friction. The front
/// is where the facets' normals point. It turns by Rx Ry Rz about `centre`, then shifts; or it follows a
/// table of poses.
struct RigidSurface {
  std::string name;
  std::string file;              ///< that the facets are from, for messages
  std::vector<int> facet_lines;  ///< where each facet stands in it, for messages  [facets], or empty
  SurfaceMesh surface;
  double friction = 0;        ///< Coulomb's coefficient [-]
  Vec3<double> displacement;  ///< at amplitude 1 [m]
  Vec3<double> angles;        ///< about x, y, z at amplitude 1 [rad]
  Vec3<double> centre;        ///< of the rotation, at rest [m]
  LoadCurve motion{LoadShape::ramp};
  std::vector<RigidPose> poses;  ///< two or more: instead of displacement, angles and motion
  PenaltyShare penalty;          ///< empty: multipliers
  std::optional<double> distance;  ///< gap below which an approach is slowed; empty: as in contact [m]
  std::vector<int> nodes;  ///< nodes that may touch it; empty: all surface nodes
};

/// Consecutive elements and shell triangles with a name that contact pairs are chosen by: a sub-model of a
/// file.
struct NamedElements {
  std::string name;
  int first = 0, count = 0;
  int first_triangle = 0, triangle_count = 0;
};

/// Whether two named bodies may touch and how rough they are; a body with itself: its self-contact.
struct ContactPair {
  std::string where;  ///< for messages: "ContactPair at line 12"
  std::string a, b;   ///< names of Model::bodies_by_name
  bool touch = true;
  std::optional<double> friction;  ///< [-]; empty: that of DeformableContact
};

/// Contact of the outer surfaces of solids and of membranes and shells with each other and with themselves
/// (Johnsen 2016, chapter 5).
struct DeformableContact {
  bool between_bodies = false;     ///< parts of the surface that are not connected
  bool self = false;               ///< each connected part with itself
  double friction = 0;             ///< Coulomb's coefficient [-]
  double offset = 0;               ///< gap that surfaces keep [m]
  std::optional<double> distance;  ///< gap below which an approach is slowed [m]; empty: from the mesh
  std::vector<int> nodes;          ///< nodes that may touch facets; empty: all surface nodes
  std::vector<ContactPair> pairs;
  PenaltyShare penalty;  ///< empty: multipliers

  bool wanted() const { return between_bodies || self; }
};

/// Nodes of one body that are glued to the surface of another.
struct TiedSurfaces {
  std::string where;               ///< for messages: "TiedSurfaces at line 12"
  std::string a, b;                ///< names of Model::bodies_by_name: nodes of a, facets of b
  std::optional<double> distance;  ///< from a facet up to which nodes are tied [m]; empty: from the mesh
};

struct InitialVelocity {
  std::vector<int> nodes;
  Vec3<double> velocity;  ///< [m/s]
};

enum class Stepper { central_difference, newmark };

/// Adaptive dynamic relaxation: ends when both residuals are below the tolerances.
struct QuasiStatic {
  double force_tolerance = 1e-4;         ///< |free residual force| / |external or reaction force| [-]
  double displacement_tolerance = 1e-5;  ///< largest change per period-equivalent / largest displacement [-]
  std::int64_t max_steps = 1'000'000;
};

/// Length of the ramp of a quasi-static run without a total time: where a LoadCurve ends by default [s].
constexpr double pseudo_time = 1;

struct TimeSettings {
  double total = 0;                ///< [s]; 0 in a quasi-static run: pseudo_time
  std::optional<double> step;      ///< [s]; empty: chosen from the estimated stable step
  double safety = 0.8;             ///< share of the stable step that is used
  std::optional<Stepper> stepper;  ///< empty: Newmark if every element is T4ANP, else central difference
  double damping = 0;              ///< mass-proportional, C = damping M [1/s]
  std::optional<double> mass_scaling_step;  ///< elements with a smaller stable step get mass added [s]
  std::optional<QuasiStatic> quasi_static;
  int monitor_every = 0;  ///< energies every n steps; 0: about 100 times a run
  double energy_tolerance =
      0.2;  ///< the run stops when the balance is off by more than this share; <= 0: never
};

/// What a run writes.
struct OutputSettings {
  int every = 0;                       ///< steps between snapshots; 0: only the last state
  std::vector<std::string> variables;  ///< of the NiftySim text files: U F S E EKin EStrain
};

struct Model {
  std::string name;   ///< for messages and output, e.g. the file's stem
  std::string units;  ///< "SI", "mm-kg-s" or empty: any consistent set
  Mesh mesh;
  std::vector<Section> sections;
  std::vector<ShellSection> shells;
  /// Edges between two of these have no rotation (rotation_free shells); the nodes must be fixed too.
  std::vector<int> clamped_nodes;
  std::vector<FixedNodes> fixed;
  std::vector<PrescribedDisplacement> displacements;
  std::vector<NodalForce> forces;
  std::vector<Gravity> gravity;
  std::vector<Pressure> pressures;
  std::vector<Traction> tractions;
  std::vector<Springs> springs;
  std::vector<SlidingPlane> planes;
  std::vector<RigidBody> bodies;
  std::vector<RigidSurface> surfaces;
  DeformableContact contact;
  std::vector<TiedSurfaces> ties;
  std::vector<NamedElements> bodies_by_name;
  std::vector<InitialVelocity> initial_velocities;
  TimeSettings time;
  OutputSettings output;
};

/// Throws Error(input) for the first thing that cannot be simulated: index out of range, element without or
/// with two sections, inverted or flat element, parameter out of its range, massless node that is not fixed,
/// empty selection. Returns warnings (one line each) for what can be simulated but looks wrong.
std::vector<std::string> validate(const Model& model);

}  // namespace glisson
