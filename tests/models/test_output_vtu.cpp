// VTU files: what is written comes back bit for bit through an independent decoder, and nothing unusable is
// written.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/vtu_writer.hpp>
#include <limits>
#include <sstream>

#include "tests/models/output_samples.hpp"

namespace glisson {
namespace {

std::vector<unsigned char> from_base64(const std::string& text) {
  std::vector<unsigned char> bytes;
  unsigned group = 0;
  int held = 0;
  for (const char c : text) {
    const int v = c >= 'A' && c <= 'Z'   ? c - 'A'
                  : c >= 'a' && c <= 'z' ? c - 'a' + 26
                  : c >= '0' && c <= '9' ? c - '0' + 52
                  : c == '+'             ? 62
                  : c == '/'             ? 63
                                         : -1;
    if (v < 0) break;
    group = group << 6 | static_cast<unsigned>(v);
    if (++held == 4) {
      for (int k = 16; k >= 0; k -= 8) bytes.push_back(static_cast<unsigned char>(group >> k));
      group = 0;
      held = 0;
    }
  }
  if (held >= 2) bytes.push_back(static_cast<unsigned char>(group >> (6 * held - 8)));
  if (held == 3) bytes.push_back(static_cast<unsigned char>(group >> 2));
  return bytes;
}

std::string text_of(const std::string& file, const std::string& name) {
  const std::size_t at = file.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = file.find('>', at) + 2;
  return file.substr(begin, file.find('\n', begin) - begin);
}

std::uint64_t word(const std::vector<unsigned char>& bytes, std::size_t i) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + 8 * i, 8);
  return value;
}

/// The decoder of the test: header, blocks, zlib.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name) {
  const std::string text = text_of(file, name);
  const std::uint64_t blocks = word(from_base64(text.substr(0, 12)), 0);
  const std::size_t head = ((3 + blocks) * 8 + 2) / 3 * 4;
  const auto header = from_base64(text.substr(0, head));
  const auto body = from_base64(text.substr(head));
  std::vector<unsigned char> all;
  std::size_t at = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t last = word(header, 2);
    uLongf size = b + 1 == blocks && last != 0 ? last : word(header, 1);
    std::vector<unsigned char> block(size);
    EXPECT_EQ(uncompress(block.data(), &size, body.data() + at, word(header, 3 + b)), Z_OK);
    all.insert(all.end(), block.begin(), block.end());
    at += word(header, 3 + b);
  }
  EXPECT_EQ(at, body.size());
  std::vector<T> values(all.size() / sizeof(T));
  std::memcpy(values.data(), all.data(), all.size());
  return values;
}

std::string written(const Mesh& mesh, const Fields& fields, const VtuOptions& options) {
  std::ostringstream out;
  write_vtu(out, mesh, fields, options);
  return out.str();
}

TEST(OutputVtu, EveryArrayComesBackBitForBit) {
  const Mesh mesh = mixed_mesh();
  const Snapshot state = sample_state(mesh, 0.25);
  const std::string file = written(mesh, state.fields(), {.precision = OutputPrecision::full, .time = 0.25});
  const auto X = array_of<double>(file, "Points");
  ASSERT_EQ(X.size(), 3 * mesh.X.size());
  EXPECT_EQ(0, std::memcmp(X.data(), mesh.X.data(), 8 * X.size()));
  EXPECT_EQ(array_of<int>(file, "connectivity"), mesh.nodes);
  EXPECT_EQ(array_of<int>(file, "offsets"), std::vector<int>(mesh.begin.begin() + 1, mesh.begin.end()));
  EXPECT_EQ(array_of<std::uint8_t>(file, "types"), (std::vector<std::uint8_t>{10, 12}));
  EXPECT_EQ(array_of<int>(file, "label"), mesh.label);
  const auto u = array_of<double>(file, "displacement");
  EXPECT_EQ(0, std::memcmp(u.data(), state.displacement.data(), 8 * u.size()));
  const auto S = array_of<double>(file, "stress");
  ASSERT_EQ(S.size(), 12u);
  EXPECT_EQ(0, std::memcmp(S.data(), state.elements.stress.data(), 8 * S.size()));
  EXPECT_EQ(array_of<double>(file, "J"), state.elements.J);
  EXPECT_EQ(array_of<double>(file, "stiffness"), mesh.cell_arrays.at("stiffness").values);
  EXPECT_EQ(text_of(file, "TimeValue"), "0.25");
}

TEST(OutputVtu, SingleRunsAreWrittenInSinglePrecisionWithPointsInDouble) {
  const Mesh mesh = mixed_mesh();
  const Snapshot state = sample_state(mesh, 1);
  const std::string file = written(mesh, state.fields(), {});
  const auto v = array_of<float>(file, "velocity");
  ASSERT_EQ(v.size(), 3 * mesh.X.size());
  EXPECT_EQ(v[3], static_cast<float>(state.velocity[1].x));
  EXPECT_EQ(array_of<double>(file, "Points").size(), 3 * mesh.X.size());
}

TEST(OutputVtu, ArraysOfManyBlocksComeBack) {
  Mesh mesh = mixed_mesh();
  mesh.point_arrays.clear();
  std::vector<double> values;
  for (std::size_t n : {(1u << 15) - 1, 1u << 15, (1u << 15) + 1, 200'000u}) {
    mesh.X.resize(std::max<std::size_t>(n, 9));
    values.assign(mesh.X.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / static_cast<double>(i + 1);
    const Fields fields{{field("inverse", std::span<const double>(values))}, {}};
    const std::string file = written(mesh, fields, {.precision = OutputPrecision::full});
    EXPECT_EQ(array_of<double>(file, "inverse"), values) << n;
  }
}

TEST(OutputVtu, AnEmptyMeshAndAMeshWithoutLabelsAreValid) {
  EXPECT_NE(written({}, {}, {}).find("NumberOfCells=\"0\""), std::string::npos);
  Mesh mesh = mixed_mesh();
  mesh.label.clear();
  EXPECT_EQ(text_of(written(mesh, {}, {}), "label"), "");
}

/// Arrays that come in pieces, to streams that can go back and to one that cannot.
TEST(OutputVtu, PiecesMakeTheSameFile) {
  Mesh mesh;
  mesh.X = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int count = 60000;
  for (int e = 0; e < count; ++e) mesh.add_element(Shape::tetrahedron, std::array{0, 1, 2, 3});
  Snapshot held, source;
  const auto range = [](int first, int n) {
    ElementFields f;
    for (int e = first; e < first + n; ++e) {
      f.stress.push_back({double(e), 1.0 / (1 + e), -e * 7.0, 0, 5, 6e-3 * e});
      f.strain.push_back({0.1 * e, 0, 0, 0, 0, 1});
      f.J.push_back(1 + 1e-6 * e);
    }
    return f;
  };
  held.elements = range(0, count);
  source.element_source = {count, range};
  const std::string whole = written(mesh, held.fields(), {});
  EXPECT_TRUE(whole == written(mesh, source.fields(), {}));
  struct OneWay : std::stringbuf {  // a pipe
    pos_type seekoff(off_type, std::ios_base::seekdir, std::ios_base::openmode) override {
      return off_type(-1);
    }
  } buffer;
  std::ostream out(&buffer);
  write_vtu(out, mesh, source.fields());
  EXPECT_TRUE(whole == buffer.str());
  const OwnFolder folder;
  write_vtu(folder.path / "a.vtu", mesh, source.fields());
  EXPECT_TRUE(whole == content(folder.path / "a.vtu"));
}

TEST(OutputVtu, RefusesNumbersThatAreNotFiniteAndSaysWhere) {
  const Mesh mesh = mixed_mesh();
  struct Case {
    double value;
    const char* says;
  };
  for (const Case& c :
       {Case{std::nan(""), "not a number"}, Case{HUGE_VAL, "infinite"}, Case{-1e39, "too large"}}) {
    Snapshot state = sample_state(mesh, 1);
    state.elements.stress[1].yz = c.value;
    const std::string message = message_of([&] { written(mesh, state.fields(), {}); }, ErrorKind::run);
    EXPECT_NE(message.find("array 'stress' is " + std::string(c.says) + " at element 1 (component 4)"),
              std::string::npos)
        << message;
  }
  Mesh broken = mesh;
  broken.X[7].y = std::nan("");
  const std::string message = message_of([&] { written(broken, {}, {}); }, ErrorKind::run);
  EXPECT_NE(message.find("'position' is not a number at node 7"), std::string::npos) << message;
}

TEST(OutputVtu, RefusesSizesThatDoNotFitAndNamesThatComeTwice) {
  const Mesh mesh = mixed_mesh();
  const std::vector<double> three(3), two(2);
  const auto refused = [&](const Fields& fields) {
    return message_of([&] { written(mesh, fields, {}); }, ErrorKind::usage);
  };
  EXPECT_NE(refused({{field("a", std::span<const double>(three))}, {}}).find("'a' has 3 values"),
            std::string::npos);
  EXPECT_NE(refused({{{"b", 0, three}}, {}}).find("'b'"), std::string::npos);
  const Field c = field("c", std::span<const double>(two));
  EXPECT_NE(refused({{}, {c, c}}).find("twice"), std::string::npos);
  EXPECT_NE(refused({{}, {{"label", 1, two}}}).find("twice"), std::string::npos);
}

TEST(OutputVtu, NamesFromFilesCannotBreakTheXml) {
  Mesh mesh = mixed_mesh();
  mesh.cell_arrays["a<b & \"c\"\n\xff"] = {1, {1, 2}};
  mesh.cell_arrays["\xc3\xa4"] = {1, {1, 2}};
  const std::string file = written(mesh, {}, {});
  EXPECT_NE(file.find("Name=\"a&lt;b &amp; &quot;c&quot;__\""), std::string::npos);
  EXPECT_NE(file.find("Name=\"\xc3\xa4\""), std::string::npos);
}

}  // namespace
}  // namespace glisson
