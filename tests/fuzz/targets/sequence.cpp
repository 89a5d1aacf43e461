// Folders of sequences in each layout that is read, told apart as the program does.
#include "tests/fuzz/fuzz_input.h"
#include "vo/dataset/sequence_source.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_folder(data, size, [](const std::filesystem::path& folder) {
    const vo::SequenceSource source = vo::open_sequence(folder, vo::detect_format(folder));
    fuzz::check(!source.timestamps.empty(), "a sequence that opens has frames");
    for (std::size_t i = 1; i < source.timestamps.size(); ++i) {
      fuzz::check(source.timestamps[i] > source.timestamps[i - 1], "stamps increase");
    }
    source.read(0);
  });
}
