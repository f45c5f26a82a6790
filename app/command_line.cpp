#include <glisson/app/command_line.hpp>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <map>

#include <glisson/app/commands.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/models/format/suggest.hpp>
#include <glisson/version.hpp>

namespace glisson::app {
namespace {

/// The chosen subcommand with its arguments, once parsing is done.
using Action = std::function<int()>;

const std::map<std::string, Precision> precisions{{"single", Precision::single_precision},
                                                  {"double", Precision::double_precision}};
const std::map<std::string, LogLevel> log_levels{{"error", LogLevel::error},
                                                 {"warning", LogLevel::warning},
                                                 {"info", LogLevel::info},
                                                 {"debug", LogLevel::debug}};

/// An option whose value is one of the names of a table.
template <class T>
CLI::Option* add_named(CLI::App& command, const std::string& option, T& value,
                       const std::map<std::string, T>& table, const std::string& description) {
  const auto assign = [&value, &table](const std::string& name) { value = table.at(name); };
  return command.add_option_function<std::string>(option, assign, description)
      ->check(CLI::IsMember(&table))
      ->type_name("NAME");
}

void add_device(CLI::App& command, SimulationOptions& simulation) {
  command.add_option("--device", simulation.device, "auto, cpu, serial, emulated, cuda or cuda:N")
      ->capture_default_str();
  command.add_option("--threads", simulation.threads, "worker threads; 0: one per core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  add_named(command, "--precision", simulation.precision, precisions, "single or double");
  command.add_option("--instruction-set", simulation.instruction_set, "auto, sse4.2, avx2 or avx512");
}

void add_run(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("run", "Run a simulation file");
  auto a = std::make_shared<RunArguments>();
  auto sport = std::make_shared<bool>(false), verbose = std::make_shared<bool>(false);
  auto* file = command->add_option("file,-x,--xml", a->file, "simulation file")->required();
  (void)file;
  command->add_option("-o,--output", a->directory, "directory for the results (default results/NAME)");
  command->add_option("--ensemble", a->table,
                      "table (.csv): one member per row, one value of the file per column");
  add_device(*command, a->simulation);
  command->add_flag("--resume", a->resume, "go on from the checkpoint in the output directory");
  command->add_flag("--lenient", a->lenient, "unknown names in the file are warnings");
  command->add_flag("-q,--quiet", a->quiet, "print errors only");
  add_named(*command, "--log-level", a->log_level, log_levels, "error, warning, info or debug");
  command
      ->add_option("--checkpoint-minutes", a->checkpoint_minutes,
                   "time between checkpoints; 0: only on Ctrl-C")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  auto* peer = command->add_option_group("Options of NiftySim, accepted with one dash too");
  peer->add_flag("-v", *verbose, "print more");
  peer->add_flag("-t", a->execution_time, "print the execution time");
  peer->add_flag("--plot", a->plot, "show the end in a window");
  peer->add_flag("--sport", *sport, "run on the GPU: --device cuda");
  peer->add_option("--print", a->print, "NF, LNF, LNFS, ND, ES or EK after the run; repeatable")
      ->check(CLI::IsMember({"NF", "LNF", "LNFS", "ND", "ES", "EK"}))
      ->allow_extra_args(false);
  peer->add_option("--output-prefix", a->text_prefix, "put before the names of U.txt and its like");
  peer->add_option("--export-mesh", a->export_mesh, "file (.vtu) for the end: solids");
  peer->add_option("--export-membrane", a->export_membrane, "file (.vtp) for the end: membranes and shells");
  command->callback([=, &action] {
    if (*sport && a->simulation.device == "auto") a->simulation.device = "cuda";
    if (*verbose) a->log_level = LogLevel::debug;
    action = [a] { return run(*a); };
  });
}

void add_check(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("check", "Check a simulation file: mesh, units, time step, memory, run time");
  auto a = std::make_shared<CheckArguments>();
  command->add_option("file", a->file, "simulation file")->required();
  command->add_flag("--lenient", a->lenient, "unknown names in the file are warnings");
  command->add_flag("!--no-prediction", a->predict, "do not run steps to predict the run time");
  add_device(*command, a->simulation);
  command->callback([=, &action] { action = [a] { return check(*a); }; });
}

void add_mesh(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("mesh", "Make a mesh of a label image (.nii, .nii.gz, .inr, .inr.gz)");
  auto a = std::make_shared<MeshArguments>();
  command->add_option("image", a->image, "label image")->required();
  command->add_option("-o,--output", a->output, "mesh file: .vtu, .vtk or .msh (default IMAGE.vtu, here)");
  command->add_option("--voxel", a->voxel, "edge of an element with its unit: 6mm, 0.5cm")->required();
  command->add_option("--element", a->element, "T4 (six per voxel) or H8")
      ->check(CLI::IsMember({"T4", "H8"}));
  command->add_option("--labels", a->labels, "labels to mesh, separated by commas (default: all but 0)")
      ->delimiter(',');
  command->add_flag("--one-region", a->one_region, "the labels become one region");
  command->add_flag("--largest-only", a->largest_only, "keep only the largest piece");
  command->add_option("--scale", a->scale, "of the positions, which are in mm: 0.001 gives metres")
      ->check(CLI::PositiveNumber);
  command->callback([=, &action] { action = [a] { return mesh(*a); }; });
}

void add_convert(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("convert", "Convert a mesh between Gmsh, VTK, VTU and STL");
  auto a = std::make_shared<ConvertArguments>();
  command->add_option("input", a->input, "mesh file")->required();
  command->add_option("output", a->output, "mesh file: .msh, .vtk, .vtu or .stl")->required();
  command->add_flag("--text", a->text, "text instead of binary, where the format has both");
  command->add_flag("--surface", a->surface, "read and write a surface (.stl)");
  command->add_option("--scale", a->scale, "of the positions")->check(CLI::PositiveNumber);
  command->callback([=, &action] { action = [a] { return convert(*a); }; });
}

void add_bench(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("bench", "Measure the time per step on box meshes");
  auto a = std::make_shared<BenchArguments>();
  command->add_option("--sizes", a->sizes, "numbers of elements, separated by commas")
      ->delimiter(',')
      ->check(CLI::Range(1, 100'000'000));
  command->add_option("--cases", a->cases, "variants, separated by commas (default: all)")->delimiter(',');
  command
      ->add_option("--ensembles", a->members,
                   "instead: ensembles of so many members against single runs, separated by commas")
      ->delimiter(',')
      ->check(CLI::Range(1, 100'000));
  command->add_option("--threads", a->threads, "worker threads; 0: one per core")->check(CLI::Range(0, 1024));
  command->add_option("--seconds", a->seconds, "for each variant and size")->check(CLI::Range(0.01, 600.0));
  command->add_option("--device", a->device, "cpu, serial or cuda[:N]");
  command->add_option("--json", a->json, "file for the results");
  command->callback([=, &action] { action = [a] { return bench(*a); }; });
}

/// Options are handed on as "--name=value"; viz::request_of reads them.
void add_drawing(CLI::App& app, Action& action, const std::string& name, const char* description) {
  auto* command = app.add_subcommand(name, description);
  auto a = std::make_shared<std::vector<std::string>>(std::vector<std::string>{name, ""});
  command->add_option("results", (*a)[1], ".pvd of a run, or a .vtu, .vtp or .vtk file")->required();
  const auto text = [&](const char* names, const std::string& option, const char* help) {
    const auto keep = [a, option](const std::string& value) { a->push_back(option + "=" + value); };
    return command->add_option_function<std::string>(names, keep, help);
  };
  const auto flag = [&](const std::string& option, const char* help) {
    command->add_flag_callback(
        option, [a, option] { a->push_back(option); }, help);
  };
  if (name == "picture") text("-o,--output", "--output", "file, .png")->required();
  text("--field", "--field", "displacement, velocity, stress, strain, J, label, ... or NAME:COMPONENT");
  text("--step", "--step", "number of the snapshot; negative from the end (default -1)");
  text("--scale", "--scale", "of the displacements (default 1)");
  text("--cut", "--cut", "plane: x=0.12, y=50% or nx,ny,nz@px,py,pz; the side of the eye is removed");
  text("--view", "--view", "oblique, front, back, left, right, top, bottom or x,y,z to the eye");
  text("--size", "--size", "WIDTHxHEIGHT in pixels (default 1200x900)");
  text("--model", "--model", "simulation file, for rigid bodies and loads (default: as in summary.json)");
  flag("--undeformed", "also the shape at rest");
  flag("--edges", "edges of the elements");
  flag("--loads", "marks for fixed nodes, prescribed motion, forces and pressure");
  if (name == "view") text("--seconds", "--seconds", "close the window after this time");
  command->callback([=, &action] { action = [a] { return picture(*a); }; });
}

void add_small(CLI::App& app, Action& action) {
  auto file = std::make_shared<std::string>();
  auto* command = app.add_subcommand("info", "Describe a simulation file, a mesh or a label image");
  command->add_option("file", *file, "file")->required();
  command->callback([=, &action] { action = [file] { return info(*file); }; });
  app.add_subcommand("devices", "List the devices of this machine")->callback([&] { action = devices; });
  app.add_subcommand("selftest", "Compare all backends of this machine on small cases")->callback([&] {
    action = selftest;
  });
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  const auto add = [&](const CLI::App& group) {
    for (const auto* option : group.get_options())
      for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  };
  add(command);
  for (const auto* group : command.get_subcommands([](const CLI::App*) { return true; })) add(*group);
  return names;
}

/// Adds the name that was probably meant.
std::string explain(const CLI::App& app, const CLI::ParseError& error,
                    const std::vector<std::string>& arguments) {
  const std::string text = error.what();
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) {
    std::vector<std::string> names;
    for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(command->get_name());
    if (arguments.empty() || arguments.front().starts_with("-")) return text + detail::suggestion("", names);
    return "There is no command '" + arguments.front() + "'" + detail::suggestion(arguments.front(), names);
  }
  const auto names = option_names(*chosen.front());
  for (const auto& argument : arguments) {
    const std::string word = argument.substr(0, argument.find('='));
    const bool known = std::find(names.begin(), names.end(), word) != names.end();
    if (known || !word.starts_with("-") || text.find(word) == std::string::npos) continue;
    const std::string near = detail::nearest(word, names);
    if (!near.empty()) return std::string(text).append("; did you mean ").append(near).append("?");
  }
  return text + ". See glisson " + chosen.front()->get_name() + " --help.";
}

}  // namespace

std::vector<std::string> with_own_names(std::vector<std::string> arguments) {
  const std::map<std::string, std::string> long_names{{"-sport", "--sport"},
                                                      {"-plot", "--plot"},
                                                      {"-print", "--print"},
                                                      {"-export-mesh", "--export-mesh"},
                                                      {"-export-membrane", "--export-membrane"},
                                                      {"-output-prefix", "--output-prefix"}};
  for (auto& argument : arguments)
    if (const auto found = long_names.find(argument); found != long_names.end()) argument = found->second;
  const std::vector<std::string> peer{"-x",
                                      "-v",
                                      "-t",
                                      "--sport",
                                      "--plot",
                                      "--print",
                                      "--output-prefix",
                                      "--export-mesh",
                                      "--export-membrane"};
  if (!arguments.empty() && std::find(peer.begin(), peer.end(), arguments.front()) != peer.end())
    arguments.insert(arguments.begin(), "run");
  return arguments;
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app{"Glisson: deformation of soft tissue by explicit finite elements", "glisson"};
  app.set_version_flag("--version", std::string("Glisson ") + version);
  app.require_subcommand(1);
  app.fallthrough(false);
  Action action;
  add_run(app, action);
  add_check(app, action);
  add_mesh(app, action);
  add_convert(app, action);
  add_bench(app, action);
  add_drawing(app, action, "picture", "Draw results to a PNG file");
  add_drawing(app, action, "view", "Show results in a window");
  add_small(app, action);
  const auto arguments = with_own_names({argv + 1, argv + argc});
  auto reversed = arguments;
  std::reverse(reversed.begin(), reversed.end());
  try {
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::fprintf(stderr, "error: %s\n", explain(app, error, arguments).c_str());
    return static_cast<int>(ErrorKind::usage);
  }
  return action();
}

}  // namespace glisson::app
