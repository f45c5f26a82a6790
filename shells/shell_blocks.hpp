// Set-up on the host: the triangles of each section with their constants in double and the nodes they push.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/shells/elements/membrane.hpp>
#include <glisson/shells/elements/rotation_free.hpp>

namespace glisson::shells {

/// Axes in the plane of a rest triangle and its normal, unit.
struct SurfaceFrame {
  Vec3<double> t[2], normal;
};

/// One section. Only one of the lists of constants is filled.
struct HostShells {
  const ShellSection* section = nullptr;
  std::vector<Membrane::Constants<double>> membranes;   ///< [elements]
  std::vector<RotationFree::Constants<double>> shells;  ///< [elements]
  std::vector<SurfaceFrame> frames;                     ///< [elements]
  std::vector<Vec3<double>> along;  ///< direction of the first axis; zero: the first side  [elements]
  std::vector<int> nodes;  ///< user's numbers; an image repeats the own node  [elements][3 or 6]
  /// Triangles of the patch of an element: itself and its neighbours, -1 where there is none  [elements][4]
  std::vector<int> patch;

  bool bends() const { return section->formulation == ShellFormulation::rotation_free; }
  int slots() const { return bends() ? RotationFree::node_count : Membrane::node_count; }
};

/// In the order of the model's sections. The model must have passed validate(); throws Error(input) for a
/// shell that is folded flat onto itself.
std::vector<HostShells> make_shell_blocks(const Model& model);

/// The same numbers in another type: Constants are nothing but numbers.
template <class R, template <class> class Constants>
Constants<R> narrowed(const Constants<double>& from) {
  constexpr std::size_t count = sizeof(from) / sizeof(double);
  const auto numbers = std::bit_cast<std::array<double, count>>(from);
  std::array<R, count> own;
  for (std::size_t i = 0; i < count; ++i) own[i] = R(numbers[i]);
  return std::bit_cast<Constants<R>>(own);
}

}  // namespace glisson::shells
