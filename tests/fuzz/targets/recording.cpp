// MCAP files and ROS 1 bags: the frames, by the camera that they have and by a given one, and the
// poses.
#include "tests/fuzz/fuzz_input.h"
#include "vo/motion_files/recorded_trajectory.h"
#include "vo/recordings/recorded_sequence.h"

namespace {

template <typename Call>
void attempt(Call call) {
  try {
    call();
  } catch (const vo::Error&) {  // a right answer
  }
}

void read_frames(const std::filesystem::path& path, const std::optional<vo::RgbdCamera>& camera) {
  const vo::SequenceSource source = vo::open_recording(path, camera);
  for (std::size_t i = 1; i < source.timestamps.size(); ++i) {
    fuzz::check(source.timestamps[i] > source.timestamps[i - 1], "stamps increase");
  }
  if (!source.timestamps.empty()) {
    const vo::RgbdFrame frame = source.read(0);
    fuzz::check(frame.image.cols == source.camera.pinhole.width, "images have the camera's size");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "r.mcap", [](const std::filesystem::path& path) {
    const vo::Recording recording(path);
    attempt([&] { read_frames(path, std::nullopt); });
    attempt([&] {
      read_frames(path, vo::RgbdCamera{vo::PinholeCamera::from_horizontal_fov(8, 6, 60), 1000});
    });
    for (const vo::RecordedTopic& topic : recording.topics()) {
      std::vector<std::string> notes;
      attempt([&] { vo::read_recorded_trajectory(recording, topic.name, notes); });
    }
  });
}
