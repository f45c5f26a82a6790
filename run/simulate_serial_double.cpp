#include <glisson/core/solids/plain_solids.hpp>
#include <glisson/cpu/serial.hpp>
#include <glisson/run/assemble.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson::detail {

std::unique_ptr<AnySimulation> simulate_serial_double(const Model& model) {
  return assemble<Serial, double>(model, std::make_unique<Serial>(), "Serial double",
                                  make_plain_solids<Serial, double>, make_plain_shells<Serial, double>);
}

}  // namespace glisson::detail
