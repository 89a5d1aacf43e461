// TOML of any keys.
#include "tests/fuzz/fuzz_input.h"
#include "vo/text_files/toml_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "a.toml", [](const std::filesystem::path& path) {
    for (const vo::TomlValue& value : vo::read_toml(path)) {
      const std::string text = "a = " + vo::quoted_toml(value.text) + "\n";
      const auto again = fuzz::read_again(text, "again", vo::read_toml);
      fuzz::check(again.size() == 1 && again[0].text == value.text, "a quoted text reads alike");
    }
  });
}
