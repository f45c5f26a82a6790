// The seeds of the fuzzer are valid simulation files, so that it starts from deep inside the reader.
#include <tests/models/format_base.hpp>

#include <filesystem>

namespace glisson::test {
namespace {

TEST(FormatCorpus, SeedsAreValid) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GLISSON_SOURCE_DIR "/tests/fuzz/corpus/xml")) {
    EXPECT_NO_THROW(validate(read_model(entry.path().string(), {.allow_files = false}))) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 2);
}

}  // namespace
}  // namespace glisson::test
