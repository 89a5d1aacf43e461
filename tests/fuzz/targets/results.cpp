// Results of `edvo test --json`, which `--baseline` and `edvo compare` read.
#include <nlohmann/json.hpp>

#include "tests/fuzz/fuzz_input.h"
#include "tools/laboratory/results_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "results.json", [](const std::filesystem::path& path) {
    const auto text_of = [](const tools::TestResults& results) {
      return tools::results_json(results).dump(-1, ' ', false,
                                               nlohmann::ordered_json::error_handler_t::replace);
    };
    const std::string text = text_of(tools::read_results(path));
    fuzz::check(text_of(fuzz::read_again(text, "again", tools::read_results)) == text,
                "results that are read and written read alike");
  });
}
