#include <glisson/app/ensemble_bench.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <vector>

#include <glisson/app/box_case.hpp>
#include <glisson/run/make_ensemble.hpp>

namespace glisson::app {
namespace {

using Clock = std::chrono::steady_clock;

template <class F>
double seconds_of(F&& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Single run and ensemble take turns; both in ns per element, step and member.
nlohmann::ordered_json compare(const std::vector<Model>& members, const SimulationOptions& options,
                               double seconds) {
  const auto single = make_simulation(members[0], options);
  const auto ensemble = make_ensemble(members, options);
  const auto count = static_cast<double>(members.size());
  const int elements = members[0].mesh.element_count();
  ensemble->step(3);  // a GPU loads kernels when they are launched for the first time
  const double once = seconds_of([&] { ensemble->step(10); }) / 10;
  const auto steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(0.1 * seconds / once));
  const auto single_steps = static_cast<std::int64_t>(std::max(1.0, 0.25 * count)) * steps;
  std::vector<double> alone, together;
  for (int turn = 0; turn < 7; ++turn) {
    alone.push_back(1e9 * seconds_of([&] { single->step(single_steps); }) /
                    static_cast<double>(single_steps) / elements);
    together.push_back(1e9 * seconds_of([&] { ensemble->step(steps); }) / static_cast<double>(steps) /
                       elements / count);
  }
  const double a = median(alone), b = median(together);
  fmt::print("{:>9} {:>8} {:>14.3f} {:>14.4f} {:>8.2f} {:>18.3g}  {}\n", elements, members.size(), a, b,
             a / b, 1e9 / b, ensemble->device());
  return {{"elements", elements},
          {"members", members.size()},
          {"device", ensemble->device()},
          {"single_ns_per_element_and_step", a},
          {"ensemble_ns_per_element_and_step", b},
          {"element_steps_per_s", 1e9 / b}};
}

}  // namespace

nlohmann::ordered_json bench_ensembles(const BenchArguments& arguments) {
  fmt::print("{:>9} {:>8} {:>14} {:>14} {:>8} {:>18}\n", "elements", "members", "single ns/el",
             "ensemble ns/el", "gain", "element-steps/s");
  SimulationOptions options;
  options.device = arguments.device;
  options.threads = arguments.threads;
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const int size : arguments.sizes)
    for (const int count : arguments.members) {
      std::vector<Model> members(static_cast<std::size_t>(count), box_model({.name = "T4"}, size, 100));
      for (std::size_t k = 0; k < members.size(); ++k)
        members[k].sections[0].material.parameters[0] *= 1 + 0.5 * static_cast<double>(k) / count;
      results.push_back(compare(members, options, arguments.seconds));
    }
  return results;
}

}  // namespace glisson::app
