// Scenarios.
#include "tools/scenario/scenario.h"

#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "scenario.toml",
                         [](const std::filesystem::path& path) { tools::load_scenario(path); });
}
