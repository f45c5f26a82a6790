// All files of one state of a simulation.
#pragma once

#include <glisson/models/output/vtu_writer.hpp>
#include <string>
#include <vector>

namespace glisson {

/// Writes DIRECTORY/STEM.vtu, and with membranes or shells STEM.vtp (the mid-surface) and STEM_faces.vtp
/// (both faces). Returns the names, the .vtu first. `state` ends the message of a full disk, see
/// write_atomically.
std::vector<std::string> write_state(const std::filesystem::path& directory, const std::string& stem,
                                     const Mesh& mesh, const Snapshot& snapshot, VtuOptions options = {},
                                     const std::string& state = {});

}  // namespace glisson
