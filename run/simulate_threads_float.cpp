#include <glisson/cpu/patch_solids.hpp>
#include <glisson/cpu/threads.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/shell_packs/packed_shells.hpp>
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
  auto make_shells = [&](Threads& backend, const Model& its_model, const Numbering& numbering,
                         std::unique_ptr<SolidForces<float>> solids) {
    return shells::make_packed_shells(backend, its_model, numbering, std::move(solids), set);
  };
  return assemble<Threads, float>(model, std::make_unique<Threads>(threads, set.c_str()), device, make_solids,
                                  make_shells, contact::contact_loops(set.c_str()));
}

}  // namespace glisson::detail
