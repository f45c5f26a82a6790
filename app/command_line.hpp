// The grammar of the command line.
#pragma once

#include <string>
#include <vector>

namespace glisson::app {

/// Runs the subcommand that the arguments name; returns the exit code. Throws Error(usage) for wrong
/// arguments.
int parse_and_run(int argc, const char* const* argv);

/// NiftySim's one-dash options in the form of this program: "-sport" becomes "--sport", "-x FILE" without a
/// subcommand becomes "run FILE".
std::vector<std::string> with_own_names(std::vector<std::string> arguments);

}  // namespace glisson::app
