// Atomic files on POSIX: open(O_TRUNC) "x.part", write, fsync, close, rename, fsync of the folder.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <ostream>
#include <system_error>

namespace glisson {
namespace fs = std::filesystem;

namespace detail {

constexpr std::size_t buffer_bytes = 1 << 16;

FileBuffer::FileBuffer(int descriptor)
    : descriptor_(descriptor), start_(::lseek(descriptor, 0, SEEK_CUR)), buffer_(buffer_bytes) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

void FileBuffer::put(const char* data, std::size_t count) {
  std::int64_t reached = place_;
  place_ += static_cast<std::int64_t>(count);
  needed_ = std::max(needed_, place_);
  while (count > 0 && error_ == 0) {
    const ssize_t n = ::write(descriptor_, data, count);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      error_ = n < 0 ? errno : EIO;
      return;
    }
    reached += n;
    written_ = std::max(written_, reached);  // bytes written again count once
    data += n;
    count -= static_cast<std::size_t>(n);
  }
}

bool FileBuffer::flush() {
  put(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0;
}

FileBuffer::int_type FileBuffer::overflow(int_type c) {
  flush();
  if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
  return traits_type::not_eof(c);
}

std::streamsize FileBuffer::xsputn(const char* text, std::streamsize count) {
  if (count < epptr() - pptr()) {
    std::memcpy(pptr(), text, static_cast<std::size_t>(count));
    pbump(static_cast<int>(count));
  } else {
    flush();
    put(text, static_cast<std::size_t>(count));
  }
  return count;
}

int FileBuffer::sync() {
  flush();
  return 0;  // errors are reported once, at the end, with the bytes needed
}

FileBuffer::pos_type FileBuffer::seekoff(off_type offset, std::ios_base::seekdir from,
                                         std::ios_base::openmode) {
  if (start_ < 0 || offset != 0 || from != std::ios_base::cur) return pos_type(off_type(-1));
  return pos_type(start_ + place_ + (pptr() - pbase()));
}

FileBuffer::pos_type FileBuffer::seekpos(pos_type to, std::ios_base::openmode) {
  if (start_ < 0) return pos_type(off_type(-1));
  flush();
  place_ = off_type(to) - start_;
  if (error_ == 0 && ::lseek(descriptor_, off_type(to), SEEK_SET) < 0) error_ = errno;
  return to;
}

Descriptor::~Descriptor() { close(); }

int Descriptor::close() {
  if (value < 0) return 0;
  const int result = ::close(value);
  value = -1;
  return result == 0 ? 0 : errno;
}

std::string write_failure(const fs::path& path, int error, std::int64_t needed, std::int64_t written) {
  std::string text = "cannot write '" + path.string() + "': " + std::generic_category().message(error);
  if (needed > 0) {
    text += " (" + std::to_string(needed) + " bytes needed, " + std::to_string(written) + " written";
    std::error_code ignored;
    const auto space = fs::space(path.has_parent_path() ? path.parent_path() : fs::path("."), ignored);
    if (!ignored) text += "; " + std::to_string(space.available) + " bytes free";
    text += ")";
  }
  if (error == ENOSPC || error == EDQUOT || error == EFBIG)
    return text + ". Free some space, write less often, or choose another output directory.";
  return text + ". Check that the directory exists and may be written to.";
}

}  // namespace detail

namespace {

[[noreturn]] void fail(const std::string& message, const std::string& state) {
  throw Error(ErrorKind::run, state.empty() ? message : message + " " + state);
}

/// Follows links, so that the target is replaced and not the link.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

/// So that the new name itself survives a power failure. Some file systems cannot do it; then nothing is lost
/// but this.
void flush_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  detail::Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.value >= 0) ::fsync(descriptor.value);
}

/// Fills the descriptor and closes it; returns the first error or 0.
int fill(detail::Descriptor& descriptor, detail::FileBuffer& buffer,
         const std::function<void(std::ostream&)>& write, bool durable) {
  std::ostream out(&buffer);
  write(out);
  buffer.flush();
  int error = buffer.error();
  if (error == 0 && durable && ::fsync(descriptor.value) != 0) error = errno;
  const int at_close = descriptor.close();
  return error != 0 ? error : at_close;
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write,
                      const std::string& state) {
  std::error_code ignored;
  const fs::path target = resolved(path);
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) fail("cannot write '" + path.string() + "': it is a directory.", state);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  fs::path part = target;
  if (!in_place) part += ".part";

  const int flags = O_WRONLY | O_CLOEXEC | (in_place ? 0 : O_CREAT | O_TRUNC | O_NOFOLLOW);
  detail::Descriptor descriptor(::open(part.c_str(), flags, 0666));
  if (descriptor.value < 0) fail(detail::write_failure(path, errno, 0, 0), state);
  detail::FileBuffer buffer(descriptor.value);
  try {
    if (const int error = fill(descriptor, buffer, write, !in_place))
      fail(detail::write_failure(path, error, buffer.needed(), buffer.written()), state);
    if (!in_place && ::rename(part.c_str(), target.c_str()) != 0)
      fail(detail::write_failure(path, errno, 0, 0), state);
  } catch (...) {
    if (!in_place) fs::remove(part, ignored);
    throw;
  }
  if (!in_place) flush_folder_of(target);
}

}  // namespace glisson
