// Series, histories, text files: complete or absent, continued after a restart, honest about a full disk.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/history_csv.hpp>
#include <glisson/models/output/pvd_series.hpp>
#include <glisson/models/output/text_writer.hpp>
#include <ostream>
#include <sstream>

#include "tests/models/output_samples.hpp"

namespace glisson {
namespace {

namespace fs = std::filesystem;

/// A disk that is full after so many bytes of one file.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int);
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t file_count(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(OutputAtomic, ReplacesTheFileOnlyWhenItIsComplete) {
  const OwnFolder folder;
  const fs::path path = folder.path / "a.txt";
  write_atomically(path, [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(write_atomically(path,
                                [](std::ostream& out) {
                                  out << std::string(1 << 20, 'x');
                                  throw std::runtime_error("stopped");
                                }),
               std::runtime_error);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(file_count(folder.path), 1u);
  write_atomically(path, [](std::ostream& out) { out << std::string(100'000, 'y') << 7; });
  EXPECT_EQ(content(path), std::string(100'000, 'y') + "7");
}

TEST(OutputAtomic, APartLeftByAKilledProcessDoesNotDisturb) {
  const OwnFolder folder;
  const fs::path path = folder.path / "a.txt";
  std::ofstream(folder.path / "a.txt.part") << std::string(5000, 'z');
  write_atomically(path, [](std::ostream& out) { out << "new"; });
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(file_count(folder.path), 1u);
}

TEST(OutputAtomic, FollowsALinkAndKeepsIt) {
  const OwnFolder folder;
  std::ofstream(folder.path / "target") << "old";
  fs::create_symlink("target", folder.path / "link");
  write_atomically(folder.path / "link", [](std::ostream& out) { out << "new"; });
  EXPECT_TRUE(fs::is_symlink(folder.path / "link"));
  EXPECT_EQ(content(folder.path / "target"), "new");
}

TEST(OutputAtomic, SaysWhyAFileCannotBeWritten) {
  const OwnFolder folder;
  const auto write = [](std::ostream& out) { out << std::string(300'000, 'x'); };
  std::string message =
      message_of([&] { write_atomically(folder.path / "no" / "a", write); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "No such file or directory")) << message;
  message = message_of([&] { write_atomically(folder.path, write); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "is a directory")) << message;
  message = message_of([&] { write_atomically("/dev/full", write); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "No space left on device (300000 bytes needed, 0 written")) << message;
  const SmallDisk disk(100'000);
  message = message_of([&] { write_atomically(folder.path / "a", write, "State."); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "300000 bytes needed, 100000 written")) << message;
  EXPECT_TRUE(contains(message, "Free some space") && message.ends_with("State.")) << message;
  EXPECT_EQ(file_count(folder.path), 0u);
}

TEST(OutputSeries, ListsEachSnapshotWhenItIsComplete) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  PvdSeries series(folder.path / "new" / "folder", "liver");
  for (const double t : {0.0, 0.1, 0.30000000000000004}) series.write(mesh, sample_state(mesh, t));
  const std::string list = content(series.collection());
  EXPECT_TRUE(contains(list, "timestep=\"0.30000000000000004\" part=\"0\" file=\"liver_000002.vtu\""))
      << list;
  EXPECT_EQ(file_count(folder.path / "new" / "folder"), 4u);
  EXPECT_THROW(series.write(mesh, sample_state(mesh, 0.2)), Error);
  series.write(mesh, sample_state(mesh, 0.30000000000000004));
  EXPECT_EQ(series.entries().size(), 3u);
}

TEST(OutputSeries, AFullDiskLeavesTheLastSnapshotAndNamesIt) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  PvdSeries series(folder.path, "s");
  series.write(mesh, sample_state(mesh, 0));
  series.write(mesh, sample_state(mesh, 0.5));
  const std::string list = content(series.collection());
  {
    const SmallDisk disk(1000);
    const std::string message =
        message_of([&] { series.write(mesh, sample_state(mesh, 1)); }, ErrorKind::run);
    EXPECT_TRUE(contains(message, "s_000002.vtu") && contains(message, "bytes needed, 1000 written"))
        << message;
    EXPECT_TRUE(contains(message, "The last complete snapshot is '" +
                                      (folder.path / "s_000001.vtu").string() + "' (time 0.5)."))
        << message;
  }
  EXPECT_EQ(content(series.collection()), list);
  EXPECT_EQ(file_count(folder.path), 3u);
  series.write(mesh, sample_state(mesh, 1));  // space was made
  EXPECT_TRUE(contains(content(series.collection()), "s_000002.vtu"));
}

TEST(OutputSeries, AKilledProcessLeavesOnlyCompleteSnapshots) {
  const Mesh mesh = mixed_mesh();
  for (const int microseconds : {300, 1000, 3000, 10'000, 30'000}) {
    const OwnFolder folder;
    const pid_t child = fork();
    if (child == 0) {
      PvdSeries series(folder.path, "s");
      for (int n = 0;; ++n) series.write(mesh, sample_state(mesh, n));
    }
    ::usleep(static_cast<useconds_t>(microseconds));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    PvdSeries series = PvdSeries::resume(folder.path, "s", 1e9);
    for (const auto& entry : series.entries())
      EXPECT_TRUE(content(folder.path / entry.files[0]).ends_with("</VTKFile>\n")) << entry.files[0];
    series.write(mesh, sample_state(mesh, 1e9));  // whatever part was left behind does not disturb
    EXPECT_TRUE(contains(content(series.collection()), series.entries().back().files[0]));
  }
}

TEST(OutputSeries, NaNNeverReachesAFile) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  PvdSeries series(folder.path, "s");
  Snapshot state = sample_state(mesh, 0);
  state.velocity[3].z = std::nan("");
  const std::string message = message_of([&] { series.write(mesh, state); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "'velocity' is not a number at node 3")) << message;
  EXPECT_EQ(file_count(folder.path), 0u);
}

TEST(OutputSeries, GoesOnAfterARestart) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  {
    PvdSeries first(folder.path, "s");
    for (const double t : {0.0, 0.1, 0.2, 0.3}) first.write(mesh, sample_state(mesh, t));
  }
  PvdSeries second = PvdSeries::resume(folder.path, "s", 0.1);
  EXPECT_EQ(second.entries().size(), 2u);
  EXPECT_FALSE(fs::exists(folder.path / "s_000002.vtu"));
  second.write(mesh, sample_state(mesh, 0.15));
  const std::string list = content(second.collection());
  EXPECT_TRUE(contains(list, "\"0.15\" part=\"0\" file=\"s_000002.vtu\"") && !contains(list, "\"0.2\""))
      << list;
  EXPECT_TRUE(PvdSeries::resume(folder.path, "other", 1).entries().empty());
}

TEST(OutputSeries, ANewSeriesReplacesAnOldOneAndNothingElse) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  std::ofstream(folder.path / "s_mine.vtu") << "mine";
  PvdSeries first(folder.path, "s");
  for (const double t : {0.0, 0.1}) first.write(mesh, sample_state(mesh, t));
  PvdSeries second(folder.path, "s");
  second.write(mesh, sample_state(mesh, 5));
  EXPECT_FALSE(fs::exists(folder.path / "s_000001.vtu"));
  EXPECT_EQ(content(folder.path / "s_mine.vtu"), "mine");
  EXPECT_EQ(file_count(folder.path), 3u);
}

TEST(OutputSeries, ForeignCollectionsAreNotContinued) {
  const OwnFolder folder;
  const char* const foreign[] = {
      "",
      "<VTKFile",
      "<a/>",
      "<V><Collection><DataSet/></Collection></V>",
      "<V><Collection><DataSet timestep='x' file='s_000000.vtu'/></Collection></V>",
      "<V><Collection><DataSet timestep='nan' file='s_000000.vtu'/></Collection></V>",
      "<V><Collection><DataSet timestep='1' file='/etc/passwd'/></Collection></V>",
      "<V><Collection><DataSet timestep='1' file='s_../x.vtu'/></Collection></V>",
      "<V><Collection><DataSet timestep='1' file='s_000000.vtu'/><DataSet timestep='0' file='s_000001.vtu'/>"
      "</Collection></V>"};
  for (const char* text : foreign) {
    std::ofstream(folder.path / "s.pvd") << text;
    const std::string message =
        message_of([&] { PvdSeries::resume(folder.path, "s", 0.5); }, ErrorKind::input);
    EXPECT_TRUE(contains(message, "s.pvd: ") && contains(message, "cannot be continued")) << text << message;
  }
  EXPECT_THROW(PvdSeries(folder.path, "a/b"), Error);
  EXPECT_THROW(PvdSeries(folder.path / "s.pvd", "s"), Error);
}

TEST(OutputHistory, RowsAreReadableAtOnceAndContinued) {
  const OwnFolder folder;
  const fs::path path = folder.path / "history.csv";
  const std::vector<std::string> columns{"time [s]", "kinetic [J]"};
  {
    HistoryCsv history(path, columns);
    for (int step : {0, 10, 20, 30}) history.append(step, std::array{0.1 * step, 1.0 / 3});
    EXPECT_TRUE(contains(content(path), "step,time [s],kinetic [J]\n0,0,0.3333333333333333\n10,1,"));
  }
  std::ofstream(path, std::ios::app) << "40,4";  // killed in the middle of a row
  {
    HistoryCsv history = HistoryCsv::resume(path, columns, 1000);
    EXPECT_TRUE(content(path).ends_with("\n30,3,0.3333333333333333\n")) << content(path);
  }
  HistoryCsv history = HistoryCsv::resume(path, columns, 19);
  history.append(10, std::array{7.0, 7.0});  // the step of the restart again
  history.append(20, std::array{2.0, -1e-300});
  EXPECT_TRUE(content(path).ends_with("\n10,1,0.3333333333333333\n20,2,-1e-300\n")) << content(path);
  EXPECT_THROW(HistoryCsv::resume(path, {"time [s]"}, 5), Error);
  EXPECT_THROW(history.append(5, std::array{1.0, 1.0}), Error);
  EXPECT_THROW(history.append(30, std::array{1.0}), Error);
  const std::string message = message_of(
      [&] {
        history.append(30, std::array{1.0, HUGE_VAL});
      },
      ErrorKind::run);
  EXPECT_TRUE(contains(message, "'kinetic [J]' is not finite at step 30")) << message;
}

TEST(OutputHistory, AFullDiskLeavesCompleteRows) {
  const OwnFolder folder;
  const fs::path path = folder.path / "history.csv";
  HistoryCsv history(path, {"a"});
  history.append(0, std::array{1.0});
  const SmallDisk disk(fs::file_size(path) + 5);
  const std::string message = message_of([&] { history.append(1, std::array{1.23456789}); }, ErrorKind::run);
  EXPECT_TRUE(contains(message, "history.csv") && contains(message, "earlier rows are complete")) << message;
  EXPECT_EQ(content(path), "step,a\n0,1\n");
}

TEST(OutputText, RowsAreDegreesOfFreedomAndColumnsAreSnapshots) {
  const OwnFolder folder;
  const std::string prefix = (folder.path / "case_").string();
  const Mesh mesh = mixed_mesh();
  TextWriter writer(prefix, {"U", "S", "EKin", "U"});
  for (const double t : {0.0, 1.0, 2.0}) writer.write(sample_state(mesh, t), 10 * t, 1);
  EXPECT_EQ(writer.snapshot_count(), 3);
  EXPECT_FALSE(fs::exists(prefix + "U.txt"));
  writer.finish();
  std::istringstream U(content(prefix + "U.txt"));
  std::string row;
  int rows = 0;
  for (; std::getline(U, row); ++rows)
    if (rows == 4) {  // node 1, y
      EXPECT_EQ(row, "0.540302306 -0.416146837 -0.989992497");
    }
  EXPECT_EQ(rows, 27);
  EXPECT_TRUE(content(prefix + "S.txt").starts_with("1 2 3\n2 3 4\n"));
  EXPECT_EQ(content(prefix + "EKin.txt"), "0\n10\n20\n");
  EXPECT_EQ(file_count(folder.path), 3u);
}

TEST(OutputText, GoesOnAfterARestartWithTheSameFile) {
  const OwnFolder folder;
  const Mesh mesh = mixed_mesh();
  const std::string whole = (folder.path / "whole_").string(), parts = (folder.path / "parts_").string();
  TextWriter one(whole, {"U", "F", "E"});
  for (const double t : {0.0, 1.0, 2.0, 3.0}) one.write(sample_state(mesh, t), 0, 0);
  one.finish();
  {
    TextWriter first(parts, {"U", "F", "E"});
    for (const double t : {0.0, 1.0, 2.0}) first.write(sample_state(mesh, t), 0, 0);
    first.finish(true);
    std::ofstream(parts + "E.txt.columns", std::ios::app) << "killed in a column";
    fs::resize_file(parts + "F.txt.columns", fs::file_size(parts + "F.txt.columns") - 10);
  }
  TextWriter second = TextWriter::resume(parts, {"U", "F", "E"}, 2.5);
  EXPECT_EQ(second.snapshot_count(), 2);
  for (const double t : {1.0, 2.0, 3.0}) second.write(sample_state(mesh, t), 0, 0);
  second.finish();
  for (const char* name : {"U.txt", "F.txt", "E.txt"})
    EXPECT_EQ(content(parts + name), content(whole + name));
}

TEST(OutputText, RefusesUnknownVariablesNaNAndAFullDisk) {
  const OwnFolder folder;
  const std::string prefix = (folder.path / "").string();
  const Mesh mesh = mixed_mesh();
  EXPECT_TRUE(contains(message_of([&] { TextWriter(prefix, {"V"}); }, ErrorKind::usage),
                       "'V' is no output variable"));
  TextWriter writer(prefix, {"U", "E"});
  writer.write(sample_state(mesh, 0), 0, 0);
  Snapshot state = sample_state(mesh, 1);
  state.elements.strain[1].zz = std::nan("");
  EXPECT_TRUE(contains(message_of([&] { writer.write(state, 0, 0); }, ErrorKind::run), "element 1"));
  {
    const SmallDisk disk(fs::file_size(prefix + "U.txt.columns") + 100);
    const std::string message =
        message_of([&] { writer.write(sample_state(mesh, 1), 0, 0); }, ErrorKind::run);
    EXPECT_TRUE(contains(message, "224 bytes needed, 100 written")) << message;
  }
  writer.write(sample_state(mesh, 1), 0, 0);
  writer.finish();
  EXPECT_TRUE(content(prefix + "U.txt").starts_with("0 0.841470985\n")) << content(prefix + "U.txt");
}

}  // namespace
}  // namespace glisson
