// Any bytes given to the reader of OBJ files.
#include <tests/fuzz/mesh_input.hpp>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  return glisson::test::try_mesh(data, size, glisson::MeshFormat::obj);
}
