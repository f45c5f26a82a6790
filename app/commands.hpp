// What each subcommand is asked to do, and the function that does it; the result is the exit code.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include <glisson/run/runner.hpp>

namespace glisson::app {

/// 0 done, then the values of ErrorKind: 1 run failed, 2 usage, 3 bad input, 4 no such device,
/// no display or no VTK; 130
/// interrupted.
constexpr int exit_done = 0, exit_interrupted = 130;

struct RunArguments {
  std::string file, directory;  ///< directory empty: results/NAME
  SimulationOptions simulation;
  std::string table;  ///< of an ensemble's parameters; empty: a single run
  bool resume = false, lenient = false, quiet = false, execution_time = false;
  bool plot = false;  ///< a window with the end
  LogLevel log_level = LogLevel::info;
  double checkpoint_minutes = 10;
  std::vector<std::string> print;  ///< NF LNF LNFS ND ES EK
  std::optional<std::string> text_prefix;
  std::string export_mesh, export_membrane;  ///< .vtu, .vtp for the end; empty: none
};
int run(const RunArguments& arguments);
/// The ensemble of arguments.table; `stop` ends it.
int run_table(const RunArguments& arguments, const std::atomic<bool>& stop);

struct CheckArguments {
  std::string file;
  SimulationOptions simulation;
  bool lenient = false;
  bool predict = true;  ///< runs a few steps to predict the time of the run
};
int check(const CheckArguments& arguments);

/// Of a simulation file, a mesh or a label image.
int info(const std::string& file);

struct MeshArguments {
  std::string image, output, voxel, element = "T4";
  std::vector<int> labels;
  bool one_region = false, largest_only = false;
  double scale = 1;
};
int mesh(const MeshArguments& arguments);

struct ConvertArguments {
  std::string input, output;
  bool text = false, surface = false;
  double scale = 1;
};
int convert(const ConvertArguments& arguments);

/// "picture" or "view", the results, and "--name=value" as viz::request_of reads them. Error(device) without
/// VTK or a display.
int picture(const std::vector<std::string>& arguments);

/// The window after run --plot; without one, a warning: the results are there all the same.
void show_end(const std::string& results);

int devices();

struct BenchArguments {
  std::vector<int> sizes{10'000, 100'000};  ///< elements
  std::vector<std::string> cases;           ///< names of the variants; empty: all
  std::vector<int> members;                 ///< of ensembles to compare with single runs; empty: none
  int threads = 0;
  double seconds = 1;  ///< for each variant and size
  std::string json;    ///< file to write; empty: none
  std::string device = "cpu";
};
int bench(const BenchArguments& arguments);

int selftest();

}  // namespace glisson::app
