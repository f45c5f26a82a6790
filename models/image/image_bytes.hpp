// The bytes of an image file, unpacked on the way if they are gzipped, and the reading of voxels from them.
#pragma once

#include <glisson/core/base/error.hpp>
#include <glisson/models/image/label_image.hpp>
#include <memory>
#include <span>
#include <string>

namespace glisson::detail {

/// Reads from front to back. Nothing is unpacked beyond what is asked for, so memory is bounded by the
/// caller's requests.
class ImageBytes {
 public:
  ImageBytes(std::span<const unsigned char> file, std::string name);
  ImageBytes(const ImageBytes&) = delete;
  ImageBytes& operator=(const ImageBytes&) = delete;
  ~ImageBytes();

  /// Fewer than asked for only at the end. Throws Error(input) for damaged compression.
  std::size_t read(unsigned char* to, std::size_t count);
  /// Throws Error(input) if the file ends before; `what` is being read.
  void read_exactly(unsigned char* to, std::size_t count, const std::string& what);
  void skip(std::int64_t count, const std::string& what);
  std::int64_t position() const { return position_; }  ///< after unpacking [bytes]
  /// No more than this can follow: deflate packs at most 1032 bytes into one.
  std::int64_t most_left() const;
  Error error(const std::string& message, const std::string& element = {}) const;

 private:
  struct Inflater;
  std::size_t inflate(unsigned char* to, std::size_t count);

  std::span<const unsigned char> file_;
  std::string name_;
  std::unique_ptr<Inflater> inflater_;  ///< null: not compressed
  std::int64_t position_ = 0;
};

/// How a voxel is stored; its label is slope * stored + intercept.
struct VoxelFormat {
  enum class Kind { unsigned_integer, signed_integer, real } kind = Kind::unsigned_integer;
  int bytes = 1;
  bool swap = false;  ///< the other byte order
  double slope = 1, intercept = 0;
};

/// Reads the voxels that follow; nothing may come after them. Sets size and labels.
void read_voxels(ImageBytes& bytes, const std::array<std::int64_t, 3>& size, const VoxelFormat& format,
                 const ImageLimits& limits, LabelImage& image);

/// Throws unless the affine is finite and spans a volume.
void require_affine(const ImageBytes& bytes, const LabelImage& image, const std::string& element);

/// `start`: the first bytes, already taken from `bytes`.
LabelImage parse_nifti(ImageBytes& bytes, std::span<const unsigned char, 4> start, const ImageLimits& limits);
LabelImage parse_inr(ImageBytes& bytes, std::span<const unsigned char, 4> start, const ImageLimits& limits);

std::string short_number(double value);

}  // namespace glisson::detail
