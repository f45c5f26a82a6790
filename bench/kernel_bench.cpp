// Times the solid elements of the Threads backend alone, without loads, contact or output:
//   glisson_kernel_bench FORMULATION LAW CELLS [THREADS [INSTRUCTION_SET [PRONY_TERMS]]]
// prints ns per element and evaluation (best and median of short batches), the same for a node update, memory
// per element, and the bandwidth that the machine had at that moment. On a shared machine only ratios within
// one run mean something.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <string>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/cpu/bandwidth.hpp>
#include <glisson/cpu/patch_solids.hpp>

namespace glisson {
namespace {

struct Task {
  Formulation formulation = Formulation::t4;
  std::string law = "NH", instruction_set = "auto";
  int cells = 12, threads = 0, prony_terms = 0;
};

Formulation formulation_named(const std::string& name) {
  for (const Formulation f :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    if (name == name_of(f)) return f;
  throw Error(ErrorKind::usage,
              "There is no formulation " + name + ". Use T4, T4ANP, H8, H8FixedHourglass or H8Full.");
}

std::vector<double> parameters_of(const std::string& law) {
  if (law == "LE") return {3000, 0.49};
  if (law == "NH") return {1000, 50000};
  if (law == "AB") return {1000, 1.2, 50000};
  if (law == "PY") return {300, 100, 50, 50, 20, 50000};
  if (law == "TI") return {1000, 50000, 1000, 0.6, 0.8, 0};
  return {500, 2, 200, 4, 100, -2, 50000};
}

Model model_of(const Task& task) {
  Model model;
  model.mesh =
      box_mesh({task.cells, task.cells, task.cells}, {0.1, 0.1, 0.1}, shape_of(task.formulation), 0.15);
  Section section;
  section.formulation = task.formulation;
  section.material.law = task.law;
  section.material.parameters = parameters_of(task.law);
  section.material.density = 1000;
  section.material.isochoric.assign(static_cast<std::size_t>(task.prony_terms), {0.2, 0.1});
  section.elements.resize(static_cast<std::size_t>(model.mesh.element_count()));
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.sections.push_back(section);
  return model;
}

/// Arrays of a run, with a smooth displacement of a few per cent strain.
struct State {
  Buffer<Vec4<float>> u, v, f;
  StepView<float> view;
  State(Threads& threads, const Model& model, const Numbering& numbering) {
    const auto count = model.mesh.X.size();
    u = threads.allocate<Vec4<float>>(count);
    v = threads.allocate<Vec4<float>>(count);
    f = threads.allocate<Vec4<float>>(count);
    for (std::size_t n = 0; n < count; ++n) {
      const Vec3<double> X = model.mesh.X[static_cast<std::size_t>(numbering.user_of_internal[n])];
      u[n] = {float(0.003 * std::sin(30 * X.y)), float(0.002 * std::cos(40 * X.z)),
              float(0.002 * std::sin(20 * X.x)), 0};
    }
    view.u = u.get();
    view.v = v.get();
    view.f = f.get();
    view.node_count = static_cast<int>(count);
    view.dt = 1e-4;
  }
};

/// About what a step does to a node, with a step so small that nothing moves.
struct Advance {
  Vec4<float>*u, *v, *f;
  void operator()(int n) const {
    const Vec4<float> a = v[n], b = f[n], c = u[n];
    const float dt = 1e-12f, w = 1e-3f;
    const Vec4<float> next{a.x + dt * w * b.x, a.y + dt * w * b.y, a.z + dt * w * b.z, a.w};
    v[n] = next;
    u[n] = {c.x + dt * next.x, c.y + dt * next.y, c.z + dt * next.z, c.w};
    f[n] = {};
  }
};

struct Times {
  std::vector<double> values;
  double best() const { return *std::min_element(values.begin(), values.end()); }
  double median() {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
  }
};

template <class Body>
void batch(Times& times, int repeats, double per, Body&& body) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repeats; ++i) body();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  times.values.push_back(seconds / repeats / per * 1e9);
}

void run(const Task& task) {
  const Model model = model_of(task);
  const Numbering numbering = make_numbering(model.mesh);
  Threads threads(task.threads);
  const auto solids = make_patch_solids(threads, model, numbering, task.instruction_set);
  State state(threads, model, numbering);
  const int count = model.mesh.element_count(), repeats = std::clamp(200000 / count, 1, 50);
  Times forces, nodes;
  solids->add_forces(state.view);
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(1500)) {
    batch(forces, repeats, count, [&] { solids->add_forces(state.view); });
    batch(nodes, repeats, count, [&] {
      threads.for_each(state.view.node_count, Advance{state.u.get(), state.v.get(), state.f.get()});
    });
  }
  const Bandwidth bandwidth = measure_bandwidth(threads, std::size_t{96} << 20);
  std::printf(
      "%s %s, %d terms, %s, %d threads, %d elements: forces %.2f (median %.2f) ns, nodes %.2f (%.2f) ns, ",
      name_of(task.formulation), task.law.c_str(), task.prony_terms, task.instruction_set.c_str(),
      threads.thread_count(), count, forces.best(), forces.median(), nodes.best(), nodes.median());
  std::printf("%.1f bytes per element; read %.1f, triad %.1f GB/s\n", double(solids->memory_bytes()) / count,
              bandwidth.read * 1e-9, bandwidth.triad * 1e-9);
}

}  // namespace
}  // namespace glisson

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s FORMULATION LAW CELLS [THREADS [INSTRUCTION_SET [PRONY_TERMS]]]\n",
                 argv[0]);
    return 2;
  }
  try {
    glisson::Task task{glisson::formulation_named(argv[1]), argv[2]};
    task.cells = std::atoi(argv[3]);
    if (argc > 4) task.threads = std::atoi(argv[4]);
    if (argc > 5) task.instruction_set = argv[5];
    if (argc > 6) task.prony_terms = std::clamp(std::atoi(argv[6]), 0, 8);
    glisson::run(task);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
