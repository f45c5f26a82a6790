#include <glisson/core/solids/staged_solids.hpp>
#include <glisson/cpu/emulated_device.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>
#include <glisson/shells/patches/make_staged_shells.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_emulated_float(const Model& model, bool conflicts) {
  auto device = std::make_unique<EmulatedDevice>();
  if (conflicts) device->look_for_conflicts();
  return assemble<EmulatedDevice, float>(model, std::move(device), "EmulatedDevice float",
                                         make_staged_solids<EmulatedDevice, float>,
                                         make_staged_shells<EmulatedDevice, float>);
}

}  // namespace glisson::detail
