// Whether VTK can draw here. Debian's VTK ends the process when its X server is missing, so that is asked
// first.
#pragma once

#include <sys/types.h>

namespace glisson::viz {

/// False where a VTK that draws through X finds no X server with OpenGL.
bool display_usable();

/// An X server in memory (Xvfb) that lives as long as this object; DISPLAY names it. Without the program Xvfb
/// nothing happens. Started directly: xvfb-run waits three seconds and has an exit code of its own.
class DisplayInMemory {
 public:
  DisplayInMemory();
  DisplayInMemory(const DisplayInMemory&) = delete;
  DisplayInMemory& operator=(const DisplayInMemory&) = delete;
  ~DisplayInMemory();

 private:
  pid_t server_ = -1;
};

}  // namespace glisson::viz
