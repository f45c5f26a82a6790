#include <glisson/app/read_input.hpp>
#include <glisson/core/base/error.hpp>

#include <fmt/core.h>

#include <chrono>
#include <cmath>

#include <glisson/models/format/read_model.hpp>

namespace glisson::app {

CheckedModel read_and_validate(const std::string& file, bool lenient) {
  const auto start = std::chrono::steady_clock::now();
  CheckedModel result;
  ReadOptions options;
  options.lenient = lenient;
  options.warnings = &result.warnings;
  result.model = read_model(file, options);
  for (auto& warning : in_file(file, [&] { return validate(result.model); }))
    result.warnings.push_back(std::move(warning));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string bytes_text(double bytes) {
  if (bytes >= 1e9) return fmt::format("{:.2f} GB", bytes / 1e9);
  if (bytes >= 1e6) return fmt::format("{:.1f} MB", bytes / 1e6);
  return fmt::format("{:.0f} kB", std::ceil(bytes / 1e3));
}

std::string duration_text(double seconds) {
  if (seconds < 1) return fmt::format("{:.2f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace glisson::app
