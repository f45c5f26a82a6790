// The list of all constitutive laws. The build system has the same list in cmake/GlissonLaws.cmake.
#pragma once

#include <glisson/core/materials/arruda_boyce.hpp>
#include <glisson/core/materials/neo_hookean.hpp>
#include <glisson/core/materials/ogden.hpp>
#include <glisson/core/materials/polynomial.hpp>
#include <glisson/core/materials/st_venant_kirchhoff.hpp>
#include <glisson/core/materials/transversely_isotropic.hpp>

namespace glisson {

template <class... Types>
struct TypeList {
  static constexpr int size = sizeof...(Types);
};

template <class R>
using AllLaws = TypeList<NeoHookean<R>, StVenantKirchhoff<R>, ArrudaBoyce<R>, Polynomial<R>,
                         TransverselyIsotropic<R>, Ogden<R>>;

/// Calls f.template operator()<L>() for each type L of the list, in order.
template <class... Types, class F>
constexpr void for_each_type(TypeList<Types...>, F&& f) {
  (f.template operator()<Types>(), ...);
}

}  // namespace glisson
