// Opens an image file and finds out what it is by its first bytes.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <glisson/models/image/image_bytes.hpp>
#include <glisson/models/image/label_image.hpp>
#include <new>
#include <system_error>

namespace glisson {

LabelImage parse_label_image(std::span<const unsigned char> file, const std::string& name,
                             const ImageLimits& limits) {
  detail::ImageBytes bytes(file, name);
  std::array<unsigned char, 4> start{};
  bytes.read_exactly(start.data(), start.size(), "first four bytes");
  try {
    if (std::memcmp(start.data(), "#INR", 4) == 0) return detail::parse_inr(bytes, start, limits);
    constexpr unsigned char sizes[4][4] = {// of the NIfTI-1 and NIfTI-2 headers, both byte orders
                                           {0x5C, 0x01, 0, 0},
                                           {0, 0, 0x01, 0x5C},
                                           {0x1C, 0x02, 0, 0},
                                           {0, 0, 0x02, 0x1C}};
    for (const auto& size : sizes)
      if (std::memcmp(start.data(), size, 4) == 0) return detail::parse_nifti(bytes, start, limits);
  } catch (const std::bad_alloc&) {
    throw bytes.error("the image does not fit into memory. Crop it or resample it to larger voxels.");
  }
  throw bytes.error("this is neither a NIfTI nor an INRIMAGE-4 image. Convert it to .nii or .nii.gz.",
                    "byte 0");
}

LabelImage read_label_image(const std::filesystem::path& path, const ImageLimits& limits) {
  const std::string name = path.string();
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure))
    throw Error(ErrorKind::input,
                "this is a directory, not an image. Give a .nii, .nii.gz, .inr or .inr.gz file.", {name});
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Error(ErrorKind::input,
                "the image cannot be opened: " + std::generic_category().message(errno) + ".", {name});
  // Read in pieces: the size of a pipe is not known, and a plain file larger than any image is refused before
  // it is held.
  constexpr std::size_t piece = 1 << 20, header_allowance = 1 << 20;
  const std::size_t most = static_cast<std::size_t>(limits.max_voxels) * 8 + header_allowance;
  std::vector<unsigned char> bytes;
  while (in) {
    const std::size_t have = bytes.size();
    if (have > most)
      throw Error(ErrorKind::input,
                  "the file is larger than any image that is read (" + std::to_string(most) + " bytes).",
                  {name});
    bytes.resize(have + piece);
    in.read(reinterpret_cast<char*>(bytes.data() + have), piece);
    bytes.resize(have + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw Error(ErrorKind::input, "the image cannot be read to its end.", {name});
  return parse_label_image(bytes, name, limits);
}

}  // namespace glisson
