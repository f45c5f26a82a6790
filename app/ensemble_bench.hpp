// The part of bench that compares an ensemble with single runs on the same cores.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glisson/app/commands.hpp>

namespace glisson::app {

/// T4, neo-Hookean; one line, and one entry of the result, per size and number of members.
nlohmann::ordered_json bench_ensembles(const BenchArguments& arguments);

}  // namespace glisson::app
