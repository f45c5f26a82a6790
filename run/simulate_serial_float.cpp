#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_serial_float(const Model& model) {
  return assemble<Serial, float>(model, std::make_unique<Serial>(), "Serial float",
                                 make_plain_solids<Serial, float>, make_plain_shells<Serial, float>);
}

}  // namespace glisson::detail
