#include <glisson/cuda/solids/run_phases.cuh>
#include <glisson/shells/patches/staged_shells.hpp>

namespace glisson {

template std::unique_ptr<SolidForces<double>> make_staged_shells<Cuda, double>(
    Cuda&, const Model&, const Numbering&, std::unique_ptr<SolidForces<double>>);

}  // namespace glisson
