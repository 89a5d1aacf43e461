#pragma once

#include <array>
#include <string>
#include <utility>

#include <opencv2/core.hpp>

#include "vo/core/image.h"

namespace synth {

enum class ResponseCurve {
  srgb,   ///< IEC 61966-2-1
  gamma,  ///< linear^(1 / gamma)
  table,  ///< a measured curve, as of Grossberg & Nayar
};

constexpr auto enum_names(ResponseCurve) {
  return std::array{std::pair{ResponseCurve::srgb, "srgb"},
                    std::pair{ResponseCurve::gamma, "gamma"},
                    std::pair{ResponseCurve::table, "table"}};
}

/// The camera's response from linear light in 0..1 to 8-bit codes.
struct ResponseOptions {
  ResponseCurve curve = ResponseCurve::srgb;
  double gamma = 2.2;  ///< exponent of the gamma curve; 1 = linear
  std::string table;   ///< brightness at evenly spaced light from 0 to 1: "0, 0.5, 0.8, 1"

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, ResponseOptions& options) {
  visit("curve", options.curve, "from linear light to codes");
  visit("gamma", options.gamma, "of the curve gamma: linear^(1 / gamma)");
  visit("table", options.table, "of the curve table: brightness at even steps of light, 0 to 1");
}

/// Returns the 8-bit BGR image of linear RGB; values outside 0..1 are clamped.
vo::ColorImage encode(const cv::Mat_<cv::Vec3f>& linear, const ResponseOptions& options);

}  // namespace synth
