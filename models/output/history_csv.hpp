// History of a run: one line of numbers per monitored step, readable while the run goes on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glisson {

namespace detail {
struct Descriptor;
}

/// Comma-separated values: the first column is "step", numbers have as many digits as they need. Each row is
/// handed to the system in one piece when it is written; a row that does not fit on the disk is taken back.
class HistoryCsv {
 public:
  /// A new file with a header line; an old one is replaced. `columns`: names after "step", with their units.
  HistoryCsv(std::filesystem::path path, std::vector<std::string> columns);
  /// Goes on after a restart at `step`: later rows and an unfinished last row are cut off. A new file if
  /// there is none. Throws Error(input) if the columns are not the same.
  static HistoryCsv resume(std::filesystem::path path, std::vector<std::string> columns, std::int64_t step);
  HistoryCsv(HistoryCsv&&) noexcept;
  HistoryCsv& operator=(HistoryCsv&&) noexcept;
  ~HistoryCsv();

  /// `values`: one per column. The last step again is left out (a restart may repeat it). Throws Error(run)
  /// for a value that is not finite and when the disk is full.
  void append(std::int64_t step, std::span<const double> values);

 private:
  struct Resumed {};
  HistoryCsv(Resumed, std::filesystem::path path, std::vector<std::string> columns);
  void open(int flags);
  void put(const std::string& line);

  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::unique_ptr<detail::Descriptor> descriptor_;
  std::int64_t size_ = 0;        ///< of the complete rows [bytes]
  std::int64_t last_step_ = -1;  ///< of the last row [-]
};

}  // namespace glisson
