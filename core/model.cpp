#include <glisson/core/model.hpp>

namespace glisson {

const char* name_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::t4:
      return "T4";
    case Formulation::t4anp:
      return "T4ANP";
    case Formulation::h8:
      return "H8";
    case Formulation::h8_fixed:
      return "H8FixedHourglass";
    case Formulation::h8_full:
      return "H8Full";
  }
  return "?";
}

const char* name_of(ShellFormulation formulation) {
  return formulation == ShellFormulation::membrane ? "membrane" : "rotation-free";
}

Shape shape_of(Formulation formulation) {
  const bool tetrahedron = formulation == Formulation::t4 || formulation == Formulation::t4anp;
  return tetrahedron ? Shape::tetrahedron : Shape::hexahedron;
}

}  // namespace glisson
