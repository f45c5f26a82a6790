// NiftySim's -export-mesh and -export-membrane: the end of a run in files that the user names.
#pragma once

#include <glisson/app/commands.hpp>
#include <glisson/core/any_simulation.hpp>

namespace glisson::app {

/// Before the run: Error(usage) for another ending than .vtu and .vtp, and for a membrane of a model without
/// one.
void check_exports(const RunArguments& arguments, const Model& model);
/// After it. The arrays are those of the snapshots.
void export_end(const RunArguments& arguments, const Model& model, const AnySimulation& simulation);

}  // namespace glisson::app
