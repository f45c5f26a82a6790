// The grammar: suggestions, the list of names, the XML schema for editors.
#include <tests/models/format_base.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <glisson/models/format/schema.hpp>
#include <glisson/models/format/suggest.hpp>

namespace glisson::test {
namespace {

TEST(FormatSuggest, EditDistanceCountsSwapsOnce) {
  EXPECT_EQ(detail::edit_distance("Force", "Force"), 0);
  EXPECT_EQ(detail::edit_distance("Froce", "Force"), 1);
  EXPECT_EQ(detail::edit_distance("force", "FORCE"), 0);
  EXPECT_EQ(detail::edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(detail::edit_distance("", "abc"), 3);
}

TEST(FormatSuggest, OnlyNearNamesAreSuggested) {
  const std::vector<std::string> names{"TimeStep", "TotalTime", "DampingCoeff"};
  EXPECT_EQ(detail::nearest("Timestpe", names), "TimeStep");
  EXPECT_EQ(detail::nearest("Damping", names), "DampingCoeff");
  EXPECT_EQ(detail::nearest("Viscosity", names), "");
  EXPECT_EQ(detail::suggestion("Viscosity", names), "; known here: TimeStep, TotalTime, DampingCoeff");
}

TEST(FormatSchema, EveryKindHasARule) {
  for (const auto& rule : detail::element_rules())
    for (const auto& child : detail::children_of(rule))
      EXPECT_NO_THROW(detail::rule_of(child.kind)) << child.name;
}

TEST(FormatSchema, EveryNameIsKnownUnderAnyCaseOnly) {
  const auto names = known_names();
  EXPECT_GT(names.size(), 80U);
  for (const char* name :
       {"Model", "SubModelNodeMergerDistance", "ToleranceAngle", "HGKappa", "ElementArray"})
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
}

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

const std::string xsd_path = GLISSON_SOURCE_DIR "/models/format/glisson.xsd";

TEST(FormatSchema, TheXsdIsWhatTheTableSays) {
  if (std::getenv("GLISSON_WRITE_XSD") != nullptr) std::ofstream(xsd_path, std::ios::binary) << make_xsd();
  EXPECT_EQ(text_of(xsd_path), make_xsd())
      << "run this test once with GLISSON_WRITE_XSD=1 after a change of the table";
}

int xmllint(const std::string& xml) {
  const std::string path = GLISSON_BINARY_DIR "/xsd_test.xml";
  std::ofstream(path, std::ios::binary) << xml;
  return std::system(("xmllint --noout --schema '" + xsd_path + "' '" + path + "' > /dev/null 2>&1").c_str());
}

TEST(FormatSchema, TheXsdAcceptsGoodFilesAndRefusesBadOnes) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "xmllint is not installed";
  EXPECT_EQ(xmllint(base_xml), 0);
  EXPECT_NE(xmllint(replaced(base_xml, "LoadShape", "LoadShap")), 0);
  EXPECT_NE(xmllint(replaced(base_xml, "POLY345", "POLY35")), 0);
  const std::string examples = GLISSON_SOURCE_DIR "/examples";
  if (!std::filesystem::is_directory(examples)) return;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".xml") {
      EXPECT_EQ(xmllint(text_of(entry.path().string())), 0) << entry.path();
    }
}

}  // namespace
}  // namespace glisson::test
