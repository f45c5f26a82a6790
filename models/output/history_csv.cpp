// Rows of numbers appended to a file, one write() each.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/history_csv.hpp>

namespace glisson {
namespace {

std::string header_of(const std::vector<std::string>& columns) {
  std::string line = "step";
  for (const std::string& column : columns) {
    if (column.find_first_of(",\"\n\r") != std::string::npos)
      throw Error(ErrorKind::usage,
                  "column name '" + column + "' holds a comma, quote or line end. Leave them out.");
    line += "," + column;
  }
  return line + "\n";
}

struct Kept {
  std::int64_t bytes = 0, last_step = -1;
};

/// Up to the end of the last complete row that belongs to `step` or before.
Kept rows_to_keep(const std::filesystem::path& path, const std::string& header, std::int64_t step) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line) || line + "\n" != header || in.eof())
    throw Error(
        ErrorKind::input,
        "the first line is not '" + header.substr(0, header.size() - 1) +
            "', so the history cannot be continued. Choose another output directory, or remove the file.",
        {path.string(), 1});
  Kept keep{static_cast<std::int64_t>(header.size()), -1};
  while (std::getline(in, line) && !in.eof()) {
    std::int64_t row = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), row);
    if (error != std::errc{} || stop == line.data() + line.size() || *stop != ',' || row > step) break;
    keep.bytes += static_cast<std::int64_t>(line.size()) + 1;
    keep.last_step = row;
  }
  return keep;
}

}  // namespace

HistoryCsv::HistoryCsv(HistoryCsv&&) noexcept = default;
HistoryCsv& HistoryCsv::operator=(HistoryCsv&&) noexcept = default;
HistoryCsv::~HistoryCsv() = default;

HistoryCsv::HistoryCsv(Resumed, std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {}

HistoryCsv::HistoryCsv(std::filesystem::path path, std::vector<std::string> columns)
    : HistoryCsv(Resumed{}, std::move(path), std::move(columns)) {
  const std::string header = header_of(columns_);
  open(O_TRUNC);
  put(header);
}

HistoryCsv HistoryCsv::resume(std::filesystem::path path, std::vector<std::string> columns,
                              std::int64_t step) {
  if (!std::filesystem::exists(path)) return HistoryCsv(std::move(path), std::move(columns));
  HistoryCsv history(Resumed{}, std::move(path), std::move(columns));
  const Kept kept = rows_to_keep(history.path_, header_of(history.columns_), step);
  history.size_ = kept.bytes;
  history.last_step_ = kept.last_step;
  history.open(0);
  if (::ftruncate(history.descriptor_->value, history.size_) != 0)
    throw Error(ErrorKind::run, detail::write_failure(history.path_, errno, 0, 0));
  return history;
}

void HistoryCsv::open(int flags) {
  descriptor_ = std::make_unique<detail::Descriptor>(
      ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | flags, 0666));
  if (descriptor_->value < 0) throw Error(ErrorKind::run, detail::write_failure(path_, errno, 0, 0));
}

void HistoryCsv::put(const std::string& line) {
  const auto length = static_cast<std::int64_t>(line.size());
  std::int64_t done = 0;
  while (done < length) {
    const ssize_t n =
        ::write(descriptor_->value, line.data() + done, static_cast<std::size_t>(length - done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      const int error = n < 0 ? errno : EIO;
      if (done > 0 && ::ftruncate(descriptor_->value, size_) != 0) done = 0;
      throw Error(ErrorKind::run,
                  detail::write_failure(path_, error, length, 0) + " All earlier rows are complete.");
    }
    done += n;
  }
  size_ += length;
}

void HistoryCsv::append(std::int64_t step, std::span<const double> values) {
  if (values.size() != columns_.size())
    throw Error(ErrorKind::usage, "'" + path_.string() + "' has " + std::to_string(columns_.size()) +
                                      " columns after the step, and the row has " +
                                      std::to_string(values.size()) + " values. Give one value per column.");
  if (step < last_step_)
    throw Error(ErrorKind::usage, "step " + std::to_string(step) + " cannot follow step " +
                                      std::to_string(last_step_) + " in '" + path_.string() + "'.");
  if (step == last_step_) return;
  std::string line = std::to_string(step);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw Error(ErrorKind::run,
                  "'" + columns_[i] + "' is not finite at step " + std::to_string(step) +
                      "; no such value is written to a file. The simulation has diverged: use a "
                      "smaller time step or check the loads.");
    char text[32];
    line += ',';
    line.append(text, std::to_chars(text, text + sizeof text, values[i]).ptr);
  }
  put(line + "\n");
  last_step_ = step;
}

}  // namespace glisson
