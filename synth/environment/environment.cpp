#include "synth/environment/environment.h"

#include <cstdio>
#include <numbers>

#include "synth/environment/exr.h"
#include "synth/scene/sky.h"
#include "vo/core/error.h"
#include "vo/image_files/rgbe.h"

namespace synth {
namespace {

constexpr const char* kSky = "sky:";

SkyOptions parse_sky(const std::string& text) {
  SkyOptions sky;
  double elevation_deg = 0;
  int end = 0;
  int values =
      std::sscanf(text.c_str(), "sky:%lf%n,%lf%n", &elevation_deg, &end, &sky.turbidity, &end);
  vo::require(values >= 1 && end == static_cast<int>(text.size()), "environment: is \"", text,
              "\", expected sky:ELEVATION or sky:ELEVATION,TURBIDITY, deg");
  sky.sun_elevation = elevation_deg * std::numbers::pi / 180;
  return sky;
}

Environment read_image(const std::string& path) {
  Environment environment;
  environment.radiance = path.ends_with(".exr") ? read_exr(path) : vo::read_rgbe(path);
  const cv::Size size = environment.radiance.size();
  vo::require(size.width == 2 * size.height, path, ": is ", size.width, " x ", size.height,
              " px, expected an equirectangular image, twice as wide as high");
  return environment;
}

}  // namespace

bool is_environment_file(const std::string& name) {
  return !name.empty() && !name.starts_with(kSky);
}

Environment read_environment(const std::string& name) {
  if (name.empty()) {
    return {};
  }
  return is_environment_file(name) ? read_image(name) : clear_sky(parse_sky(name));
}

}  // namespace synth
