// Models of structured forests, packed or not.
#include "tests/fuzz/fuzz_input.h"
#include "vo/structured_forest/structured_forest_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "forest", [](const std::filesystem::path& path) {
    const std::string text = vo::structured_forest_yaml(vo::read_structured_forest(path));
    const auto again = fuzz::read_again(text, "again", vo::read_structured_forest);
    fuzz::check(vo::structured_forest_yaml(again) == text,
                "a forest that is read and written reads alike");
  });
}
