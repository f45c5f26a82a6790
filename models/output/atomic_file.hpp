// Files that are either complete or absent: written beside their final name, flushed to the disk, then
// renamed. Snapshots, checkpoints and every other file that somebody may read after a crash go through here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <streambuf>
#include <string>
#include <vector>

namespace glisson {

/// Writes `path` so that a reader sees the old file or the complete new one, never a part: `write` fills
/// "path.part", which is flushed to the disk and renamed. A "path.part" left by a killed process is
/// overwritten. When `write` throws or a byte cannot be written, the part is removed and the old file stays.
/// Throws Error(run) with the file, the system's reason, the bytes needed and free, and `state` at the end of
/// the message ("The last complete snapshot is ..."). A path that exists and is no regular file (a pipe,
/// /dev/stdout) is written in place. A process that sets a file size limit must ignore SIGXFSZ itself; signal
/// handlers are not touched here.
void write_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write,
                      const std::string& state = {});

namespace detail {

/// Output buffer on a file descriptor that remembers the first system error. After an error it counts on
/// without writing, so that the message can say how many bytes were needed. Where the descriptor can, tellp
/// and seekp work.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(int descriptor);
  /// Writes what is buffered. False after any error.
  bool flush();
  int error() const { return error_; }  ///< errno of the first failure; 0: none
  std::int64_t written() const { return written_; }
  std::int64_t needed() const { return needed_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override;
  pos_type seekpos(pos_type to, std::ios_base::openmode) override;

 private:
  void put(const char* data, std::size_t count);

  int descriptor_, error_ = 0;
  std::int64_t written_ = 0, needed_ = 0;
  std::int64_t start_, place_ = 0;  ///< where it began in the file, -1 where that cannot be told; from there
  std::vector<char> buffer_;
};

/// "cannot write 'x': No space left on device (1000 bytes needed, 512 written; 0 bytes free). Free some space
/// ..."
std::string write_failure(const std::filesystem::path& path, int error, std::int64_t needed,
                          std::int64_t written);

/// Owns a descriptor; closes it at the end.
struct Descriptor {
  int value = -1;
  explicit Descriptor(int descriptor) : value(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  /// Closes now; returns errno or 0.
  int close();
};

}  // namespace detail
}  // namespace glisson
