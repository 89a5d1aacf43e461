#include "vo/dataset/open3d.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_files.h"
#include "vo/dataset/frame_images.h"
#include "vo/files/input.h"
#include "vo/geometry/associate.h"
#include "vo/motion_files/redwood_log.h"
#include "vo/motion_files/timestamp.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthFolder = "depth";
constexpr double kOpen3dRate = 30;       // Hz, of images without stamps
constexpr double kMaxDifference = 0.02;  // s, between the stamps of an image and its depth
constexpr double kUnitsPerMetre = 1000;

/// The quantity that the names of a folder's images give: the frame's number or its stamp.
enum class NameKind { number, stamp };

/// An image of a folder by what its name says.
struct NamedImage {
  double value = 0;  ///< number of the frame, or stamp, s
  NameKind kind = NameKind::number;
  fs::path path;
};

bool is_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns what a name says; throws Error naming the file if that is nothing.
NamedImage named_image(const fs::path& path) {
  constexpr std::size_t kMicrosecondDigits = 12;
  const std::string stem = path.stem().string();
  const std::string_view number = number_at_end(stem);
  require(!number.empty(), path.string(), ": expected a name that ends with a number");
  const std::string_view before = std::string_view(stem).substr(0, stem.size() - number.size());
  const bool is_redwood = number.size() >= kMicrosecondDigits && before.ends_with('-') &&
                          is_digits(before.substr(0, before.size() - 1));
  NamedImage image{parse_real(number) * (is_redwood ? 1e-6 : 1),
                   is_redwood || !is_digits(number) ? NameKind::stamp : NameKind::number, path};
  const double limit = image.kind == NameKind::stamp ? kMaxTimestamp : kMaxTimestamp * kOpen3dRate;
  require(image.value <= limit, path.string(), ": expected a number of at most ", limit);
  return image;
}

/// Returns the images of a folder in order of what their names say.
std::vector<NamedImage> named_images(const fs::path& root, const fs::path& folder) {
  std::vector<NamedImage> images;
  for (const std::string& name : names_in(root / folder)) {
    if (is_image_ending(fs::path(name).extension().string())) {
      images.push_back(named_image(path_in(root, (folder / name).string(), root.string())));
      require(images.back().kind == images.front().kind, images.back().path.string(),
              ": expected a name with a stamp, or without, as ", images.front().path.string());
    }
  }
  require(!images.empty(), (root / folder).string(), ": holds no images");
  std::sort(images.begin(), images.end(), [](const NamedImage& a, const NamedImage& b) {
    return a.value != b.value ? a.value < b.value : a.path < b.path;
  });
  for (std::size_t i = 1; i < images.size(); ++i) {
    require(images[i].value > images[i - 1].value, images[i].path.string(), ": has the number of ",
            images[i - 1].path.string(), ", expected one of each");
  }
  return images;
}

std::vector<double> values_of(const std::vector<NamedImage>& images) {
  std::vector<double> values;
  for (const NamedImage& image : images) {
    values.push_back(image.value);
  }
  return values;
}

std::vector<FrameFiles> frames_of(const fs::path& folder) {
  const std::vector<NamedImage> images = named_images(folder, open3d_images(folder));
  const std::vector<NamedImage> depths = named_images(folder, kDepthFolder);
  std::vector<FrameFiles> frames;
  if (images.front().kind == NameKind::stamp && depths.front().kind == NameKind::stamp) {
    for (const auto& [i, j] : associate(values_of(images), values_of(depths), kMaxDifference)) {
      frames.push_back({images[i].value, images[i].path, depths[j].path});
    }
    require(!frames.empty(), folder.string(), ": no image and depth lie within ", kMaxDifference,
            " s of each other");
    return frames;
  }
  require(images.size() == depths.size(), folder.string(), ": has ", images.size(), " images and ",
          depths.size(), " of depth, expected equally many");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const double timestamp =
        images[i].kind == NameKind::stamp ? images[i].value : images[i].value / kOpen3dRate;
    frames.push_back({timestamp, images[i].path, depths[i].path});
  }
  return frames;
}

/// Returns the numbers that a JSON file has behind a key, one or an array of them.
std::vector<double> numbers_behind(const fs::path& path, const std::string& text,
                                   const std::string& key, std::size_t count) {
  const std::size_t at = text.find('"' + key + '"');
  const std::size_t colon = text.find(':', at);
  require(colon != std::string::npos && at != std::string::npos, path.string(), ": expected ", key);
  const bool is_array = count > 1;
  const std::size_t begin = is_array ? text.find('[', colon) : colon;
  const std::size_t end = text.find_first_of(is_array ? "]" : ",}", colon);
  require(begin < end && end != std::string::npos, path.string(), ": ", key, ": expected ", count,
          " numbers");
  std::string values = text.substr(begin + 1, end - begin - 1);
  std::replace_if(
      values.begin(), values.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; },
      ' ');
  try {
    return parse_reals(values, count);
  } catch (const Error& error) {
    fail(path.string(), ": ", key, ": ", error.what());
  }
}

int image_length(const fs::path& path, const std::string& text, const char* key) {
  constexpr double kMaxLength = 16384;
  const double length = numbers_behind(path, text, key, 1)[0];
  require(length >= 1 && length <= kMaxLength && length == std::floor(length), path.string(), ": ",
          key, ": expected a whole number from 1 to ", kMaxLength, ", got ", length);
  return static_cast<int>(length);
}

/// Reads Open3D's PinholeCameraIntrinsic, whose matrix is column by column; `depth_scale`, if there
/// is one, is depth's units per metre.
RgbdCamera read_intrinsics_file(const fs::path& path) {
  const std::string text = read_file(path, kMaxConfigurationBytes);
  const std::vector<double> K = numbers_behind(path, text, "intrinsic_matrix", 9);
  RgbdCamera camera{{image_length(path, text, "width"), image_length(path, text, "height"), K[0],
                     K[4], K[6], K[7]},
                    kUnitsPerMetre};
  if (text.find("\"depth_scale\"") != std::string::npos) {
    camera.depth_units_per_m = numbers_behind(path, text, "depth_scale", 1)[0];
  }
  return checked_camera(camera, path);
}

RgbdCamera camera_in(const fs::path& folder, std::vector<std::string>& notes) {
  for (const char* name : {"camera_intrinsic.json", "intrinsic.json"}) {
    if (fs::exists(folder / name)) {
      return read_intrinsics_file(folder / name);
    }
  }
  notes.push_back(
      folder.string() +
      ": has no camera_intrinsic.json, PrimeSense's defaults are used (640x480 px, focal "
      "length 525 px, depth in mm); --camera names another");
  return {{640, 480, 525, 525, 319.5, 239.5}, kUnitsPerMetre};
}

/// Returns the one trajectory of a folder; empty if there is none.
fs::path find_log(const fs::path& folder) {
  fs::path log;
  for (const std::string& name : names_in(folder)) {
    if (name.ends_with(".log")) {
      require(log.empty(), folder.string(), ": expected one trajectory, got ",
              log.filename().string(), " and ", name);
      log = path_in(folder, name, folder.string());
    }
  }
  return log;
}

}  // namespace

fs::path open3d_images(const fs::path& folder) {
  for (const char* name : {"color", "rgb", "image"}) {
    if (fs::is_directory(folder / name) && fs::is_directory(folder / kDepthFolder)) {
      return name;
    }
  }
  return {};
}

SequenceSource open_open3d(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  require(!open3d_images(folder).empty(), folder.string(),
          ": expected folders color (or rgb, image) and depth");
  const std::vector<FrameFiles> frames = frames_of(folder);
  SequenceSource source;
  source.camera = camera || fs::exists(folder / "camera.toml")
                      ? camera_of_folder(folder, camera, {})
                      : camera_in(folder, source.notes);
  source.timestamps = stamps_of(frames);
  source.read = [frames, camera = source.camera](std::size_t index) {
    return read_frame(frames.at(index), camera);
  };
  if (const fs::path log = find_log(folder); !log.empty()) {
    source.truth = read_redwood_log(log, source.timestamps);
  }
  return source;
}

}  // namespace vo
