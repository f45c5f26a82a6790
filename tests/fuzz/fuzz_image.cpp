// Any bytes given to the reader of label images: an image or an Error, nothing else. Seeds are INRIMAGE
// and NIfTI files; the reader tells them apart by their first bytes.
#include <cstdlib>
#include <glisson/core/base/error.hpp>
#include <glisson/models/image/label_image.hpp>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    const auto image = glisson::parse_label_image({data, size}, "input", {.max_voxels = 1 << 20});
    const auto [n0, n1, n2] = image.size;
    if (image.labels.size() !=
        static_cast<std::size_t>(n0) * static_cast<std::size_t>(n1) * static_cast<std::size_t>(n2))
      std::abort();
  } catch (const glisson::Error&) {
  }
  return 0;
}
