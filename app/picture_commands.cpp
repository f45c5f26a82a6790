// glisson picture and view: hand over to glisson-viz, the program beside this one that draws with VTK.
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include <glisson/app/commands.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/viz/request.hpp>

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

fs::path drawing_program() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return (error ? fs::path(".") : self.parent_path()) / "glisson-viz";
}

[[noreturn]] void no_drawing_program() {
  throw Error(ErrorKind::device,
              "This build of Glisson has no pictures, because VTK was not there. Install it (Debian, Ubuntu: "
              "apt-get install libvtk9-dev xvfb xauth, 410 MB to download) and build again with "
              "-DGLISSON_VTK=ON.");
}

}  // namespace

int picture(const std::vector<std::string>& arguments) {
  viz::request_of(arguments);  // mistakes in the options are told with and without VTK
  const fs::path program = drawing_program();
  if (access(program.c_str(), X_OK) != 0) no_drawing_program();
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) != 127) return WEXITSTATUS(status);
  if (child > 0 && WIFSIGNALED(status))
    throw Error(ErrorKind::device, "VTK could not draw on this display (signal " +
                                       std::to_string(WTERMSIG(status)) +
                                       "). Try a display in memory: xvfb-run -a glisson picture ...");
  throw Error(ErrorKind::device,
              "The program '" + program.string() + "' cannot be started; are VTK's libraries installed?");
}

void show_end(const std::string& results) {
  try {
    picture({"view", results});
  } catch (const Error& error) {
    fmt::print(stderr, "warning: no window of the results: {}\n", error.what());
  }
}

}  // namespace glisson::app
