// The encoding of VTK's XML files: each array is cut into blocks, each block compressed; the header with the
// sizes and the blocks are coded in base64 separately (VTK file formats, "XML file formats", appendix on
// compressed inline data).
#include <glisson/models/output/vtk_xml_encoding.hpp>

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <glisson/core/base/error.hpp>
#include <limits>
#include <ostream>

namespace glisson::detail {
namespace {

constexpr std::size_t block_bytes = 1 << 18;

/// Bytes to base64 in pieces: what does not fill a group of 3 waits for the next call.
class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  void put(const unsigned char* data, std::size_t count) {
    std::string text;
    text.reserve(4 * (count + 2) / 3 + 4);
    for (std::size_t i = 0; i < count; ++i) {
      group_ = group_ << 8 | data[i];
      if (++held_ == 3) append(text, 4);
    }
    out_ << text;
  }

  void finish() {
    if (held_ == 0) return;
    const int letters = held_ + 1;
    group_ <<= 8 * (3 - held_);
    std::string text;
    append(text, letters);
    out_ << text << std::string(static_cast<std::size_t>(4 - letters), '=');
  }

 private:
  void append(std::string& text, int letters) {
    static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < letters; ++i) text += alphabet[group_ >> (18 - 6 * i) & 63];
    group_ = 0;
    held_ = 0;
  }

  std::ostream& out_;
  unsigned group_ = 0;
  int held_ = 0;
};

std::vector<unsigned char> compress_block(const unsigned char* data, std::size_t count, int level) {
  std::vector<unsigned char> packed(compressBound(static_cast<uLong>(count)));
  uLongf size = static_cast<uLongf>(packed.size());
  if (compress2(packed.data(), &size, data, static_cast<uLong>(count), level) != Z_OK)
    throw Error(ErrorKind::usage,
                "zlib cannot compress with level " + std::to_string(level) + ". Use 1 to 9.");
  packed.resize(size);
  return packed;
}

/// One compressed array: [blocks][block size][size of the last block if it is not full][compressed sizes...],
/// blocks. The sizes are known at the end; where the stream can go back the blocks are written as they come,
/// else they are held until then.
class CompressedArray {
 public:
  CompressedArray(std::ostream& out, std::size_t bytes, int level)
      : out_(out), body_(out), level_(level), start_(out.tellp()) {
    block_.reserve(std::min(bytes, block_bytes));
    header_.resize(3 + (bytes + block_bytes - 1) / block_bytes);
    header_[0] = header_.size() - 3, header_[1] = block_bytes, header_[2] = bytes % block_bytes;
    if (can_go_back()) write_header();
  }

  void put(const void* data, std::size_t bytes) {
    const auto* from = static_cast<const unsigned char*>(data);
    while (bytes > 0) {
      const std::size_t part = std::min(bytes, block_bytes - block_.size());
      block_.insert(block_.end(), from, from + part);
      from += part, bytes -= part;
      if (block_.size() == block_bytes) close_block();
    }
  }
  void finish() {
    if (!block_.empty()) close_block();
    if (!can_go_back()) write_header();
    for (const auto& block : held_) body_.put(block.data(), block.size());
    body_.finish();
    if (!can_go_back()) return;
    const auto end = out_.tellp();
    out_.seekp(start_);
    write_header();
    out_.seekp(end);
  }

 private:
  bool can_go_back() const { return start_ != std::ostream::pos_type(-1); }
  void write_header() {
    Base64 head(out_);
    head.put(reinterpret_cast<const unsigned char*>(header_.data()), header_.size() * sizeof(std::uint64_t));
    head.finish();
  }
  void close_block() {
    auto packed = compress_block(block_.data(), block_.size(), level_);
    block_.clear();
    header_[3 + closed_++] = packed.size();
    if (can_go_back())
      body_.put(packed.data(), packed.size());
    else
      held_.push_back(std::move(packed));
  }

  std::ostream& out_;
  Base64 body_;
  int level_;
  std::ostream::pos_type start_;
  std::vector<unsigned char> block_;
  std::vector<std::uint64_t> header_;
  std::size_t closed_ = 0;  ///< blocks
  std::vector<std::vector<unsigned char>> held_;
};

bool valid_utf8(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80 ? 1 : c >> 5 == 6 ? 2 : c >> 4 == 14 ? 3 : c >> 3 == 30 ? 4 : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
    i += length;
  }
  return true;
}

/// Names come from mesh files: what XML cannot hold becomes an underscore.
std::string attribute(const std::string& name) {
  const bool utf8 = valid_utf8(name);
  std::string text;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    switch (letter) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c < 0x20 || c == 0x7F || (c >= 0x80 && !utf8) ? '_' : letter;
    }
  }
  return text;
}

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  return "UInt8";
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

namespace {

/// `fill` puts `bytes` bytes into the array.
template <class T, class Fill>
void write_data_array(std::ostream& out, const std::string& name, int components, std::size_t bytes,
                      int level, const Fill& fill) {
  out << "<DataArray type=\"" << type_name<T>() << "\" Name=\"" << attribute(name) << '"';
  if (components != 1) out << " NumberOfComponents=\"" << components << '"';
  out << " format=\"binary\">\n";
  CompressedArray array(out, bytes, level);
  fill(array);
  array.finish();
  out << "\n</DataArray>\n";
}

}  // namespace

template <class T>
void write_array(std::ostream& out, const std::string& name, int components, std::span<const T> values,
                 int level) {
  write_data_array<T>(out, name, components, values.size_bytes(), level,
                      [&](CompressedArray& array) { array.put(values.data(), values.size_bytes()); });
}

template void write_array(std::ostream&, const std::string&, int, std::span<const float>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const double>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const std::int32_t>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const std::uint8_t>, int);

namespace {

template <class T>
void write_as(std::ostream& out, const Field& field, int level) {
  const auto fill = [&](CompressedArray& array) {
    std::vector<T> some;
    field.for_each_piece([&](std::span<const double> piece) {
      for (; !piece.empty(); piece = piece.subspan(some.size())) {
        some.resize(std::min(block_bytes / sizeof(T), piece.size()));
        std::transform(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(some.size()), some.begin(),
                       [](double value) { return static_cast<T>(value); });
        array.put(some.data(), some.size() * sizeof(T));
      }
    });
  };
  write_data_array<T>(out, field.name, field.components, field.value_count() * sizeof(T), level, fill);
}

}  // namespace

void write_field(std::ostream& out, const Field& field, const VtuOptions& options) {
  if (field.whole) return write_as<std::int32_t>(out, field, options.compression);
  if (options.precision == OutputPrecision::full) return write_as<double>(out, field, options.compression);
  write_as<float>(out, field, options.compression);
}

void begin_vtk_file(std::ostream& out, const char* type, const VtuOptions& options) {
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\"1.0\" byte_order=\""
      << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
      << "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<" << type << ">\n";
  if (options.time)
    out << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
           "format=\"ascii\">\n"
        << number(*options.time) << "\n</DataArray>\n</FieldData>\n";
}

double largest_value(OutputPrecision precision) {
  return precision == OutputPrecision::full ? std::numeric_limits<double>::max()
                                            : std::numeric_limits<float>::max();
}

}  // namespace glisson::detail
