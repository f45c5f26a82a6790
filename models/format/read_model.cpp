#include <glisson/models/format/read_model.hpp>

#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/schema.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace glisson {
namespace detail {
namespace {

namespace fs = std::filesystem;

/// A file, or a pipe; a device like /dev/zero may have no end.
bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) || fs::is_fifo(path, ignored);
}

std::string why_not_open(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return "'" + path + "' is a folder; name the simulation file in it";
  return "the file '" + path + "' cannot be opened; check its name and permissions";
}

std::string contents_of(const std::string& path, const Place& place) {
  if (!is_file(path)) throw Error(ErrorKind::input, why_not_open(path), place);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(ErrorKind::input, why_not_open(path), place);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw Error(ErrorKind::input, "the file '" + path + "' cannot be read to its end", place);
  return std::move(text).str();
}

}  // namespace

void Reader::warn(const XmlElement& element, const std::string& message) const {
  if (options_.warnings != nullptr) options_.warnings->push_back(located(element.place(), message));
}

void Reader::complain(const XmlElement& element, int line, const std::string& message) const {
  if (!options_.lenient) element.fail(line, message);
  if (options_.warnings != nullptr)
    options_.warnings->push_back(located(element.place(line), message + " (ignored)"));
}

std::string Reader::find_file(const XmlElement& element, const std::string& path) const {
  if (!options_.allow_files) element.fail("files are not allowed here, but '" + path + "' is asked for");
  const fs::path beside = fs::path(file_).parent_path() / path;  // an absolute path stays as it is
  if (is_file(beside)) return beside.string();
  if (is_file(path)) {
    warn(element,
         "'" + path + "' is not beside the simulation file; the one in the working directory is used");
    return path;
  }
  element.fail("the file '" + path + "' is neither at '" + beside.string() +
               "' nor in the working directory '" + fs::current_path().string() + "'");
}

FileText Reader::text_in_file(const XmlElement& element, const std::string& path) const {
  const auto found = find_file(element, path);
  return {found, contents_of(found, element.place())};
}

std::vector<double> Reader::numbers_in_file(const XmlElement& element, const std::string& path,
                                            std::size_t most) const {
  const auto [found, content] = text_in_file(element, path);
  const XmlText text{content, 1};
  std::vector<double> values;
  for_each_token(text, [&, path = found](std::string_view token, int line) {
    const auto value = to_number(token);
    if (!value)
      throw Error(ErrorKind::input, "'" + std::string(token.substr(0, 40)) + "' is not a finite number",
                  {path, line, ""});
    if (values.size() == most)
      throw Error(ErrorKind::input,
                  "the file holds more than the " + std::to_string(most) + " values that are needed",
                  {path, line, ""});
    values.push_back(*value);
  });
  return values;
}

}  // namespace detail

Model parse_model(std::string_view xml, const std::string& file_name, const ReadOptions& options) {
  detail::XmlDocument document;
  detail::parse_xml(xml, file_name, document);
  return detail::model_of(document, file_name, options);
}

void detail::read_document(const std::string& path, XmlDocument& document) {
  parse_xml(contents_of(path, {}), path, document);
}

Model detail::model_of(const XmlDocument& document, const std::string& file_name,
                       const ReadOptions& options) {
  detail::Reader reader(options, file_name);
  const auto& root = document.root;
  detail::check_names(reader, root);
  TimeSettings time;
  detail::read_system_params(reader, root, time);
  detail::Part part = detail::read_level(reader, root);
  detail::read_contact(reader, root, part);
  detail::read_contact_surfaces(reader, root, part);
  detail::read_deformable_contact(reader, root, part);
  Model& model = part.model;
  model.time = time;
  detail::read_output(root, model.output);
  if (const auto units = root.attribute("units")) model.units = units->value;
  model.name = std::filesystem::path(file_name).stem().string();
  return std::move(part.model);
}

Model read_model(const std::string& path, const ReadOptions& options) {
  return parse_model(detail::contents_of(path, {}), path, options);
}

}  // namespace glisson
