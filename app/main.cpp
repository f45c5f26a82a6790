// The command line: reads the arguments, runs one subcommand and turns errors into exit codes.
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include <glisson/app/command_line.hpp>
#include <glisson/app/commands.hpp>
#include <glisson/core/base/error.hpp>

int main(int argc, char** argv) {
  // A full disk or a reader that went away shows as an error of the write, not as the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return glisson::app::parse_and_run(argc, argv);
  } catch (const glisson::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "error: The memory of this machine is not enough for this input.\n");
    return static_cast<int>(glisson::ErrorKind::run);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s (this is a mistake in Glisson; please report it)\n", error.what());
    return static_cast<int>(glisson::ErrorKind::run);
  }
}
