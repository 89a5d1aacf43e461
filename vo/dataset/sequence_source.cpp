#include "vo/dataset/sequence_source.h"

#include <memory>

#include "vo/core/error.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/sequence.h"
#include "vo/motion_files/imu_file.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

SequenceSource open_tum(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  const auto reader = std::make_shared<const SequenceReader>(folder, camera);
  SequenceSource source;
  source.camera = reader->camera();
  source.timestamps = reader->timestamps();
  source.read = [reader](std::size_t index) { return reader->read(index); };
  source.truth = reader->ground_truth();
  source.notes = reader->notes();
  if (fs::exists(folder / "imu.csv")) {
    source.imu.samples = read_imu(folder / "imu.csv");
  }
  if (fs::exists(folder / "imu.toml")) {
    source.imu.noise = read_imu_noise(folder / "imu.toml");
  }
  if (fs::exists(folder / "truth/imu_states.csv")) {
    source.imu.states = read_states(folder / "truth/imu_states.csv");
  }
  return source;
}

}  // namespace

std::optional<SequenceFormat> known_format(const fs::path& folder) {
  if (fs::exists(folder / "mav0/cam0/data.csv")) {
    return SequenceFormat::euroc;
  }
  if (fs::exists(folder / "scene_00_0000.png")) {
    return SequenceFormat::icl_nuim;
  }
  if (fs::exists(folder / "rgb.txt")) {
    return SequenceFormat::tum;
  }
  if (fs::exists(folder / "associations.txt")) {
    return SequenceFormat::icl_tum;
  }
  return std::nullopt;
}

SequenceFormat detect_format(const fs::path& folder) {
  require(fs::is_directory(folder), folder.string(),
          ": there is no such folder, expected a sequence");
  const std::optional<SequenceFormat> format = known_format(folder);
  require(format.has_value(), folder.string(),
          ": holds no sequence that is known, expected rgb.txt (TUM), mav0/cam0/data.csv (EuRoC), "
          "scene_00_0000.png (ICL-NUIM) or associations.txt (ICL-NUIM, TUM compatible)");
  return *format;
}

SequenceSource open_sequence(const fs::path& folder, SequenceFormat format,
                             const std::optional<RgbdCamera>& camera) {
  switch (format) {
    case SequenceFormat::tum:
      return open_tum(folder, camera);
    case SequenceFormat::euroc:
      return open_euroc(folder, camera);
    case SequenceFormat::icl_nuim:
      return open_icl_nuim(folder, camera);
    case SequenceFormat::icl_tum:
      return open_icl_tum(folder, camera);
  }
  return {};
}

}  // namespace vo
