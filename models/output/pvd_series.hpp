// A time series for ParaView: one .vtu per snapshot and a .pvd that lists the complete ones.
#pragma once

#include <glisson/models/output/vtu_writer.hpp>
#include <string>
#include <vector>

namespace glisson {

/// Writes DIRECTORY/STEM.pvd and DIRECTORY/STEM_000000.vtu, STEM_000001.vtu, ... as they come. Each file
/// appears under its name only when it is complete, the .vtu before the .pvd, so a killed process leaves
/// every earlier snapshot readable.
class PvdSeries {
 public:
  struct Entry {
    double time = 0;   ///< [s]
    std::string file;  ///< relative to the directory
  };

  /// A new series; makes the directory. The first snapshot replaces a series of the same name.
  PvdSeries(std::filesystem::path directory, std::string stem, VtuOptions options = {});
  /// Goes on with a series after a restart at `time`: keeps its snapshots up to and including that time and
  /// drops later ones. Starts a new series if there is none. Throws Error(input) if the .pvd is not one that
  /// this class wrote.
  static PvdSeries resume(std::filesystem::path directory, std::string stem, double time,
                          VtuOptions options = {});

  /// Times must not go back (Error(usage)); the same time again replaces the last snapshot.
  void write(double time, const Mesh& mesh, const Fields& fields);
  void write(const Mesh& mesh, const Snapshot& snapshot) { write(snapshot.time, mesh, snapshot.fields()); }

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
