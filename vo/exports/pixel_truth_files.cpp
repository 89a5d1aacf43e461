#include "vo/exports/pixel_truth_files.h"

#include <algorithm>

#include "vo/dataset/sequence.h"
#include "vo/files/input.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTruthFolder = "truth";
constexpr const char* kStates = "imu_states";
constexpr const char* kLabels = "labels.json";

bool is_of_all_frames(const fs::path& file) {
  return (file.extension() == ".csv" && file.stem() != kStates) || file.filename() == kLabels;
}

bool is_of_all_frames(const TruthChannelFiles& channel) {
  return channel.files.size() == 1 && is_of_all_frames(channel.files.front());
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

std::vector<TruthChannelFiles> truth_channels_in(const fs::path& folder) {
  std::vector<TruthChannelFiles> channels;
  if (!fs::is_directory(folder / kTruthFolder)) {
    return channels;
  }
  for (const fs::path& entry : sorted_entries(folder / kTruthFolder)) {
    if (fs::is_directory(entry)) {
      channels.push_back({entry.filename().string(), sorted_entries(entry)});
    } else if (is_of_all_frames(entry)) {
      channels.push_back({entry.stem().string(), {entry}});
    }
  }
  return channels;
}

bool is_of_frames(const TruthChannelFiles& channel, std::size_t frames) {
  if (is_of_all_frames(channel)) {
    return true;
  }
  if (channel.files.size() != frames && channel.files.size() + 1 != frames) {
    return false;
  }
  for (std::size_t i = 0; i < channel.files.size(); ++i) {
    if (channel.files[i].stem() != frame_number(i)) {
      return false;
    }
  }
  return true;
}

std::vector<NamedBytes> read_truth_of_frame(const TruthChannelFiles& channel, std::size_t index) {
  const std::string folder = std::string(kTruthFolder) + "/";
  if (is_of_all_frames(channel)) {
    if (index > 0) {
      return {};
    }
    const fs::path& file = channel.files.front();
    return {{folder + file.filename().string(), read_file(file)}};
  }
  if (index >= channel.files.size()) {
    return {};
  }
  const fs::path& file = channel.files[index];
  return {{folder + channel.name + "/" + file.filename().string(), read_file(file)}};
}

}  // namespace vo
