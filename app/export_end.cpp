#include <glisson/app/export_end.hpp>

#include <filesystem>

#include <glisson/core/base/error.hpp>
#include <glisson/models/output/shell_sheets.hpp>

namespace glisson::app {
namespace {

void check_ending(const std::string& file, const std::string& ending, const std::string& option) {
  if (file.empty() || std::filesystem::path(file).extension() == ending) return;
  throw Error(ErrorKind::usage, option + " writes " + ending + " files only. Name it " +
                                    std::filesystem::path(file).replace_extension(ending).string() + ".");
}

}  // namespace

void check_exports(const RunArguments& arguments, const Model& model) {
  check_ending(arguments.export_mesh, ".vtu", "--export-mesh");
  check_ending(arguments.export_membrane, ".vtp", "--export-membrane");
  if (!arguments.export_membrane.empty() && model.shells.empty())
    throw Error(ErrorKind::usage,
                "--export-membrane: the file has no ShellElements. Add some, or leave the option out.");
}

void export_end(const RunArguments& arguments, const Model& model, const AnySimulation& simulation) {
  if (arguments.export_mesh.empty() && arguments.export_membrane.empty()) return;
  const Snapshot end = Snapshot::of(simulation);
  VtuOptions options;
  options.time = end.time;
  if (!arguments.export_mesh.empty()) write_vtu(arguments.export_mesh, model.mesh, end.fields(), options);
  if (arguments.export_membrane.empty()) return;
  const ShellSheet mid = mid_surface(model.mesh, end);
  write_vtp(arguments.export_membrane, mid.surface, mid.fields(), options);
}

}  // namespace glisson::app
