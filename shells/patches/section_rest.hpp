// What is kept of the triangles of a section at rest when they are in patches, and how their constants
// follow.
#pragma once

#include <glisson/core/kernels/element_forces.hpp>
#include <glisson/shells/elements/membrane.hpp>
#include <glisson/shells/elements/rotation_free.hpp>

namespace glisson::shells {

/// Stored per shell triangle, as [number][element_count]. The gradients would cost more to form than to read;
/// the images are read only where a side has no neighbour.
template <class R>
struct StoredShell {
  R g[3][2][2];           ///< as in ShellPatch
  R dL[2][2];             ///< as in ShellPatch
  SideImage<R> image[3];  ///< as in RotationFree
};

/// One section in the backend's memory.
template <class R>
struct SectionRest {
  const R* thickness = nullptr;    ///< [m]  [element_count] or, with stride 0, one for all
  const Vec3<R>* along = nullptr;  ///< of the first axis; zero: the first side  [element_count] or one
  const R* gradients = nullptr;    ///< shells: of StoredShell  [16][element_count]
  const R* images = nullptr;       ///< shells: of StoredShell  [12][element_count]
  int element_count = 0;
  int thickness_stride = 0, along_stride = 0;
  R plate = R(0), nu = R(0);  ///< shells: E / (12 (1 - nu^2)) of bending [Pa]; [-]

  GLISSON_HD_INLINE Membrane::Constants<R> membrane(int e, const Vec3<R> (&X_e)[3]) const {
    const Vec3<R> given = along[e * along_stride];
    const bool none = !(dot(given, given) > R(0));
    return Membrane::make(X_e, none ? X_e[1] - X_e[0] : given, thickness[e * thickness_stride]);
  }
  /// C: ShellPatch<R>, or RotationFree::Constants<R> for a triangle with images.
  template <class C>
  GLISSON_HD_INLINE C shell(int e, const Vec3<R> (&X_e)[6]) const {
    C c{};
    const R h = thickness[e * thickness_stride];
    GLISSON_UNROLL
    for (int i = 0; i < 12; ++i) c.g[i / 4][i / 2 % 2][i % 2] = number(gradients, i, e);
    GLISSON_UNROLL
    for (int i = 0; i < 4; ++i) c.dL[i / 2][i % 2] = number(gradients, 12 + i, e);
    if constexpr (requires { c.image; }) {
      GLISSON_UNROLL
      for (int s = 0; s < 3; ++s)
        c.image[s] = {{number(images, 4 * s, e), number(images, 4 * s + 1, e), number(images, 4 * s + 2, e)},
                      number(images, 4 * s + 3, e)};
    }
    c.nu = nu;
    RotationFree::set_rest(c, X_e, h, plate * h * h * h);
    return c;
  }

  GLISSON_HD R number(const R* of, int k, int e) const { return of[std::size_t(k) * element_count + e]; }
};

}  // namespace glisson::shells
