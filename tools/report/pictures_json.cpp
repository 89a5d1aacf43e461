#include "tools/report/pictures_json.h"

#include <cmath>
#include <string>

#include "tools/pictures/base64.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

void add_picture(Json& json, const char* key, const std::string& webp) {
  if (!webp.empty()) {
    json[key] = base64(webp);
  }
}

void add_values(Json& json, const char* key, const ValuePicture& picture) {
  if (!picture.webp.empty()) {
    json[key] = {{"webp", base64(picture.webp)},
                 {"dark", rounded(picture.range[0])},
                 {"bright", rounded(picture.range[1])}};
  }
}

}  // namespace

Json rounded(double value) {
  constexpr double kUnit = 1e-6;
  return std::isfinite(value) ? Json(std::round(value / kUnit) * kUnit + 0.0) : Json(nullptr);
}

Json camera_json(const vo::PinholeCamera& camera) {
  return {{"width", camera.width},    {"height", camera.height},  {"fx", rounded(camera.fx)},
          {"fy", rounded(camera.fy)}, {"cx", rounded(camera.cx)}, {"cy", rounded(camera.cy)}};
}

Json pictures_json(const FramePictures& pictures, std::size_t frame) {
  Json json = {{"frame", frame}, {"size", {pictures.size.width, pictures.size.height}}};
  add_picture(json, "colour", pictures.colour);
  add_picture(json, "edges", pictures.edges);
  add_values(json, "depth", pictures.depth);
  add_picture(json, "residual_before", pictures.residual_before);
  add_picture(json, "residual_after", pictures.residual_after);
  add_values(json, "inverse_depth", pictures.inverse_depth);
  add_values(json, "inverse_depth_truth", pictures.inverse_depth_truth);
  return json;
}

}  // namespace tools
