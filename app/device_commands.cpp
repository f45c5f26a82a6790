// glisson devices and selftest: what this machine has, and whether all of it gives the same answer.
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <thread>

#include <glisson/app/box_case.hpp>
#include <glisson/app/commands.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/run/gpus.hpp>
#include <glisson/version.hpp>

namespace glisson::app {
namespace {

struct Backend {
  const char* device;
  Precision precision;
  double tolerance;  ///< of the largest difference, relative to the largest displacement [-]
};

// Double differs from the reference only in the order of sums. Float: rounding of u (6e-8) grows over a few
// hundred steps and by the condition of the nearly incompressible cases; doc/precision.md has what was
// measured.
constexpr Backend backends[] = {
    {"serial", Precision::single_precision, 2e-5},   {"cpu", Precision::double_precision, 1e-9},
    {"cpu", Precision::single_precision, 2e-5},      {"emulated", Precision::double_precision, 1e-9},
    {"emulated", Precision::single_precision, 2e-5}, {"cuda", Precision::double_precision, 1e-9},
    {"cuda", Precision::single_precision, 2e-5}};

const std::vector<BoxCase>& cases() {
  static const std::vector<BoxCase> list{
      {.name = "T4 NH", .formulation = Formulation::t4},
      {.name = "T4ANP NH", .formulation = Formulation::t4anp, .parameters = {2000, 200000}},
      {.name = "H8 NH", .formulation = Formulation::h8},
      {.name = "H8Full NH", .formulation = Formulation::h8_full},
      {.name = "T4 LE", .formulation = Formulation::t4, .law = "LE", .parameters = {5000, 0.4}},
      {.name = "T4 AB", .formulation = Formulation::t4, .law = "AB", .parameters = {2000, 3, 20000}},
      {.name = "H8 TI",
       .formulation = Formulation::h8,
       .law = "TI",
       .parameters = {2000, 20000, 3000, 0, 0, 1}},
      {.name = "T4 NH viscous", .formulation = Formulation::t4, .viscous = true},
  };
  return list;
}

std::vector<Vec3<double>> displacement_of(const Model& model, const char* device, Precision precision,
                                          int threads) {
  SimulationOptions options;
  options.device = device;
  options.precision = precision;
  options.threads = threads;
  const auto simulation = make_simulation(model, options);
  while (!simulation->finished()) simulation->step(100);
  return simulation->displacement();
}

double length(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Largest difference over largest displacement [-].
double difference(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double largest = 0, scale = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    largest = std::max(largest, length(a[n] - b[n]));
    scale = std::max(scale, length(b[n]));
  }
  return largest / scale;
}

bool same_bits(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

int compare_backends(const BoxCase& c) {
  const Model model = box_model(c, 200, 0.1);
  const auto reference = displacement_of(model, "serial", Precision::double_precision, 1);
  int failures = 0;
  fmt::print("{:<14}", c.name);
  const bool gpu = !find_gpus().empty();
  for (const auto& backend : backends) {
    if (!gpu && std::string_view(backend.device) == "cuda") continue;
    const auto u = displacement_of(model, backend.device, backend.precision, 2);
    const double d = difference(u, reference);
    const bool good = d <= backend.tolerance;
    failures += !good;
    fmt::print("  {} {} {:.1e}{}", backend.device,
               backend.precision == Precision::double_precision ? "double" : "float", d,
               good ? "" : " TOO LARGE");
  }
  const auto one = displacement_of(model, "cpu", Precision::single_precision, 1);
  const auto two = displacement_of(model, "cpu", Precision::single_precision, 2);
  const bool same = same_bits(one, two);
  fmt::print("  1 and 2 threads: {}\n", same ? "same bits" : "DIFFERENT");
  return failures + !same;
}

void print_gpus() {
  const auto gpus = find_gpus();
  if (gpus.empty())
    fmt::print("cuda        {}\n", built_with_cuda() ? "no device or no driver here" : "not in this build");
  for (std::size_t g = 0; g < gpus.size(); ++g)
    fmt::print("cuda:{}      {}, compute capability {}, {} MiB\n", g, gpus[g].name, gpus[g].capability,
               gpus[g].memory_bytes >> 20);
}

}  // namespace

int devices() {
  fmt::print("serial      reference, one thread\n");
  fmt::print("cpu         {} cores\n", std::max(1u, std::thread::hardware_concurrency()));
  const auto simulation = make_simulation(box_model({.name = "box"}, 48, 0.01), {});
  fmt::print("            a run with --device auto uses: {}\n", simulation->device());
  fmt::print("emulated    behaves like a GPU, for tests\n");
  print_gpus();
  return exit_done;
}

int selftest() {
  fmt::print("Glisson {}: largest difference to serial double, over the largest displacement\n", version);
  int failures = 0;
  for (const auto& c : cases()) failures += compare_backends(c);
  if (find_gpus().empty()) fmt::print("cuda was not run: {}\n", automatic_device_text());
  fmt::print("{} cases, {} failures\n", cases().size(), failures);
  return failures == 0 ? exit_done : static_cast<int>(ErrorKind::run);
}

}  // namespace glisson::app
