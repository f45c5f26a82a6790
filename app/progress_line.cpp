#include <glisson/app/progress_line.hpp>

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

#include <glisson/app/read_input.hpp>

namespace glisson::app {

ProgressLine::ProgressLine(bool wanted) : on_(wanted && isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const Progress& p) {
  if (!on_) return;
  std::string text = fmt::format("step {}", p.step);
  if (p.planned > 0)
    text += fmt::format(" of {} ({:.0f} %)", p.planned,
                        100.0 * static_cast<double>(p.step) / static_cast<double>(p.planned));
  text += fmt::format(", t = {:.4g} s, {:.0f} steps/s", p.time, p.steps_per_second);
  if (p.seconds_left) text += ", " + duration_text(*p.seconds_left) + " left";
  fmt::print(stderr, "\r{}\033[K", text);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace glisson::app
