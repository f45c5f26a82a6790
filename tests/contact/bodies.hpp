// Models of several solid bodies that may touch, for tests.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <glisson/core/solids/mass.hpp>

#include "tests/support/cases.hpp"
#include "tests/support/models.hpp"

namespace glisson::test {

/// A body of a model: its nodes in the joined mesh.
struct Body {
  int first_node = 0, node_count = 0;
  std::vector<int> nodes() const {
    std::vector<int> all(static_cast<std::size_t>(node_count));
    std::iota(all.begin(), all.end(), first_node);
    return all;
  }
};

inline void move(Mesh& mesh, const Vec3<double>& by) {
  for (auto& X : mesh.X) X = X + by;
}

/// Appends a mesh as a body of its own with its own section.
inline Body add_body(Model& model, const Mesh& mesh, Formulation formulation, const Material& material) {
  const Body body{model.mesh.node_count(), mesh.node_count()};
  const int first = model.mesh.element_count();
  model.mesh.X.insert(model.mesh.X.end(), mesh.X.begin(), mesh.X.end());
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::vector<int> nodes;
    for (const int n : mesh.element(e)) nodes.push_back(n + body.first_node);
    model.mesh.add_element(mesh.shape[static_cast<std::size_t>(e)], nodes);
  }
  Section section = section_of_all(mesh, formulation, material);
  section.name = "body " + std::to_string(model.sections.size());
  for (int& e : section.elements) e += first;
  model.sections.push_back(section);
  model.bodies_by_name.push_back({section.name, first, mesh.element_count()});
  return body;
}

inline Vec3<double> mean_of(const std::vector<Vec3<double>>& values, const Body& body,
                            const std::vector<double>& weight) {
  Vec3<double> sum;
  double all = 0;
  for (const int n : body.nodes()) {
    sum = sum + weight[static_cast<std::size_t>(n)] * values[static_cast<std::size_t>(n)];
    all += weight[static_cast<std::size_t>(n)];
  }
  return (1 / all) * sum;
}

/// Input that is refused, with these words in the message.
inline void expect_refused(const Model& model, const std::string& word) {
  try {
    validate(model);
    simulate(model, serial_double);
    ADD_FAILURE() << "taken, but: " << word;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
}

/// The octant [0, 1]^3 of n^3 bricks mirrored to [-1, 1]^3, so that the mesh has the symmetry of the cube.
inline Mesh mirrored_cube(int n) {
  const Mesh octant = box_mesh({n, n, n}, {1, 1, 1}, Shape::tetrahedron);
  Mesh mesh;
  std::map<std::array<int, 3>, int> number;
  for (int mirror = 0; mirror < 8; ++mirror)
    for (int e = 0; e < octant.element_count(); ++e) {
      std::array<int, 4> nodes{};
      for (std::size_t a = 0; a < 4; ++a) {
        Vec3<double> X = octant.X[static_cast<std::size_t>(octant.element(e)[a])];
        X = {mirror & 1 ? -X.x : X.x, mirror & 2 ? -X.y : X.y, mirror & 4 ? -X.z : X.z};
        const std::array<int, 3> key{int(std::lround(X.x * n)), int(std::lround(X.y * n)),
                                     int(std::lround(X.z * n))};
        const auto [place, is_new] = number.try_emplace(key, mesh.node_count());
        if (is_new) mesh.X.push_back(X);
        nodes[a] = place->second;
      }
      if ((mirror ^ mirror >> 1 ^ mirror >> 2) & 1) std::swap(nodes[2], nodes[3]);
      mesh.add_element(Shape::tetrahedron, nodes);
    }
  return mesh;
}

/// Ball of radius 1: the mirrored cube mapped so that its shells become spheres.
inline Mesh ball_mesh(int n) {
  Mesh mesh = mirrored_cube(n);
  for (auto& X : mesh.X) {
    const double shell = std::max({std::abs(X.x), std::abs(X.y), std::abs(X.z)});
    // equal angles on the faces keep the surface triangles alike
    const auto bent = [&](double c) { return shell > 0 ? std::tan(c / shell * 0.7853981633974483) : 0; };
    const Vec3<double> q{bent(X.x), bent(X.y), bent(X.z)};
    const double length = std::sqrt(dot(q, q));
    X = length > 0 ? (shell / length) * q : Vec3<double>{};
  }
  return mesh;
}

}  // namespace glisson::test
