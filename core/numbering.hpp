// Locality order: elements along a space-filling curve, nodes by first touch. Users never see it; results go
// back through it.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson {

struct Numbering {
  std::vector<int> internal_of_user;  ///< internal node of a user's node [-]  [node_count]
  std::vector<int> user_of_internal;  ///< and back                            [node_count]
  std::vector<int> element_order;     ///< user's element at internal place i  [element_count]
  std::vector<int> triangle_order;    ///< user's triangle at internal place i [triangles]
};

Numbering make_numbering(const Mesh& mesh);

}  // namespace glisson
