// Image files made byte by byte: what the tests of the image readers share.
#pragma once

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <glisson/models/image/label_image.hpp>
#include <string>
#include <vector>

namespace glisson {

using Bytes = std::vector<unsigned char>;

/// A NIfTI header that is written field by field in either byte order.
class NiftiFile {
 public:
  explicit NiftiFile(int version = 1, bool swap = false)
      : two_(version == 2), swap_(swap), bytes_(two_ ? 544 : 352) {
    put<std::int32_t>(0, two_ ? 540 : 348);
    if (two_) {
      std::memcpy(bytes_.data() + 4, "n+2\0\r\n\032\n", 8);
      put<std::int64_t>(168, 544);
    } else {
      std::memcpy(bytes_.data() + 344, "n+1", 4);
      put<float>(108, 352);
    }
    size(3, {2, 3, 4});
    type(2, 8);
    for (int d = 0; d < 4; ++d) pixdim(d, 1);
  }

  template <class T>
  NiftiFile& put(std::size_t at, T value) {
    std::array<unsigned char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    std::memcpy(bytes_.data() + at, raw.data(), sizeof(T));
    return *this;
  }
  NiftiFile& real(std::size_t at_1, std::size_t at_2, double value) {
    return two_ ? put<double>(at_2, value) : put<float>(at_1, static_cast<float>(value));
  }
  NiftiFile& dim(std::size_t d, std::int64_t n) {
    return two_ ? put<std::int64_t>(16 + 8 * d, n)
                : put<std::int16_t>(40 + 2 * d, static_cast<std::int16_t>(n));
  }
  NiftiFile& size(int dimensions, const std::vector<std::int64_t>& sizes) {
    dim(0, dimensions);
    for (std::size_t d = 0; d < sizes.size(); ++d) dim(d + 1, sizes[d]);
    return *this;
  }
  NiftiFile& type(int code, int bits) {
    put<std::int16_t>(two_ ? 12 : 70, static_cast<std::int16_t>(code));
    return put<std::int16_t>(two_ ? 14 : 72, static_cast<std::int16_t>(bits));
  }
  NiftiFile& pixdim(int d, double value) {
    const auto i = static_cast<std::size_t>(d);
    return real(76 + 4 * i, 104 + 8 * i, value);
  }
  NiftiFile& code(std::size_t at_1, std::size_t at_2, int value) {
    return two_ ? put<std::int32_t>(at_2, value) : put<std::int16_t>(at_1, static_cast<std::int16_t>(value));
  }
  NiftiFile& sform(const std::vector<double>& rows) {
    code(254, 348, 1);
    for (std::size_t i = 0; i < 12; ++i) real(280 + 4 * i, 400 + 8 * i, rows[i]);
    return *this;
  }
  template <class T>
  Bytes with(const std::vector<T>& voxels) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + voxels.size() * sizeof(T));
    for (std::size_t i = 0; i < voxels.size(); ++i) put<T>(at + i * sizeof(T), voxels[i]);
    return bytes_;
  }
  Bytes bytes() const { return bytes_; }

 private:
  bool two_, swap_;
  Bytes bytes_;
};

inline Bytes inr_file(const std::string& lines, const Bytes& voxels) {
  std::string head = "#INRIMAGE-4#{\n" + lines;
  head += std::string((252 - head.size() % 256 + 256) % 256, '\n') + "##}\n";
  Bytes bytes(head.begin(), head.end());
  bytes.insert(bytes.end(), voxels.begin(), voxels.end());
  return bytes;
}

inline Bytes zipped(const Bytes& bytes) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  Bytes packed(deflateBound(&z, bytes.size()) + 64);
  z.next_in = const_cast<unsigned char*>(bytes.data());
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = packed.data();
  z.avail_out = static_cast<uInt>(packed.size());
  deflate(&z, Z_FINISH);
  packed.resize(z.total_out);
  deflateEnd(&z);
  return packed;
}

/// Labels 0 ... n-1, so that every voxel is told apart.
template <class T>
std::vector<T> counting(std::size_t n) {
  std::vector<T> voxels(n);
  for (std::size_t i = 0; i < n; ++i) voxels[i] = static_cast<T>(i);
  return voxels;
}

}  // namespace glisson
