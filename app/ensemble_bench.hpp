// The part of bench that compares an ensemble with single runs on the same cores.
#pragma once

#include <glisson/app/commands.hpp>

namespace glisson::app {

/// T4, neo-Hookean; one line per size and number of members.
void bench_ensembles(const BenchArguments& arguments);

}  // namespace glisson::app
