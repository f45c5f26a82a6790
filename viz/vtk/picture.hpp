// A scene as a PNG file or in a window.
#pragma once

#include "scene.hpp"

class vtkRenderWindow;

namespace glisson::viz {

/// What the window shows. Throws Error(run) when the file cannot be written.
void write_picture(vtkRenderWindow* window, const std::string& path);
/// Offscreen, to the output of the request.
void draw_picture(Scene& scene);
/// Comes back when the user closes the window.
void open_window(Scene& scene);

}  // namespace glisson::viz
