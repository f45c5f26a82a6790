// glisson-viz: the program behind glisson picture and glisson view. Exit codes are those of glisson.
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>

#include <vtkObject.h>

#include <glisson/core/base/error.hpp>

#include "display.hpp"
#include "picture.hpp"

namespace {

using glisson::Error;
using glisson::ErrorKind;

[[noreturn]] void no_display(bool window) {
  throw Error(
      ErrorKind::device,
      window ? "A window needs a display, and there is none here (DISPLAY). Use glisson picture for a "
               "file."
             : "VTK draws through an X server; there is none here (DISPLAY), and no Xvfb that would give "
               "one in memory. Install it: apt-get install xvfb");
}

int draw(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto request = glisson::viz::request_of(arguments);
  std::optional<glisson::viz::DisplayInMemory> display;
  vtkObject::GlobalWarningDisplayOff();
  glisson::viz::Scene scene(request);  // mistakes in the input come before those of the machine
  if (!scene.note().empty()) std::fprintf(stderr, "warning: %s\n", scene.note().c_str());
  if (!glisson::viz::display_usable()) {
    if (!request.window) display.emplace();
    if (request.window || !glisson::viz::display_usable()) no_display(request.window);
  }
  if (request.window)
    glisson::viz::open_window(scene);
  else
    glisson::viz::draw_picture(scene);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return draw(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(ErrorKind::run);
  }
}
