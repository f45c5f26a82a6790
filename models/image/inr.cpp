// INRIMAGE-4 (INRIA): a text header "#INRIMAGE-4#{" ... "##}" in blocks of 256 bytes, then the voxels.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <glisson/models/image/image_bytes.hpp>
#include <map>

namespace glisson::detail {
namespace {

constexpr std::size_t block_bytes = 256, max_blocks = 64;

std::string header_text(ImageBytes& bytes, std::span<const unsigned char, 4> start) {
  std::string text(reinterpret_cast<const char*>(start.data()), start.size());
  for (std::size_t block = 1; block <= max_blocks; ++block) {
    const std::size_t have = text.size();
    text.resize(block * block_bytes);
    bytes.read_exactly(reinterpret_cast<unsigned char*>(text.data()) + have, text.size() - have,
                       "INRIMAGE header");
    if (!text.starts_with("#INRIMAGE-4#{\n") && !text.starts_with("#INRIMAGE-4#{\r\n"))
      throw bytes.error("this is no INRIMAGE-4 header. Save the image as INRIMAGE-4 or NIfTI.", "byte 0");
    if (text.ends_with("##}\n")) return text;
  }
  throw bytes.error("the end mark ##} of the header is missing from the first " +
                        std::to_string(max_blocks * block_bytes) + " bytes. Write the image again.",
                    "header");
}

/// The KEY=value lines; lines that begin with # are comments.
class Header {
 public:
  Header(ImageBytes& bytes, std::span<const unsigned char, 4> start) : bytes_(bytes) {
    const std::string text = header_text(bytes, start);
    int line_number = 0;
    for (std::size_t at = 0; at < text.size();) {
      std::size_t end = text.find('\n', at);
      if (end == std::string::npos) end = text.size();
      std::string line = text.substr(at, end - at);
      at = end + 1;
      ++line_number;
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (line.empty() || line[0] == '#') continue;
      const std::size_t equals = line.find('=');
      if (equals == std::string::npos || equals == 0)
        throw bytes.error("'" + printable(line) + "' is not of the form KEY=value.", place(line_number));
      if (!values_.emplace(line.substr(0, equals), line.substr(equals + 1)).second)
        throw bytes.error("'" + printable(line.substr(0, equals)) + "' is given twice.", place(line_number));
    }
  }

  std::string text(const std::string& key, const char* otherwise = nullptr) const {
    const auto found = values_.find(key);
    if (found != values_.end()) return found->second;
    if (otherwise == nullptr)
      throw bytes_.error("'" + key + "' is missing. Write the image again.", "header");
    return otherwise;
  }

  template <class T>
  T number(const std::string& key, const char* otherwise = nullptr, const std::string& unit = {}) const {
    const std::string value = text(key, otherwise);
    std::string digits = value;
    if (!unit.empty() && digits.ends_with(unit)) digits.resize(digits.size() - unit.size());
    T result{};
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, result);
    if (error != std::errc{} || stop != end || !(std::abs(static_cast<double>(result)) < 1e18))
      throw bytes_.error("'" + printable(value) + "' is not a number.", key);
    return result;
  }

  Error error(const std::string& message, const std::string& key) const { return bytes_.error(message, key); }

  static std::string printable(std::string text) {
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    for (char& c : text)
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
    return text;
  }

 private:
  static std::string place(int line) { return "header line " + std::to_string(line); }

  const ImageBytes& bytes_;
  std::map<std::string, std::string> values_;
};

bool other_byte_order(const Header& header, int bytes) {
  const std::string cpu = header.text("CPU", bytes == 1 ? "decm" : nullptr);
  const bool little = cpu == "decm" || cpu == "alpha" || cpu == "pc";
  if (!little && cpu != "sun" && cpu != "sgi")
    throw header.error("'" + Header::printable(cpu) +
                           "' is not known. Use decm, alpha or pc for little endian, sun or sgi "
                           "for big endian.",
                       "CPU");
  return little != (std::endian::native == std::endian::little);
}

/// SCALE=2**n: the value of a fixed-point number is the stored one times 2^n.
double scale_of(const Header& header) {
  const std::string text = header.text("SCALE", "2**0");
  int power = 0;
  const char* end = text.data() + text.size();
  if (!text.starts_with("2**") || std::from_chars(text.data() + 3, end, power).ptr != end ||
      std::abs(power) > 62 || text.size() == 3)
    throw header.error("'" + Header::printable(text) + "' is not of the form 2**n.", "SCALE");
  return std::ldexp(1.0, power);
}

VoxelFormat format_of(const Header& header) {
  using Kind = VoxelFormat::Kind;
  VoxelFormat format;
  const std::string type = header.text("TYPE");
  const int bits = header.number<int>("PIXSIZE", nullptr, " bits");
  if (bits != 8 && bits != 16 && bits != 32 && bits != 64)
    throw header.error(std::to_string(bits) + " bits per voxel are not read; 8, 16, 32 and 64 are.",
                       "PIXSIZE");
  format.bytes = bits / 8;
  if (type == "float") {
    format.kind = Kind::real;
    if (bits < 32)
      throw header.error("a float has 32 or 64 bits, not " + std::to_string(bits) + ".", "PIXSIZE");
  } else if (type == "unsigned fixed" || type == "signed fixed") {
    format.kind = type[0] == 'u' ? Kind::unsigned_integer : Kind::signed_integer;
    format.slope = scale_of(header);
  } else {
    throw header.error(
        "'" + Header::printable(type) + "' is not read; unsigned fixed, signed fixed and float are.", "TYPE");
  }
  format.swap = other_byte_order(header, format.bytes);
  return format;
}

void set_affine(const ImageBytes& bytes, const Header& header, LabelImage& image) {
  constexpr const char* sizes[] = {"VX", "VY", "VZ"};
  constexpr const char* shifts[] = {"TX", "TY", "TZ"};
  constexpr const char* turns[] = {"RX", "RY", "RZ"};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto size = header.number<double>(sizes[a], "1");
    if (!(size > 0))
      throw header.error("the voxel size is " + short_number(size) + "; it must be positive.", sizes[a]);
    if (header.number<double>(turns[a], "0") != 0)
      throw header.error("a rotated image is not read. Resample it, or save it as NIfTI.", turns[a]);
    image.to_world[a][a] = size;
    image.to_world[a][3] = header.number<double>(shifts[a], "0");
  }
  require_affine(bytes, image, "header");
}

}  // namespace

LabelImage parse_inr(ImageBytes& bytes, std::span<const unsigned char, 4> start, const ImageLimits& limits) {
  const Header header(bytes, start);
  const auto values = header.number<std::int64_t>("VDIM", "1");
  if (values != 1)
    throw header.error(
        "the image has " + std::to_string(values) + " values per voxel, and labels need exactly one.",
        "VDIM");
  const std::array<std::int64_t, 3> size{header.number<std::int64_t>("XDIM"),
                                         header.number<std::int64_t>("YDIM"),
                                         header.number<std::int64_t>("ZDIM", "1")};
  const VoxelFormat format = format_of(header);
  LabelImage image;
  set_affine(bytes, header, image);
  read_voxels(bytes, size, format, limits, image);
  return image;
}

}  // namespace glisson::detail
