#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/threads.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_threads_float(const Model& model, int threads, const std::string&) {
  const std::string device = "Threads float, " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
  return assemble<Threads, float>(model, std::make_unique<Threads>(threads), device, make_plain_solids<Threads, float>);
}

}  // namespace glisson::detail
