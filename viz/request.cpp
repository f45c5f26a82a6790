#include <glisson/viz/request.hpp>

#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include <glisson/core/base/error.hpp>

namespace glisson::viz {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& allowed) {
  throw Error(ErrorKind::usage, option + " '" + text + "' is not understood. " + allowed);
}

bool parse(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

bool parse(std::string_view text, Vec3<double>& v) {
  double* const parts[] = {&v.x, &v.y, &v.z};
  for (int k = 0; k < 3; ++k) {
    const auto comma = text.find(',');
    if ((comma == std::string_view::npos) != (k == 2) || !parse(text.substr(0, comma), *parts[k]))
      return false;
    if (k < 2) text.remove_prefix(comma + 1);
  }
  return true;
}

/// False for a vector without a direction.
bool normalise(Vec3<double>& v) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 1e-100) || !std::isfinite(length)) return false;
  v = (1 / length) * v;
  return true;
}

Vec3<double> eye_of(const std::string& text) {
  static const std::map<std::string, Vec3<double>> names{
      {"front", {0, -1, 0}}, {"back", {0, 1, 0}},    {"left", {-1, 0, 0}},          {"right", {1, 0, 0}},
      {"top", {0, 0, 1}},    {"bottom", {0, 0, -1}}, {"oblique", {0.45, -0.8, 0.4}}};
  Vec3<double> eye;
  const auto found = names.find(text);
  if (found != names.end())
    eye = found->second;
  else if (!parse(text, eye))
    refuse("--view", text,
           "Give oblique, front (from -y), back, left (from -x), right, top (from +z), bottom, or the "
           "direction to the eye as x,y,z.");
  if (!normalise(eye)) refuse("--view", text, "The direction must not be 0,0,0.");
  return eye;
}

Cut cut_of(const std::string& text) {
  const std::string allowed =
      "Give x=0.12 (a position), y=50% (of the bounding box) or nx,ny,nz@px,py,pz (normal and point).";
  Cut cut;
  if (const auto at = text.find('@'); at != std::string::npos) {
    if (!parse(std::string_view(text).substr(0, at), cut.normal) ||
        !parse(std::string_view(text).substr(at + 1), cut.point) || !normalise(cut.normal))
      refuse("--cut", text, allowed);
    return cut;
  }
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=') refuse("--cut", text, allowed);
  cut.normal = {text[0] == 'x' ? 1.0 : 0.0, text[0] == 'y' ? 1.0 : 0.0, text[0] == 'z' ? 1.0 : 0.0};
  const bool share = text.back() == '%';
  double value = 0;
  if (!parse(std::string_view(text).substr(2, text.size() - 2 - (share ? 1 : 0)), value))
    refuse("--cut", text, allowed);
  if (share && !(value > 0 && value < 100)) refuse("--cut", text, "The share must lie between 0% and 100%.");
  if (share)
    cut.share = value / 100;
  else
    cut.point = value * cut.normal;
  return cut;
}

void set_size(const std::string& text, Request& r) {
  const auto x = text.find('x');
  double width = 0, height = 0;
  if (x == std::string::npos || !parse(std::string_view(text).substr(0, x), width) ||
      !parse(std::string_view(text).substr(x + 1), height) || width < 64 || height < 64 || width > 8192 ||
      height > 8192 || width != std::floor(width) || height != std::floor(height))
    refuse("--size", text, "Give WIDTHxHEIGHT in pixels, each from 64 to 8192: 1200x900.");
  r.width = static_cast<int>(width), r.height = static_cast<int>(height);
}

double number(const std::string& option, const std::string& text, double lowest) {
  double value = 0;
  if (!parse(text, value) || value < lowest || std::abs(value) > 1e9)
    refuse(option, text, lowest < 0 ? "Give a whole number." : "Give a number that is not negative.");
  return value;
}

void set(Request& r, const std::string& option, const std::string& value) {
  const std::map<std::string, bool*> flags{
      {"--undeformed", &r.undeformed}, {"--edges", &r.edges}, {"--loads", &r.loads}};
  const std::map<std::string, std::string*> texts{
      {"--output", &r.output}, {"--field", &r.field}, {"--model", &r.model}};
  if (const auto flag = flags.find(option); flag != flags.end()) {
    *flag->second = true;
  } else if (const auto text = texts.find(option); text != texts.end()) {
    *text->second = value;
  } else if (option == "--cut") {
    r.cut = cut_of(value);
  } else if (option == "--view") {
    r.eye = eye_of(value);
  } else if (option == "--size") {
    set_size(value, r);
  } else if (option == "--scale") {
    r.scale = number(option, value, 0);
  } else if (option == "--seconds") {
    r.seconds = number(option, value, 0);
  } else if (option == "--step") {
    const double step = number(option, value, -1e9);
    if (step != std::floor(step)) refuse(option, value, "Give a whole number.");
    r.step = static_cast<int>(step);
  } else {
    throw Error(ErrorKind::usage, "There is no option " + option + ".");
  }
}

}  // namespace

Request request_of(std::span<const std::string> arguments) {
  if (arguments.size() < 2 || (arguments[0] != "picture" && arguments[0] != "view"))
    throw Error(ErrorKind::usage, "Give picture or view, then the results. See glisson picture --help.");
  Request r;
  r.window = arguments[0] == "view";
  r.results = arguments[1];
  normalise(r.eye);
  for (const auto& argument : arguments.subspan(2)) {
    const auto equals = argument.find('=');
    set(r, argument.substr(0, equals), equals == std::string::npos ? "" : argument.substr(equals + 1));
  }
  if (!r.window && r.output.empty()) throw Error(ErrorKind::usage, "A picture needs -o FILE.png.");
  if (!r.window && !r.output.ends_with(".png") && !r.output.ends_with(".PNG"))
    refuse("-o", r.output, "Pictures are PNG: give a name that ends in .png.");
  return r;
}

}  // namespace glisson::viz
