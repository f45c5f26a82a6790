// NIfTI-1 and NIfTI-2 single files (nifti1.h by R. W. Cox et al. 2004, nifti2.h 2011): offsets, types and the
// order in which the transforms are tried are those of the standard.
#include <bit>
#include <cmath>
#include <cstring>
#include <glisson/models/image/image_bytes.hpp>

namespace glisson::detail {
namespace {

constexpr std::size_t header_bytes_1 = 348, header_bytes_2 = 540;

/// Offsets of what is read, for one version of the header.
struct Layout {
  std::size_t magic, dim, datatype, bitpix, pixdim, vox_offset, slope, intercept, units, qform_code,
      sform_code, quatern, qoffset, srow;
};
constexpr Layout layout_1{344, 40, 70, 72, 76, 108, 112, 116, 123, 252, 254, 256, 268, 280};
constexpr Layout layout_2{4, 16, 12, 14, 104, 168, 176, 184, 500, 344, 348, 352, 376, 400};

class Header {
 public:
  Header(ImageBytes& bytes, std::span<const unsigned char, 4> start) {
    for (const bool swapped : {false, true}) {
      std::memcpy(raw_.data(), start.data(), 4);
      swap_ = swapped;
      const auto size = get<std::int32_t>(0);
      if (size != static_cast<std::int32_t>(header_bytes_1) &&
          size != static_cast<std::int32_t>(header_bytes_2))
        continue;
      two_ = size == static_cast<std::int32_t>(header_bytes_2);
      bytes.read_exactly(raw_.data() + 4, static_cast<std::size_t>(size) - 4, "NIfTI header");
      return;
    }
    throw bytes.error("this is no NIfTI header (its size is given as neither 348 nor 540).", "byte 0");
  }

  bool two() const { return two_; }
  bool swap() const { return swap_; }
  const Layout& at() const { return two_ ? layout_2 : layout_1; }
  std::string magic() const { return {reinterpret_cast<const char*>(raw_.data()) + at().magic, 3}; }

  std::int64_t dim(int i) const {
    return two_ ? wide<std::int64_t>(at().dim, i) : wide<std::int16_t>(at().dim, i);
  }
  double real(std::size_t offset, int i = 0) const {
    return two_ ? wide<double>(offset, i) : wide<float>(offset, i);
  }
  int code(std::size_t offset) const { return two_ ? get<std::int32_t>(offset) : get<std::int16_t>(offset); }
  int units() const { return (two_ ? get<std::int32_t>(at().units) : raw_[at().units]) & 7; }
  int small(std::size_t offset) const { return get<std::int16_t>(offset); }
  double vox_offset() const {
    return two_ ? static_cast<double>(get<std::int64_t>(at().vox_offset)) : get<float>(at().vox_offset);
  }
  std::int64_t size() const { return static_cast<std::int64_t>(two_ ? header_bytes_2 : header_bytes_1); }

 private:
  template <class T>
  T get(std::size_t offset) const {
    std::array<unsigned char, sizeof(T)> bytes;
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[swap_ ? sizeof(T) - 1 - i : i] = raw_[offset + i];
    return std::bit_cast<T>(bytes);
  }
  template <class T>
  T wide(std::size_t offset, int i) const {
    return get<T>(offset + sizeof(T) * static_cast<std::size_t>(i));
  }

  std::array<unsigned char, header_bytes_2> raw_{};
  bool swap_ = false, two_ = false;
};

void require_single_file(const ImageBytes& bytes, const Header& header) {
  const std::string magic = header.magic();
  if (magic == (header.two() ? "n+2" : "n+1")) return;
  if (magic == "ni1" || magic == "ni2")
    throw bytes.error(
        "the voxels are in a separate .img file, which is not read. Save the image as one .nii file.",
        "magic");
  throw bytes.error(
      "the NIfTI mark is missing, so this may be an Analyze 7.5 image, which has no safe orientation. Save "
      "the image as NIfTI.",
      "magic");
}

std::array<std::int64_t, 3> size_of(const ImageBytes& bytes, const Header& header) {
  const std::int64_t dimensions = header.dim(0);
  if (dimensions < 1 || dimensions > 7)
    throw bytes.error("the number of dimensions is " + std::to_string(dimensions) + "; it must be 1 to 7.",
                      "dim[0]");
  std::array<std::int64_t, 3> size{1, 1, 1};
  for (int d = 1; d <= dimensions; ++d) {
    const std::int64_t n = header.dim(d);
    const std::string place = "dim[" + std::to_string(d) + "]";
    if (n < 1) throw bytes.error("the size is " + std::to_string(n) + "; it must be at least 1.", place);
    if (d <= 3)
      size[static_cast<std::size_t>(d - 1)] = n;
    else if (n > 1)
      throw bytes.error("the image has " + std::to_string(n) +
                            " volumes or values per voxel along dimension " + std::to_string(d) +
                            ", and labels need exactly one. Extract one volume.",
                        place);
  }
  return size;
}

VoxelFormat format_of(const ImageBytes& bytes, const Header& header) {
  using Kind = VoxelFormat::Kind;
  struct Type {
    int code, bytes;
    Kind kind;
  };
  constexpr Type types[] = {{2, 1, Kind::unsigned_integer},
                            {4, 2, Kind::signed_integer},
                            {8, 4, Kind::signed_integer},
                            {16, 4, Kind::real},
                            {64, 8, Kind::real},
                            {256, 1, Kind::signed_integer},
                            {512, 2, Kind::unsigned_integer},
                            {768, 4, Kind::unsigned_integer},
                            {1024, 8, Kind::signed_integer},
                            {1280, 8, Kind::unsigned_integer}};
  const int code = header.small(header.at().datatype), bits = header.small(header.at().bitpix);
  for (const Type& type : types) {
    if (type.code != code) continue;
    if (bits != 0 && bits != 8 * type.bytes)
      throw bytes.error("data type " + std::to_string(code) + " has " + std::to_string(8 * type.bytes) +
                            " bits per voxel, and the header says " + std::to_string(bits) +
                            ". Write the image again.",
                        "bitpix");
    return {type.kind, type.bytes, header.swap()};
  }
  throw bytes.error(
      "data type " + std::to_string(code) +
          " is not read (colour, complex and 128-bit types hold no labels). Save the image with 8- or "
          "16-bit integers.",
      "datatype");
}

/// A slope of 0 (or none at all) means that the values are as they are stored.
void set_scaling(const ImageBytes& bytes, const Header& header, VoxelFormat& format) {
  const double slope = header.real(header.at().slope), intercept = header.real(header.at().intercept);
  if (slope == 0 || !std::isfinite(slope)) return;
  if (!std::isfinite(intercept))
    throw bytes.error("scl_inter is " + short_number(intercept) + ". Write the image again without scaling.",
                      "scl_inter");
  format.slope = slope;
  format.intercept = intercept;
}

double millimetres_per_unit(const Header& header) {
  switch (header.units()) {
    case 1:
      return 1000;  // metre
    case 3:
      return 0.001;  // micrometre
    default:
      return 1;  // millimetre, or not said
  }
}

double spacing(const ImageBytes& bytes, const Header& header, int axis) {
  const double value = header.real(header.at().pixdim, axis);
  if (!(value > 0) || !std::isfinite(value))
    throw bytes.error(
        "the voxel size is " + short_number(value) + "; it must be positive. Set the image's spacing.",
        "pixdim[" + std::to_string(axis) + "]");
  return value;
}

/// Method 2 of the standard: rotation from the quaternion (a, b, c, d), columns scaled, third one mirrored by
/// qfac.
void from_quaternion(const ImageBytes& bytes, const Header& header, LabelImage& image) {
  double b = header.real(header.at().quatern, 0), c = header.real(header.at().quatern, 1),
         d = header.real(header.at().quatern, 2);
  double a = 1 - (b * b + c * c + d * d);
  if (a < 1e-7) {  // a rotation by 180 degrees: the other three are made a unit vector
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length;
    c /= length;
    d /= length;
    a = 0;
  } else {
    a = std::sqrt(a);
  }
  const double R[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                          {2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)},
                          {2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c}};
  const double mirror = header.real(header.at().pixdim, 0) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      image.to_world[i][k] =
          R[i][k] * spacing(bytes, header, static_cast<int>(k) + 1) * (k == 2 ? mirror : 1);
    image.to_world[i][3] = header.real(header.at().qoffset, static_cast<int>(i));
  }
}

/// sform before qform before plain voxel sizes, as the standard recommends.
void set_affine(const ImageBytes& bytes, const Header& header, LabelImage& image) {
  std::string element = "pixdim";
  if (header.code(header.at().sform_code) > 0) {
    element = "sform";
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        image.to_world[i][k] = header.real(header.at().srow, static_cast<int>(4 * i + k));
  } else if (header.code(header.at().qform_code) > 0) {
    element = "qform";
    from_quaternion(bytes, header, image);
  } else {
    for (std::size_t i = 0; i < 3; ++i)
      image.to_world[i][i] = spacing(bytes, header, static_cast<int>(i) + 1);
  }
  const double unit = millimetres_per_unit(header);
  for (auto& row : image.to_world)
    for (double& value : row) value *= unit;
  require_affine(bytes, image, element);
}

void skip_to_voxels(ImageBytes& bytes, const Header& header) {
  const double first = header.two() ? 544 : 352;  // header and the four extension bytes
  double offset = header.vox_offset();
  if (offset == 0) offset = first;
  if (!(offset >= first) || offset > 1e15 || offset != std::floor(offset))
    throw bytes.error("the voxels begin at byte " + short_number(offset) +
                          "; a single file has them at byte " + short_number(first) +
                          " or later. Write the image again.",
                      "vox_offset");
  const std::int64_t count = static_cast<std::int64_t>(offset) - header.size();
  if (count > bytes.most_left())
    throw bytes.error("the voxels begin at byte " + short_number(offset) +
                          ", after the end of the file. Copy the file again.",
                      "vox_offset");
  bytes.skip(count, "extensions before the voxels");
}

}  // namespace

LabelImage parse_nifti(ImageBytes& bytes, std::span<const unsigned char, 4> start,
                       const ImageLimits& limits) {
  const Header header(bytes, start);
  require_single_file(bytes, header);
  LabelImage image;
  const auto size = size_of(bytes, header);
  VoxelFormat format = format_of(bytes, header);
  set_scaling(bytes, header, format);
  set_affine(bytes, header, image);
  skip_to_voxels(bytes, header);
  read_voxels(bytes, size, format, limits, image);
  return image;
}

}  // namespace glisson::detail
