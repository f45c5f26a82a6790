#include <glisson/cpu/patch_solids.hpp>
#include <glisson/cpu/threads.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_threads_float(const Model& model, int threads,
                                                      const std::string& instruction_set) {
  const std::string set = instruction_set == "auto" ? widest_instruction_set() : instruction_set;
  const std::string device =
      "Threads float, " + std::to_string(threads) + (threads == 1 ? " thread, " : " threads, ") + set;
  auto make_solids = [&](Threads& backend, const Model& its_model, const Numbering& numbering) {
    return make_patch_solids(backend, its_model, numbering, set);
  };
  return assemble<Threads, float>(model, std::make_unique<Threads>(threads), device, make_solids);
}

}  // namespace glisson::detail
