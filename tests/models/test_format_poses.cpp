// Motion Type="Poses": rows inline and from files, and each mistake with file and line.
#include <tests/models/format_base.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

/// The base file with a rigid surface; the motion begins at line 23.
std::string moved(const std::string& motion) {
  return replaced(base_xml, "  <SystemParams>",
                  "<ContactSurface><Nodes NumNodes=\"3\">0 0 -1 1 0 -1 1 1 -1</Nodes><Elements "
                  "NumEls=\"1\" Type=\"T3\">0 1 2</Elements>" +
                      motion + "</ContactSurface>\n  <SystemParams>");
}
std::string inline_table(const std::string& rows, const std::string& attributes = "") {
  return moved("<Motion Type=\"Poses\"" + attributes + "><Table>" + rows + "</Table></Motion>");
}

TEST(FormatPoses, InlineRows) {
  const auto poses = parsed(inline_table("0 0 0 0 0 0 0\n 0.5 1 2 3 0 0 1.5")).surfaces.at(0).poses;
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[1].time, 0.5);
  EXPECT_EQ(poses[1].shift.z, 3);
  EXPECT_NEAR(poses[1].turn[0], std::cos(0.75), 1e-15);
  EXPECT_NEAR(poses[1].turn[3], std::sin(0.75), 1e-15);

  const auto turned =
      parsed(inline_table("0 0 0 0 1 0 0 0 1 4 5 6 0.5 0.5 0.5 0.5001", " Rotation=\"Quaternion\""))
          .surfaces.at(0)
          .poses;
  ASSERT_EQ(turned.size(), 2U);
  EXPECT_NEAR(length_of(turned[1].turn), 1, 1e-15);
  EXPECT_NEAR(turned[1].turn[3], 0.5, 1e-4);

  const auto shifted = parsed(inline_table("0 0 0 0 1 4 5 6", " Rotation=\"None\"")).surfaces.at(0).poses;
  ASSERT_EQ(shifted.size(), 2U);
  EXPECT_EQ(shifted[1].shift.y, 5);
  EXPECT_EQ(shifted[1].turn, (Quaternion{1, 0, 0, 0}));
}

TEST(FormatPoses, TheCentreIsTheOriginOrAsTold) {
  EXPECT_EQ(parsed(inline_table("0 0 0 0 0 0 0 1 0 0 0 0 0 1")).surfaces.at(0).centre.x, 0);
  const auto model =
      parsed(moved("<Motion Type=\"Poses\"><Table>0 0 0 0 0 0 0 1 0 0 0 0 0 1</Table>"
                   "<Centre>1 2 3</Centre></Motion>"));
  EXPECT_EQ(model.surfaces.at(0).centre.z, 3);
}

TEST(FormatPoses, ATableBesideTheRunGetsAWarning) {
  std::vector<std::string> warnings;
  parsed(inline_table("5 0 0 0 0 0 0 6 1 0 0 0 0 0"), &warnings);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("stands still"), std::string::npos);
}

struct BadMotion {
  std::string xml;
  int line;
  const char* word;
};

TEST(FormatPoses, WrongMotionsAreRefused) {
  const BadMotion bad[] = {
      {moved("<Motion Type=\"Poses\"/>"), 23, "<Table> is missing"},
      {moved("<Motion Type=\"Pose\"/>"), 23, "did you mean Poses?"},
      {moved("<Motion Type=\"Poses\">1 2 3<Table>0 0 0 0 0 0 0</Table></Motion>"), 23, "belong into <Table>"},
      {inline_table("0 0 0 0 0 0 0\n1 0 0 0 0 0 0", " LoadShape=\"RAMP\""), 23, "LoadShape"},
      {inline_table("0 0 0 0 0 0 0\n1 0 0 0 0 0 0", " EndTime=\"1\""), 23, "EndTime"},
      {inline_table("0 0 0 0\n1 0 0 0", " Rotation=\"Euler\""), 23, "Quaternion"},
      {moved("<Motion Type=\"Poses\"><Table>0</Table><TableFile>a.csv</TableFile></Motion>"), 23,
       "second table"},
      {moved("<Motion Type=\"Translation\" Rotation=\"None\">0 0 1</Motion>"), 23, "Type=\"Poses\""},
      {moved("<Motion Type=\"Translation\">0 0 1<Centre>0 0 0</Centre></Motion>"), 23, "Type=\"Poses\""},
      {inline_table("0 0 0 0 0 0 0\n1 0 0 0 0 0"), 24, "its last row holds 6 numbers"},
      {inline_table("0 0 0 0 0 0 0"), 23, "it holds 1 row,"},
      {inline_table(""), 23, "it holds 0 rows,"},
      {inline_table("0 0 0 0 0 0 0\n\n0 1 0 0 0 0 0"), 25, "the times must increase"},
      {inline_table("1 0 0 0 0 0 0\n0.5 1 0 0 0 0 0"), 24, "0.5 does not come after 1"},
      {inline_table("0 0 0 0 0 0 0\n1 0 nan 0 0 0 0"), 24, "'nan' is not a finite number"},
      {inline_table("0 0 0 0 0 0 0\n1 0 1e999 0 0 0 0"), 24, "not a finite number"},
      {inline_table("0 0 0 0 0 0 0\n1 0 0 0 0 0 3.1415926"), 24, "half a turn or more"},
      {inline_table("0 0 0 0 0 0 0\n1 0 0 0 0 0 6.2831853"), 24, "half a turn or more"},
      {inline_table("0 0 0 0 1 0 0 0\n1 0 0 0 0 0 0 1", " Rotation=\"Quaternion\""), 24, "half a turn"},
      {inline_table("0 0 0 0 1 0 0 0\n1 0 0 0 0.6 0.6 0 0", " Rotation=\"Quaternion\""), 24,
       "the length 0.848"},
      {inline_table("0 0 0 0 0 0 0 0\n1 0 0 0 1 0 0 0", " Rotation=\"Quaternion\""), 23, "the length 0,"},
  };
  for (const auto& [xml, line, word] : bad) try {
      parsed(xml);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().file, "test.xml");
      EXPECT_EQ(error.place().line, line) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << error.what() << "\n lacks " << word;
    }
}

class PoseFiles : public testing::Test {
 protected:
  fs::path directory = fs::path(GLISSON_BINARY_DIR) / "pose_files" /
                       testing::UnitTest::GetInstance()->current_test_info()->name();

  std::vector<RigidPose> read(const std::string& table, const std::string& rotation = "Vector") const {
    fs::create_directories(directory);
    std::ofstream(directory / "probe.csv", std::ios::binary) << table;
    std::ofstream(directory / "model.xml", std::ios::binary) << moved(
        "<Motion Type=\"Poses\" Rotation=\"" + rotation + "\"><TableFile>probe.csv</TableFile></Motion>");
    return read_model((directory / "model.xml").string(), {}).surfaces.at(0).poses;
  }
};

TEST_F(PoseFiles, WithCommasSemicolonsOrBlanksWithNamesAndRemarks) {
  for (const char* table :
       {"t,x,y,z,rx,ry,rz\n0,0,0,0,0,0,0\n1,1,2,3,0,0.5,0\n", "0;0;0;0;0;0;0\r\n1; 1; 2; 3; 0; 0.5; 0\r\n",
        "# tracked at 20 Hz\n\n0 0 0 0 0 0 0 # start\n1\t1 2 3  0 0.5 0",
        "\xEF\xBB\xBF\"time\", \"x\", \"y\", \"z\", \"a\", \"b\", \"c\"\n0,0,0,0,0,0,0\n1,1,2,3,0,.5,0"}) {
    const auto poses = read(table);
    ASSERT_EQ(poses.size(), 2U) << table;
    EXPECT_EQ(poses[1].shift.z, 3) << table;
    EXPECT_NEAR(poses[1].turn[2], std::sin(0.25), 1e-15) << table;
  }
  EXPECT_EQ(read("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,1,2,3,1,0,0,0\n", "Quaternion").size(), 2U);
  EXPECT_EQ(read("0,0,0,0\n1,1,2,3\n2,1,2,3\n", "None").size(), 3U);
}

TEST_F(PoseFiles, EachMistakeIsToldWithFileAndLine) {
  const std::string good = "0,0,0,0,0,0,0\n";
  const struct {
    std::string table;
    const char* rotation;
    int line;
    const char* word;
  } bad[] = {{good + "1,0,0,0,0,0\n", "Vector", 2,
              "it has 6 columns, but a row of this table has 7: time x y z and"},
             {good + "1,0,0,0,0,0,0,0\n", "Vector", 2, "it has 8 columns"},
             {good + "1,0,,0,0,0,0\n", "Vector", 2, "column 3 holds ''"},
             {good + "1,0,0,0,0,0,\n", "Vector", 2, "column 7 holds ''"},
             {good + "1,0,nan,0,0,0,0\n", "Vector", 2, "column 3 holds 'nan'"},
             {"nan,0,0,0,0,0,0\n" + good, "Vector", 1, "column 1 holds 'nan'"},
             {"inf,0,0,0,0,0,0\n" + good, "Vector", 1, "column 1 holds 'inf'"},
             {good + "1,0,0,1e400,0,0,0\n", "Vector", 2, "column 4"},
             {good + "1,0,0,abc,0,0,0\n", "Vector", 2, "column 4 holds 'abc'"},
             {good + "t,x,y,z,a,b,c\n", "Vector", 2, "column 1 holds 't'"},
             {"0;0;0;0;0;0;0\n1;0,5;0;0;0;0;0\n", "Vector", 2, "column 2 holds '0,5'"},
             {good + "\n# remark\n0,1,0,0,0,0,0\n", "Vector", 4, "the times must increase"},
             {good + "2,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", "Vector", 3, "1 does not come after 2"},
             {good, "Vector", 0, "it holds 1 row,"},
             {"", "Vector", 0, "it holds 0 rows,"},
             {"t,x,y,z,rx,ry,rz\n", "Vector", 0, "it holds 0 rows,"},
             {"t,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n", "Quaternion", 1, "the real part comes first"},
             {"0,0,0,0,0,0,0,0\n1,0,0,0,1,0,0,0\n", "Quaternion", 1, "the length 0,"},
             {good + "1,0,0,0,0,4,0\n", "Vector", 2, "half a turn or more"}};
  for (const auto& [table, rotation, line, word] : bad) try {
      read(table, rotation);
      ADD_FAILURE() << "accepted: " << table;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.place().file, (directory / "probe.csv").string());
      EXPECT_EQ(error.place().line, line) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << error.what() << "\n lacks " << word;
    }
}

TEST_F(PoseFiles, AMissingFileIsNamedWithBothPlaces) {
  fs::create_directories(directory);
  std::ofstream(directory / "model.xml")
      << moved("<Motion Type=\"Poses\"><TableFile>nowhere.csv</TableFile></Motion>");
  try {
    read_model((directory / "model.xml").string(), {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((directory / "nowhere.csv").string()), std::string::npos);
    EXPECT_EQ(error.place().line, 23);
  }
}

}  // namespace
}  // namespace glisson::test
