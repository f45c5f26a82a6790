#include <glisson/cpu/solids/element_constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/h8_parallelepiped.hpp>
#include <glisson/core/elements/t4.hpp>

namespace glisson::patches {
namespace {

template <class Constants>
void append(const Constants& from, std::vector<double>& to) {
  to.resize(sizeof(from) / sizeof(double));
  std::memcpy(to.data(), &from, sizeof(from));
}

}  // namespace

Kind kind_of(Formulation formulation, std::span<const Vec3<double>> X) {
  if (formulation == Formulation::h8 || formulation == Formulation::h8_fixed) {
    Vec3<double> corners[8];
    std::copy_n(X.begin(), 8, corners);
    if (H8Parallelepiped::fits(corners)) return Kind::h8_parallelepiped;
  }
  return static_cast<Kind>(formulation);
}

int constant_count_of(Kind kind) {
  switch (kind) {
    case Kind::t4:
      return T4::constant_count;
    case Kind::t4anp:
      return T4::constant_count + 1;
    case Kind::h8_full:
      return H8Full::constant_count;
    case Kind::h8_parallelepiped:
      return H8Parallelepiped::constant_count;
    default:
      return H8::constant_count;
  }
}

void element_constants(Kind kind, std::span<const Vec3<double>> X, const Stiffness& stiffness,
                       std::vector<double>& constants) {
  if (kind == Kind::t4 || kind == Kind::t4anp) {
    const Vec3<double> corners[4] = {X[0], X[1], X[2], X[3]};
    T4::Constants<double> c = T4::make(corners);
    c.volume = std::abs(c.volume);
    append(c, constants);
    if (kind == Kind::t4anp) constants.push_back(1 / stiffness.bulk);
    return;
  }
  Vec3<double> corners[8];
  std::copy_n(X.begin(), 8, corners);
  if (kind == Kind::h8_full)
    append(H8Full::make(corners), constants);
  else if (kind == Kind::h8_fixed)
    append(H8::make_fixed(corners, stiffness.hourglass), constants);
  else if (kind == Kind::h8_parallelepiped)
    append(H8Parallelepiped::make(corners, stiffness.hourglass), constants);
  else
    append(H8::make(corners, stiffness.hourglass), constants);
}

}  // namespace glisson::patches
