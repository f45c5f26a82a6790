// A small mesh of both shapes, a state on it, and a folder of its own: what the tests of the writers share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/mesh.hpp>
#include <glisson/models/output/fields.hpp>
#include <iterator>
#include <string>

namespace glisson {

inline Mesh mixed_mesh() {
  Mesh mesh;
  for (int n = 0; n < 8; ++n)
    mesh.X.push_back(
        {(n % 4 == 1 || n % 4 == 2) ? 1.1 : 0.0, n % 4 >= 2 ? 1.0 / 3 : 0.0, n >= 4 ? 0.7 : 0.0});
  mesh.X.push_back({0.2, 0.1, 2.0});
  mesh.add_element(Shape::tetrahedron, std::array{4, 5, 7, 8});
  mesh.add_element(Shape::hexahedron, std::array{0, 1, 2, 3, 4, 5, 6, 7});
  mesh.label = {127, -3};
  mesh.cell_arrays["stiffness"] = {2, {1000, 0.1, 3000, 0.3}};
  mesh.point_arrays["distance"] = {1, {0, 1, 2, 3, 4, 5, 6, 7, 8}};
  return mesh;
}

inline Snapshot sample_state(const Mesh& mesh, double time) {
  Snapshot s;
  s.time = time;
  for (std::size_t n = 0; n < mesh.X.size(); ++n) {
    const double x = time + static_cast<double>(n);
    s.displacement.push_back({std::sin(x), std::cos(x), 1e-9 * x});
    s.velocity.push_back({x / 7, -x / 3, 1e5 * x});
    s.internal_force.push_back({1e-3 / (1 + x), 0, -x});
  }
  for (std::size_t e = 0; e < mesh.shape.size(); ++e) {
    const double x = time + 10 * static_cast<double>(e);
    s.elements.stress.push_back({x + 1, x + 2, x + 3, x + 4, x + 5, x + 6});
    s.elements.strain.push_back({0.1 * x, -0.2, 0.3, 0.4, 0.5, 1.0 / 3});
    s.elements.J.push_back(1 + 1e-7 * x);
  }
  return s;
}

template <class Call>
std::string message_of(Call&& call, ErrorKind kind) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

inline std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Removed with everything in it at the end.
struct OwnFolder {
  std::filesystem::path path;
  OwnFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path = std::filesystem::temp_directory_path() /
           ("glisson_" + std::to_string(::getpid()) + "_" + test->name());
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace glisson
