#include <glisson/cpu/emulated_device.hpp>
#include <glisson/shells/patches/staged_shells.hpp>

namespace glisson {

template std::unique_ptr<SolidForces<double>> make_staged_shells<EmulatedDevice, double>(
    EmulatedDevice&, const Model&, const Numbering&, std::unique_ptr<SolidForces<double>>);

}  // namespace glisson
