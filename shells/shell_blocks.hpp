// Set-up on the host: the triangles of each section with their constants in double and the nodes they push.
#pragma once

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
  std::vector<int> nodes;    ///< user's numbers; a mirror image or a missing neighbour repeats the own node
                             ///< [elements][3 or 6]
  std::vector<char> pushes;  ///< 1 where a slot can get a force            [elements][3 or 6]
  /// Triangles of the patch of an element: itself and its neighbours, -1 where there is none  [elements][4]
  std::vector<int> patch;

  bool bends() const { return section->formulation == ShellFormulation::rotation_free; }
  int slots() const { return bends() ? RotationFree::node_count : Membrane::node_count; }
};

/// In the order of the model's sections. The model must have passed validate(); throws Error(input) for a
/// shell that is folded flat onto itself.
std::vector<HostShells> make_shell_blocks(const Model& model);

/// The same constants in another number type.
template <class R>
Vec3<R> narrowed(const Vec3<double>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}
template <class R, int N>
SurfacePoint<R, N> narrowed(const SurfacePoint<double, N>& p) {
  SurfacePoint<R, N> q{};
  for (int k = 0; k < 2; ++k) {
    q.t[k] = narrowed<R>(p.t[k]);
    for (int a = 0; a < N; ++a) q.dN[a][k] = R(p.dN[a][k]);
  }
  return q;
}
template <class R>
Membrane::Constants<R> narrowed(const Membrane::Constants<double>& c) {
  return {narrowed<R>(c.point), R(c.volume)};
}
template <class R>
RotationFree::Constants<R> narrowed(const RotationFree::Constants<double>& c) {
  RotationFree::Constants<R> q{};
  for (int s = 0; s < 3; ++s) {
    q.side[s].point = narrowed<R>(c.side[s].point);
    for (int l = 0; l < 2; ++l) q.side[s].dL[l] = R(c.side[s].dL[l]);
    q.side[s].mirror = narrowed<R>(c.side[s].mirror);
    q.h0[s] = narrowed<R>(c.h0[s]);
  }
  q.a = narrowed<R>(c.a), q.b = narrowed<R>(c.b), q.normal = narrowed<R>(c.normal);
  q.double_area = R(c.double_area), q.volume = R(c.volume), q.bending = R(c.bending), q.nu = R(c.nu);
  return q;
}

}  // namespace glisson::shells
