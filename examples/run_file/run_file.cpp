// Runs any simulation file and uses the displacements: here, it prints the largest one.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/read_model.hpp>
#include <glisson/run/make_simulation.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: run_file SIMULATION.xml\n";
    return 2;
  }
  try {
    const glisson::Model model = glisson::read_model(argv[1]);
    const auto simulation = glisson::make_simulation(model, {.device = "cpu"});
    while (!simulation->finished()) simulation->step();

    const auto displacement = simulation->displacement();  // one vector per node, in the numbers of the file
    const auto largest = std::max_element(displacement.begin(), displacement.end(),
                                          [](const auto& a, const auto& b) { return dot(a, a) < dot(b, b); });
    std::cout << simulation->step_count() << " steps on " << simulation->device() << ", largest displacement "
              << std::sqrt(dot(*largest, *largest)) << " m at node " << largest - displacement.begin()
              << '\n';
  } catch (const glisson::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.kind());
  }
}
