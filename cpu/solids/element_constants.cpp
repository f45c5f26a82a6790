#include <glisson/cpu/solids/element_constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>

namespace glisson::patches {
namespace {

template <class Constants>
void append(const Constants& from, std::vector<double>& to) {
  to.resize(sizeof(from) / sizeof(double));
  std::memcpy(to.data(), &from, sizeof(from));
}

}  // namespace

int constant_count_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::t4:
      return T4::constant_count;
    case Formulation::t4anp:
      return T4::constant_count + 1;
    case Formulation::h8_full:
      return H8Full::constant_count;
    default:
      return H8::constant_count;
  }
}

void element_constants(Formulation formulation, std::span<const Vec3<double>> X, const Stiffness& stiffness,
                       std::vector<double>& constants) {
  if (shape_of(formulation) == Shape::tetrahedron) {
    const Vec3<double> corners[4] = {X[0], X[1], X[2], X[3]};
    T4::Constants<double> c = T4::make(corners);
    c.volume = std::abs(c.volume);
    append(c, constants);
    if (formulation == Formulation::t4anp) constants.push_back(1 / stiffness.bulk);
    return;
  }
  Vec3<double> corners[8];
  std::copy_n(X.begin(), 8, corners);
  if (formulation == Formulation::h8_full)
    append(H8Full::make(corners), constants);
  else if (formulation == Formulation::h8_fixed)
    append(H8::make_fixed(corners, stiffness.hourglass), constants);
  else
    append(H8::make(corners, stiffness.hourglass), constants);
}

}  // namespace glisson::patches
