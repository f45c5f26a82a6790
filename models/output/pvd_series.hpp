// A time series for ParaView: one .vtu per snapshot, with shells two .vtp as well, and a .pvd that lists the
// complete ones.
#pragma once

#include <glisson/models/output/write_state.hpp>
#include <string>
#include <vector>

namespace glisson {

/// Writes DIRECTORY/STEM.pvd and the files of write_state() as STEM_000000, STEM_000001, ... as they come.
/// Each file appears under its name only when it is complete, the .pvd last, so a killed process leaves every
/// earlier snapshot readable.
class PvdSeries {
 public:
  struct Entry {
    double time = 0;                 ///< [s]
    std::vector<std::string> files;  ///< relative to the directory, the .vtu first
  };

  /// A new series; makes the directory. The first snapshot replaces a series of the same name.
  PvdSeries(std::filesystem::path directory, std::string stem, VtuOptions options = {});
  /// Goes on with a series after a restart at `time`: keeps its snapshots up to and including that time and
  /// drops later ones. Starts a new series if there is none. Throws Error(input) if the .pvd is not one that
  /// this class wrote.
  static PvdSeries resume(std::filesystem::path directory, std::string stem, double time,
                          VtuOptions options = {});

  /// Times must not go back (Error(usage)); the same time again replaces the last snapshot.
  void write(const Mesh& mesh, const Snapshot& snapshot);

  const std::vector<Entry>& entries() const { return entries_; }
  std::filesystem::path collection() const { return directory_ / (stem_ + ".pvd"); }

 private:
  std::vector<Entry> listed() const;
  void replace_old_series();
  void write_collection(const std::vector<Entry>& entries) const;
  std::string state() const;

  std::filesystem::path directory_;
  std::string stem_;
  VtuOptions options_;
  std::vector<Entry> entries_;
  bool fresh_ = true;
};

}  // namespace glisson
