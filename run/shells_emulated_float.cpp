#include <glisson/cpu/emulated_device.hpp>
#include <glisson/shells/patches/staged_shells.hpp>

namespace glisson {

template std::unique_ptr<SolidForces<float>> make_staged_shells<EmulatedDevice, float>(
    EmulatedDevice&, const Model&, const Numbering&, std::unique_ptr<SolidForces<float>>);

}  // namespace glisson
