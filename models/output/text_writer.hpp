// The text files of NiftySim: U F S E EKin EStrain. A row is a degree of freedom, a column is a snapshot.
#pragma once

#include <filesystem>
#include <glisson/models/output/fields.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glisson {

/// Snapshots go to one binary file per variable as they come ("PREFIXU.txt.columns"); finish() turns rows and
/// columns and writes "PREFIXU.txt". Memory does not grow with the number of snapshots.
///   U displacement, F internal force: 3 rows per node. S second Piola-Kirchhoff stress, E Green-Lagrange
///   strain: 6 rows per element, 11 22 33 12 23 13. EKin, EStrain: one value per snapshot and line.
class TextWriter {
 public:
  /// `prefix` is put before the names as it is ("out/" or "out/case1_"). Throws Error(usage) for an unknown
  /// variable.
  TextWriter(std::string prefix, const std::vector<std::string>& variables);
  /// Goes on after a restart at `time` with the columns up to that time that finish(true) or a killed run
  /// left.
  static TextWriter resume(const std::string& prefix, const std::vector<std::string>& variables, double time);
  TextWriter(TextWriter&&) noexcept;
  TextWriter& operator=(TextWriter&&) noexcept;
  ~TextWriter();

  /// Energies in [J]. Throws Error(run) for a value that is not finite and when the disk is full.
  void write(const Snapshot& snapshot, double kinetic, double strain);
  /// Writes the text files, atomically. `keep_columns`: the run will be resumed; otherwise the binary files
  /// are removed.
  void finish(bool keep_columns = false);

  int snapshot_count() const;

 private:
  struct Empty {};
  struct Columns;
  explicit TextWriter(Empty);
  std::vector<std::unique_ptr<Columns>> variables_;
};

}  // namespace glisson
