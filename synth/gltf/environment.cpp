#include "synth/gltf/environment.h"

#include <cstdio>
#include <numbers>

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
  environment.radiance = vo::read_rgbe(path);
  const cv::Size size = environment.radiance.size();
  vo::require(size.width == 2 * size.height, path, ": is ", size.width, " x ", size.height,
              " px, expected an equirectangular image, twice as wide as high");
  return environment;
}

}  // namespace

bool is_environment_file(const std::string& environment) {
  return !environment.empty() && !environment.starts_with(kSky);
}

Environment read_environment(const GltfOptions& options) {
  if (options.environment.empty()) {
    return {};
  }
  Environment environment = is_environment_file(options.environment)
                                ? read_image(options.environment)
                                : clear_sky(parse_sky(options.environment));
  environment.turn = options.environment_turn * std::numbers::pi / 180;
  environment.radiance *= options.environment_strength;
  return environment;
}

}  // namespace synth
