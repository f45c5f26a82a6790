// What a constitutive law may not be: compile-time refusals, and the agreement of the two lists of laws.
#include <gtest/gtest.h>

#include <fstream>
#include <glisson/core/materials/laws.hpp>
#include <glisson/core/numbers/dual.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace glisson {
namespace {

template <class R>
constexpr bool all_are_laws() {
  bool all = true;
  for_each_type(AllLaws<R>{}, [&]<class L>() { all = all && Law<L, R>; });
  return all;
}
static_assert(all_are_laws<float>());
static_assert(all_are_laws<double>());
static_assert(all_are_laws<Dual<double>>());
static_assert(!Law<NeoHookean<double>, float>);  // no hidden conversion between precisions
static_assert(!Law<float, float>);

struct VirtualLaw : NeoHookean<float> {
  static VirtualLaw load(const float*);
  virtual ~VirtualLaw() = default;
};
static_assert(!Law<VirtualLaw, float>);  // cannot travel into a kernel

struct HeapLaw : NeoHookean<float> {
  static HeapLaw load(const float*);
  std::vector<float> table;
};
static_assert(!Law<HeapLaw, float>);  // points to memory that a device does not see

struct PlainLaw : NeoHookean<float> {
  static PlainLaw load(const float*);
};
static_assert(Law<PlainLaw, float>);  // what the refused ones below change is all that is wrong with them

struct LoadsAnother : NeoHookean<float> {};  // load gives a NeoHookean
static_assert(!Law<LoadsAnother, float>);

struct NoEnergy : PlainLaw {
  static NoEnergy load(const float*);
  float energy(const Mat3<float>&) const = delete;
};
static_assert(!Law<NoEnergy, float>);

struct EnergyInDouble : PlainLaw {
  static EnergyInDouble load(const float*);
  double energy(const Mat3<float>&) const;
};
static_assert(!Law<EnergyInDouble, float>);

struct NotConst : PlainLaw {
  static NotConst load(const float*);
  Mat3<float> first_pk(const Mat3<float>&);  // memory of a law belongs to the history of the element
};
static_assert(!Law<NotConst, float>);

struct StressNotSplit : PlainLaw {
  static StressNotSplit load(const float*);
  Sym3<float> second_pk(const Mat3<float>&) const;
};
static_assert(!Law<StressNotSplit, float>);

TEST(LawList, MembersAreTheParameters) {
  for_each_type(AllLaws<double>{}, []<class L>() {
    EXPECT_LE(sizeof(L), sizeof(double) * L::parameter_count) << L::name;
    EXPECT_EQ(std::string(L::name).size(), 2u);
  });
}

TEST(LawList, BuildSystemKnowsTheSameLaws) {
  auto text_of = [](const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(std::string(GLISSON_SOURCE_DIR) + path).rdbuf();
    return text.str();
  };
  const std::string header = text_of("/core/materials/laws.hpp");
  std::istringstream list(text_of("/cmake/GlissonLaws.cmake"));
  int count = 0;
  for (std::string line; std::getline(list, line);) {
    const auto quote = line.find('"'), colon = line.find(':'), end = line.rfind('"');
    if (quote == std::string::npos || colon == std::string::npos) continue;
    ++count;
    EXPECT_NE(header.find(line.substr(quote + 1, colon - quote - 1) + "<R>"), std::string::npos) << line;
    EXPECT_NE(header.find("/" + line.substr(colon + 1, end - colon - 1) + ".hpp>"), std::string::npos)
        << line;
  }
  EXPECT_EQ(count, AllLaws<float>::size);
}

}  // namespace
}  // namespace glisson
