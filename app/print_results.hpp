// What is printed after a run.
#pragma once

#include <string>

#include <glisson/run/runner.hpp>

namespace glisson::app {

void print_summary(const RunSummary& summary);

/// NiftySim's -print: NF all nodal internal forces, LNF those of nodes with prescribed displacement, LNFS
/// their sum, ND all displacements, ES strain energy, EK kinetic energy. Nodes are numbered from 0, as
/// everywhere in the file.
void print_result(const std::string& what, const Model& model, const AnySimulation& simulation,
                  const RunSummary& summary);

}  // namespace glisson::app
