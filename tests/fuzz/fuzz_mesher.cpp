// Any small image and any options given to the mesher: a mesh whose indices are right, or an Error.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesher/mesh_labels.hpp>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::size_t head = 24;
  if (size < head) return 0;
  glisson::LabelImage image;
  image.size = {1 + data[0] % 8, 1 + data[1] % 8, 1 + data[2] % 8};
  for (std::size_t a = 0; a < 3; ++a) {
    image.to_world[a][a] = data[3 + a] & 128 ? -1.0 - data[3 + a] % 16 : 0.25 * (1 + data[3 + a] % 16);
    image.to_world[a][(a + 1) % 3] = 0.05 * (data[6 + a] % 4);
  }
  glisson::MesherOptions options;
  std::memcpy(&options.voxel_mm, data + 12, sizeof options.voxel_mm);
  if (data[9] & 1) options.voxel_mm = 0.1 * data[20];
  options.element = data[10] & 1 ? glisson::Shape::hexahedron : glisson::Shape::tetrahedron;
  options.largest_only = data[10] & 2;
  options.one_region = data[10] & 4;
  options.min_component = data[11] % 10;
  options.max_elements = 3'000;
  if (data[9] & 2) options.labels = {data[21] % 5, data[22]};
  image.labels.resize(static_cast<std::size_t>(image.size[0]) * static_cast<std::size_t>(image.size[1]) *
                      static_cast<std::size_t>(image.size[2]));
  for (std::size_t i = 0; i < image.labels.size(); ++i) image.labels[i] = data[i % size] % 4;
  try {
    const auto result = glisson::mesh_labels(image, options);
    const auto nodes = result.mesh.node_count();
    const bool right = std::all_of(result.mesh.nodes.begin(), result.mesh.nodes.end(),
                                   [&](int n) { return n >= 0 && n < nodes; });
    if (!right || result.mesh.label.size() != result.mesh.shape.size() || result.mesh.element_count() == 0)
      std::abort();
  } catch (const glisson::Error&) {
  }
  return 0;
}
