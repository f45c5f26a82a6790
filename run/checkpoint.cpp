#include <glisson/run/checkpoint.hpp>

#include <cstring>
#include <fstream>
#include <sstream>

#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/run/model_hash.hpp>
#include <glisson/version.hpp>

namespace glisson {
namespace {

/// First bytes of the file; plain numbers of this machine.
struct Header {
  char mark[16] = "Glisson state 1";
  char version[16] = {};
  char device[48] = {};  ///< "Threads float": results of another kind of device have other bits
  std::uint64_t model = 0, size = 0, hash = 0;
  CheckpointExtras extras;
};
static_assert(std::is_trivially_copyable_v<Header>);

void set(char* to, std::size_t size, const std::string& text) { text.copy(to, size - 1); }

/// "Threads float, 2 threads, AVX-512": the number of threads does not change the bits.
std::string kind_of(const AnySimulation& simulation) {
  const std::string device = simulation.device();
  return device.substr(0, device.find(','));
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::input,
              why + ", so the run cannot go on from it. Run without --resume, or as the checkpoint was made.",
              {path.string(), 0, ""});
}

void require_fit(const std::filesystem::path& path, const Header& header, const AnySimulation& simulation,
                 std::uint64_t model) {
  if (header.version != std::string(version))
    refuse(path, "The checkpoint is of version " + std::string(header.version));
  if (header.model != model)
    refuse(path, "The checkpoint belongs to another model, or the model was changed");
  if (header.device != kind_of(simulation))
    refuse(path, "The checkpoint was made on '" + std::string(header.device) + "' and this run is on '" +
                     kind_of(simulation) + "'");
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const AnySimulation& simulation, std::uint64_t model,
                      const CheckpointExtras& extras) {
  std::ostringstream state;
  simulation.save(state);
  const std::string_view bytes = state.view();
  Header header;
  set(header.version, sizeof header.version, version);
  set(header.device, sizeof header.device, kind_of(simulation));
  header.model = model;
  header.size = bytes.size();
  header.hash = hash_bytes(bytes.data(), bytes.size());
  header.extras = extras;
  write_atomically(path, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

CheckpointExtras read_checkpoint(const std::filesystem::path& path, AnySimulation& simulation,
                                 std::uint64_t model) {
  std::error_code none;
  const auto file_size = std::filesystem::file_size(path, none);
  std::ifstream in(path, std::ios::binary);
  if (none || !in)
    throw Error(ErrorKind::input, "There is no checkpoint to resume from. Run without --resume.",
                {path.string(), 0, ""});
  Header header;
  const Header expected;
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header) ||
      std::memcmp(header.mark, expected.mark, sizeof header.mark) != 0)
    refuse(path, "The file is not a checkpoint of this program");
  header.version[sizeof header.version - 1] = header.device[sizeof header.device - 1] = 0;
  require_fit(path, header, simulation, model);
  if (header.size != file_size - sizeof header) refuse(path, "The checkpoint is cut off");
  std::string bytes(header.size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in || hash_bytes(bytes.data(), bytes.size()) != header.hash) refuse(path, "The checkpoint is damaged");
  std::istringstream state(std::move(bytes));
  simulation.load(state);
  return header.extras;
}

}  // namespace glisson
