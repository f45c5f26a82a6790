#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/threads.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_threads_double(const Model& model, int threads) {
  const std::string device =
      "Threads double, " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
  return assemble<Threads, double>(model, std::make_unique<Threads>(threads), device,
                                   make_plain_solids<Threads, double>, make_plain_shells<Threads, double>);
}

}  // namespace glisson::detail
