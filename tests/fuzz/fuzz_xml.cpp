// Any bytes as a simulation file: a Model that validate() can judge, or Error(input); nothing else.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/read_model.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glisson;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> warnings;
  for (const bool lenient : {false, true}) try {
      const Model model =
          parse_model(text, "fuzz.xml", {.lenient = lenient, .allow_files = false, .warnings = &warnings});
      validate(model);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) __builtin_trap();
    }
  return 0;
}
