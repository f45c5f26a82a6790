// gzip members are unpacked as they are asked for; voxels are converted in chunks, each value checked.
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <glisson/models/image/image_bytes.hpp>
#include <limits>

namespace glisson::detail {

constexpr std::int64_t deflate_limit = 1032;  // RFC 1951: 258 bytes from a match of 2 bits at best
constexpr std::size_t chunk_voxels = 1 << 16;

std::string short_number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

struct ImageBytes::Inflater {
  z_stream stream{};
  bool at_member_end = false;
  Inflater() {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream); }
};

ImageBytes::ImageBytes(std::span<const unsigned char> file, std::string name)
    : file_(file), name_(std::move(name)) {
  if (file_.size() >= 2 && file_[0] == 0x1F && file_[1] == 0x8B) inflater_ = std::make_unique<Inflater>();
}

ImageBytes::~ImageBytes() = default;

Error ImageBytes::error(const std::string& message, const std::string& element) const {
  return Error(ErrorKind::input, message, {name_, 0, element});
}

std::int64_t ImageBytes::most_left() const {
  const auto left = static_cast<std::int64_t>(file_.size());
  if (!inflater_) return left;
  constexpr std::int64_t window = 1 << 16;  // may still be inside zlib
  return left > std::numeric_limits<std::int64_t>::max() / (2 * deflate_limit)
             ? std::numeric_limits<std::int64_t>::max()
             : left * deflate_limit + window * deflate_limit;
}

std::size_t ImageBytes::inflate(unsigned char* to, std::size_t count) {
  z_stream& z = inflater_->stream;
  std::size_t done = 0;
  while (done < count) {
    if (inflater_->at_member_end) {
      if (file_.size() < 2 || file_[0] != 0x1F || file_[1] != 0x8B) break;  // padding after the last member
      inflateReset(&z);
      inflater_->at_member_end = false;
    }
    constexpr std::size_t most = 1 << 30;
    const auto in = static_cast<uInt>(std::min(file_.size(), most));
    const auto out = static_cast<uInt>(std::min(count - done, most));
    z.next_in = const_cast<unsigned char*>(file_.data());
    z.avail_in = in;
    z.next_out = to + done;
    z.avail_out = out;
    const int result = ::inflate(&z, Z_NO_FLUSH);
    file_ = file_.subspan(in - z.avail_in);
    done += out - z.avail_out;
    inflater_->at_member_end = result == Z_STREAM_END;
    const std::string place =
        "byte " + std::to_string(position_ + static_cast<std::int64_t>(done)) + " unpacked";
    if (result == Z_BUF_ERROR || (result == Z_OK && z.avail_in == 0 && z.avail_out > 0 && file_.empty()))
      throw error("the gzip data end too early, so the image is not complete. Copy the file again.", place);
    if (result != Z_OK && result != Z_STREAM_END)
      throw error("the gzip data are damaged (" + std::string(z.msg ? z.msg : "no details") +
                      "). Copy the file again.",
                  place);
  }
  return done;
}

std::size_t ImageBytes::read(unsigned char* to, std::size_t count) {
  if (inflater_) {
    count = inflate(to, count);
  } else {
    count = std::min(count, file_.size());
    if (count > 0) std::memcpy(to, file_.data(), count);
    file_ = file_.subspan(count);
  }
  position_ += static_cast<std::int64_t>(count);
  return count;
}

void ImageBytes::read_exactly(unsigned char* to, std::size_t count, const std::string& what) {
  if (read(to, count) != count)
    throw error("the file ends inside the " + what + ", so the image is not complete. Copy the file again.",
                "byte " + std::to_string(position_));
}

void ImageBytes::skip(std::int64_t count, const std::string& what) {
  std::array<unsigned char, 4096> waste;
  for (; count > 0; count -= std::min<std::int64_t>(count, waste.size()))
    read_exactly(waste.data(), static_cast<std::size_t>(std::min<std::int64_t>(count, waste.size())), what);
}

namespace {

std::string voxel_name(const std::array<std::int64_t, 3>& size, std::int64_t index) {
  return "voxel (" + std::to_string(index % size[0]) + ", " + std::to_string(index / size[0] % size[1]) +
         ", " + std::to_string(index / size[0] / size[1]) + ")";
}

template <class T>
T load(const unsigned char* from, bool swap) {
  std::array<unsigned char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swap) std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

/// Converts chunks of voxels of type T.
template <class T>
class Converter {
 public:
  Converter(const ImageBytes& bytes, const std::array<std::int64_t, 3>& size, const VoxelFormat& format)
      : bytes_(bytes), size_(size), format_(format), scaled_(format.slope != 1 || format.intercept != 0) {}

  void convert(const unsigned char* from, std::size_t count, std::vector<std::int32_t>& labels) const {
    for (std::size_t i = 0; i < count; ++i) {
      const T stored = load<T>(from + i * sizeof(T), format_.swap);
      if constexpr (sizeof(T) < 4) {
        if (!scaled_) {
          labels.push_back(static_cast<std::int32_t>(stored));
          continue;
        }
      }
      labels.push_back(whole(static_cast<double>(stored), static_cast<std::int64_t>(labels.size())));
    }
  }

 private:
  std::int32_t whole(double stored, std::int64_t index) const {
    const double value = scaled_ ? format_.slope * stored + format_.intercept : stored;
    const double nearest = std::round(value);
    // A slope in single precision is off by 6e-8 of its value; more is a grey value.
    const double tolerance = scaled_ ? std::min(1e-6 * std::max(1.0, std::abs(value)), 1e-2) : 0.0;
    if (!(std::abs(value - nearest) <= tolerance))
      throw bytes_.error(
          "value " + short_number(value) +
              " is not a whole number, so this is not an image of labels. Give a segmentation, not a "
              "grey-value image or a probability map.",
          voxel_name(size_, index));
    if (std::abs(nearest) > std::numeric_limits<std::int32_t>::max())
      throw bytes_.error("label " + short_number(value) + " does not fit into 32 bits. Renumber the labels.",
                         voxel_name(size_, index));
    return static_cast<std::int32_t>(nearest);
  }

  const ImageBytes& bytes_;
  const std::array<std::int64_t, 3>& size_;
  const VoxelFormat& format_;
  bool scaled_;
};

template <class T>
void read_as(ImageBytes& bytes, const std::array<std::int64_t, 3>& size, const VoxelFormat& format,
             std::vector<std::int32_t>& labels) {
  const Converter<T> converter(bytes, size, format);
  const auto total = static_cast<std::size_t>(size[0] * size[1] * size[2]);
  std::vector<unsigned char> chunk(std::min(chunk_voxels, total) * sizeof(T));
  while (labels.size() < total) {
    const std::size_t count = std::min(chunk_voxels, total - labels.size());
    bytes.read_exactly(chunk.data(), count * sizeof(T), "voxels");
    converter.convert(chunk.data(), count, labels);
  }
}

void read_by_type(ImageBytes& bytes, const std::array<std::int64_t, 3>& size, const VoxelFormat& format,
                  std::vector<std::int32_t>& labels) {
  using Kind = VoxelFormat::Kind;
  const bool is_signed = format.kind == Kind::signed_integer;
  if (format.kind == Kind::real)
    return format.bytes == 4 ? read_as<float>(bytes, size, format, labels)
                             : read_as<double>(bytes, size, format, labels);
  switch (format.bytes) {
    case 1:
      return is_signed ? read_as<std::int8_t>(bytes, size, format, labels)
                       : read_as<std::uint8_t>(bytes, size, format, labels);
    case 2:
      return is_signed ? read_as<std::int16_t>(bytes, size, format, labels)
                       : read_as<std::uint16_t>(bytes, size, format, labels);
    case 4:
      return is_signed ? read_as<std::int32_t>(bytes, size, format, labels)
                       : read_as<std::uint32_t>(bytes, size, format, labels);
    default:
      return is_signed ? read_as<std::int64_t>(bytes, size, format, labels)
                       : read_as<std::uint64_t>(bytes, size, format, labels);
  }
}

/// The number of voxels, checked against the limit and against what the file can hold.
std::int64_t voxel_count(const ImageBytes& bytes, const std::array<std::int64_t, 3>& size, int voxel_bytes,
                         const ImageLimits& limits) {
  const std::string dimensions =
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
  std::int64_t count = 1;
  for (const std::int64_t n : size) {
    if (n < 1)
      throw bytes.error("the image has " + dimensions + " voxels; every size must be at least 1.", "header");
    if (n > limits.max_voxels / count)
      throw bytes.error("the image has " + dimensions + " voxels, more than the limit of " +
                            std::to_string(limits.max_voxels) + ". Crop it or resample it to larger voxels.",
                        "header");
    count *= n;
  }
  if (count > bytes.most_left() / voxel_bytes)
    throw bytes.error("the header announces " + dimensions + " voxels of " + std::to_string(voxel_bytes) +
                          " bytes, and the file can hold at most " + std::to_string(bytes.most_left()) +
                          " more bytes, so the image is not complete. Copy the file again.",
                      "header");
  return count;
}

}  // namespace

void read_voxels(ImageBytes& bytes, const std::array<std::int64_t, 3>& size, const VoxelFormat& format,
                 const ImageLimits& limits, LabelImage& image) {
  const std::int64_t count = voxel_count(bytes, size, format.bytes, limits);
  for (std::size_t a = 0; a < 3; ++a) image.size[a] = static_cast<int>(size[a]);
  image.labels.clear();
  image.labels.reserve(static_cast<std::size_t>(count));
  read_by_type(bytes, size, format, image.labels);
  unsigned char more;
  if (bytes.read(&more, 1) != 0)
    throw bytes.error(
        "bytes follow after the last voxel, so the header does not belong to these voxels. Write the "
        "image again.",
        "byte " + std::to_string(bytes.position()));
}

void require_affine(const ImageBytes& bytes, const LabelImage& image, const std::string& element) {
  Mat3<double> A{};
  double volume_of_box = 1;
  for (std::size_t b = 0; b < 4; ++b) {
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double value = image.to_world[a][b];
      if (!(std::abs(value) < 1e9))
        throw bytes.error("the transform to world coordinates holds " + short_number(value) +
                              ", which is no position in mm. Set the image's transform again.",
                          element);
      if (b < 3) A.m[a][b] = value;
      square += value * value;
    }
    if (b < 3) volume_of_box *= std::sqrt(square);
  }
  if (!(std::abs(determinant(A)) > 1e-6 * volume_of_box) || !(volume_of_box > 1e-18))
    throw bytes.error("the transform to world coordinates is flat (voxel volume " +
                          short_number(std::abs(determinant(A))) + " mm^3). Set the image's transform again.",
                      element);
}

}  // namespace glisson::detail
