#include "display.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include <vtkRenderingOpenGLConfigure.h>
#include <vtkVersionMacros.h>
#include <X11/Xlib.h>

namespace glisson::viz {

bool display_usable() {
#if defined(VTK_USE_X) && VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  int opcode = 0, event = 0, error = 0;
  const bool has_opengl = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
  // Left open: a server without clients, as under xvfb-run, starts anew, and VTK would connect in the middle
  // of it.
  return has_opengl;
#else
  return true;  // since VTK 9.4 the way to draw is chosen when the program runs, without a display too
#endif
}

DisplayInMemory::DisplayInMemory() {
  int number[2];
  if (pipe(number) != 0) return;
  server_ = fork();
  if (server_ == 0) {
    close(number[0]);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1), dup2(nowhere, 2);
    const std::string pipe_end = std::to_string(number[1]);
    execlp("Xvfb", "Xvfb", "-displayfd", pipe_end.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
           "-noreset", nullptr);
    _exit(127);
  }
  close(number[1]);
  // The server writes its number when it is ready; the end of the pipe means that it is not there.
  std::string display = ":";
  for (char c = 0; read(number[0], &c, 1) == 1 && c != '\n';) display += c;
  close(number[0]);
  // NOLINTNEXTLINE(concurrency-mt-unsafe): VTK starts its threads later
  if (display.size() > 1) setenv("DISPLAY", display.c_str(), 1);
}

DisplayInMemory::~DisplayInMemory() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

}  // namespace glisson::viz
