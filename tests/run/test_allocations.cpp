// Steps take no memory, but for the few that close an energy account or estimate the stable step again.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include <glisson/core/mesh/surface.hpp>

#include <tests/shells/sheets.hpp>
#include <tests/support/cases.hpp>
#include <tests/support/models.hpp>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they bring their own operator new

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, size > 0 ? size : alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace glisson::test {
namespace {

/// Solids of two laws with viscosity, under a skin of shells where they are tetrahedra, every kind of load
/// and constraint, rigid bodies and a rigid surface.
Model everything(Formulation formulation) {
  Model model = box_model({6, 6, 6}, {0.06, 0.06, 0.06}, formulation, {"NH", {1000, 20000}}, 0.1);
  Section tail = model.sections[0];
  tail.elements.assign(model.sections[0].elements.begin() + 100, model.sections[0].elements.end());
  model.sections[0].elements.resize(100);
  tail.material.isochoric = {{0.3, 0.02}};
  model.sections.push_back(tail);
  const auto top = face(model.mesh, 2, 0.06), side = face(model.mesh, 1, 0.06);
  model.fixed = {{face(model.mesh, 0, 0)}};
  model.displacements = {{top, 1, {0.001}, smooth_curve(1)}};
  model.forces = {{side, 2, {1e-4}, ramp_curve(1)}};
  model.gravity = {{{}, {0, 0, -9.81}, ramp_curve(1)}};
  model.pressures = {{outer_surface(model.mesh), 10, ramp_curve(1)}};
  model.tractions = {{outer_surface(model.mesh), {{1, 2, 3}}, ramp_curve(1)}};
  model.springs = {{side, {{0, 0.001, 0}}, {0.5}, ramp_curve(1), step_curve(1), 1e-5}};
  model.planes = {{face(model.mesh, 1, 0), {0, 1, 0}}};
  RigidBody plate;
  plate.corners = {Vec3<double>{-1, -1, -0.001}, Vec3<double>{1, -1, -0.001}, Vec3<double>{-1, 1, -0.001}};
  model.bodies = {plate};
  RigidSurface floor;
  floor.surface.X = {{-1, -1, -0.002}, {1, -1, -0.002}, {0, 1, -0.002}};
  floor.surface.facets = {{{0, 1, 2, -1}}};
  floor.friction = 0.2;
  model.surfaces = {floor};
  for (const Facet& f : outer_surface(model.mesh))
    if (f.node_count() == 3) model.mesh.triangles.push_back({f.nodes[0], f.nodes[1], f.nodes[2]});
  if (!model.mesh.triangles.empty()) {
    ShellSection skin = shell_section(1000, 0.3, 0.001);
    skin.prony = {{0.3, 0.2}};
    skin.elements.resize(model.mesh.triangles.size());
    std::iota(skin.elements.begin(), skin.elements.end(), 0);
    model.shells = {skin};
  }
  model.time.total = 1;
  model.time.damping = 5;
  model.time.monitor_every = 1000;
  return model;
}

TEST(Allocations, OfOrdinaryStepsAreNone) {
  for (const auto formulation : {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_full})
    for (const Case& c : all_cases) {
      if (std::string(c.device) == "emulated") continue;  // draws the order of each loop
      SCOPED_TRACE(std::string(name_of(formulation)) + " " + c.name);
      const Model model = everything(formulation);
      const auto simulation = simulate(model, c);
      simulation->step(3);
      const long before = allocations.load();
      simulation->step(15);
      EXPECT_EQ(allocations.load() - before, 0);
      simulation->velocity();
      EXPECT_GT(allocations.load(), before) << "nothing is counted";
    }
}

}  // namespace
}  // namespace glisson::test

#endif
