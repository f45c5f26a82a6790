#include <glisson/cuda/solids/run_phases.cuh>
#include <glisson/shells/patches/staged_shells.hpp>

namespace glisson {

template std::unique_ptr<SolidForces<float>> make_staged_shells<Cuda, float>(
    Cuda&, const Model&, const Numbering&, std::unique_ptr<SolidForces<float>>);

}  // namespace glisson
