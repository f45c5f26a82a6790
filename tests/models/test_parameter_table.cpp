// Tables over a simulation file: which value a path names, and what is refused.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/parameter_table.hpp>

namespace glisson {
namespace {

const char* const xml = R"(<Model>
<Nodes NumNodes="4" DOF="3"> 0 0 0  1 0 0  0 1 0  0 0 1 </Nodes>
<Elements NumEls="1" Type="T4"> 0 1 2 3 </Elements>
<ElementSet Size="all" Name="liver">
<Material Type="NH"><ElasticParams NumParams="2"> 1000 <!-- mu --> 5000 </ElasticParams></Material>
</ElementSet>
<Constraint Type="Fix" DOF="all" NumNodes="3"><Nodes> 0 1 2 </Nodes></Constraint>
<Constraint Type="Force" DOF="0" LoadShape="RAMP" NumNodes="1" EndTime="0.5" Name="pull"><Nodes> 3 </Nodes>
<Magnitudes Type="UNIFORM"> 2 </Magnitudes></Constraint>
<Constraint Type="Gravity" LoadShape="STEP" NumNodes="1"><Nodes> 3 </Nodes>
<AccelerationMagnitude> 9.81 </AccelerationMagnitude><AccelerationDirection> 0 0 -1 </AccelerationDirection>
</Constraint>
<SystemParams><TotalTime> 1 </TotalTime><Density> 1000 </Density></SystemParams>
</Model>
)";

class ParameterTables : public testing::Test {
 public:
  ParameterTables() {
    folder_ = std::filesystem::path(GLISSON_BINARY_DIR) / "parameter_tables" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "model.xml") << xml;
  }
  std::vector<Model> members(const std::string& csv) const {
    return read_members((folder_ / "model.xml").string(), parse_parameter_table(csv, "table.csv"));
  }
  std::string message(const std::string& csv) const {
    try {
      members(csv);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "no error";
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(ParameterTables, NameValuesOfTheFile) {
  const auto m = members(
      "ElementSet/Material/ElasticParams#1, liver/ElasticParams#2,Constraint[2]/Magnitudes,pull@EndTime,"
      "Constraint[3]/AccelerationDirection#2,TotalTime\r\n"
      "1500,6000,-3,0.25,1,2\n"
      "\n"
      "1e3,5000,2,0.5,0,\"1\"\r\n");
  ASSERT_EQ(m.size(), 2u);
  EXPECT_EQ(m[0].sections[0].material.parameters, (std::vector<double>{1500, 6000}));
  EXPECT_EQ(m[1].sections[0].material.parameters, (std::vector<double>{1000, 5000}));
  EXPECT_EQ(m[0].forces[0].values[0], -3);
  EXPECT_EQ(m[0].forces[0].curve.end, 0.25);
  EXPECT_EQ(m[1].forces[0].curve.end, 0.5);
  EXPECT_NEAR(m[0].gravity[0].acceleration.y, 9.81 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(m[1].gravity[0].acceleration.y, 0);
  EXPECT_EQ(m[0].time.total, 2);
  EXPECT_EQ(m[1].time.total, 1);
}

TEST_F(ParameterTables, RefuseWithPlaceAndReason) {
  const struct {
    const char *csv, *text;
  } cases[] = {
      {"", "the table has no rows"},
      {"TotalTime\n", "the table has no rows"},
      {"TotalTime,\n1,2\n", "table.csv:1: column 2 has no name"},
      {"TotalTime,TotalTime\n1,2\n", "is there twice"},
      {"TotalTime\n1,2\n", "table.csv:2: the row has 2 values, the header 1 columns"},
      {"TotalTime\n1\n\n  , \n", "table.csv:4: the row has 2 values"},
      {"TotalTime,liver/ElasticParams#1\n1,\n", "the value of column 'liver/ElasticParams#1' is empty"},
      {"TotalTme\n1\n", "names nothing: <Model> has no 'TotalTme'"},
      {"SystemParams/TotalTme\n1\n", "did you mean TotalTime?"},
      {"Constraint/Magnitudes\n1\n", "is one of 3: choose with Constraint[1] to Constraint[3]"},
      {"Constraint[4]/Magnitudes\n1\n", "there are only 3 Constraint"},
      {"Constraint[0]/Magnitudes\n1\n", "needs a number from 1 between [ and ]"},
      {"liver/ElasticParams\n1\n", "holds 2 values: choose with #1 to #2"},
      {"liver/ElasticParams#3\n1\n", "has the values #1 to #2"},
      {"pull@StartTime\n1\n", "has no attribute StartTime"},
      {"Constraint[1]\n1\n", "holds no text"},
      {"liver/ElasticParams#1,ElementSet/ElasticParams#1\n1,2\n", "are the same value"},
      {"TotalTime\nnan\n", "table.csv:2: column 'TotalTime': 'nan' is not a finite number"},
      {"TotalTime\n1;2\n", "'1;2' is not a finite number"},
      {"TotalTime\n1\n-1\n", "table.csv:3: member 1: "},
      {"liver/ElasticParams#1\n-5\n", "table.csv:2: member 0: "},
      {"pull@LoadShape\nRAMPP\n", "did you mean RAMP"},
  };
  for (const auto& c : cases) {
    const auto text = message(c.csv);
    EXPECT_NE(text.find(c.text), std::string::npos) << c.csv << "gives: " << text;
  }
}

TEST_F(ParameterTables, FileThatIsNotThere) {
  EXPECT_THROW(read_parameter_table("/no/such/table.csv"), Error);
}

}  // namespace
}  // namespace glisson
