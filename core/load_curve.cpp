#include <glisson/core/load_curve.hpp>

#include <glisson/core/kernels/load_amplitude.hpp>

namespace glisson {

double LoadCurve::operator()(double t) const {
  return CurveView<std::pair<double, double>>{shape, release_after_end, start,
                                              end,   table.data(),      static_cast<int>(table.size())}(t);
}

}  // namespace glisson
