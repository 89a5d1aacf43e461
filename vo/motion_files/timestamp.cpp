#include "vo/motion_files/timestamp.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/nanoseconds.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

/// Returns the shortest text without an exponent that reads back as the same number.
std::string exact_timestamp(double timestamp) {
  std::array<char, 512> text{};  // the smallest number has 327 decimals behind the point
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), timestamp, std::chars_format::fixed);
  return {text.data(), end};
}

}  // namespace

double checked_timestamp(const TextLine& line, double timestamp) {
  if (std::abs(timestamp) > kMaxTimestamp) {
    fail(line.place(), ": expected a stamp within ", kMaxTimestamp, " s of 0, got ", timestamp,
         " s");
  }
  return timestamp;
}

double parse_timestamp(const TextLine& line, std::size_t field) {
  return checked_timestamp(line, parse_number(line, field));
}

double parse_nanoseconds(const TextLine& line, std::size_t field) {
  const std::string_view text = line.fields[field];
  std::int64_t nanoseconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), nanoseconds);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole ? checked_timestamp(line, seconds_of(nanoseconds))
                  : checked_timestamp(line, kNanosecond * parse_number(line, field));
}

std::int64_t to_nanoseconds(double seconds) {
  const double whole = std::floor(seconds);
  return static_cast<std::int64_t>(whole) * kNanosecondsPerSecond +
         std::llround((seconds - whole) * kNanosecondsPerSecond);
}

double seconds_of(std::int64_t nanoseconds) {
  const std::int64_t whole = nanoseconds / kNanosecondsPerSecond;
  return static_cast<double>(whole) +
         static_cast<double>(nanoseconds - whole * kNanosecondsPerSecond) / kNanosecondsPerSecond;
}

std::string format_timestamp(double timestamp) {
  constexpr double kHalfMicrosecond = 0.5e-6;
  std::array<char, 400> text{};  // the greatest double has 309 digits
  // A stamp that rounds to 0 from below would be written -0.000000, another text for the same one.
  const double written = std::abs(timestamp) <= kHalfMicrosecond ? 0.0 : timestamp;
  std::snprintf(text.data(), text.size(), "%.6f", written);
  return text.data();
}

std::vector<std::string> format_timestamps(const std::vector<double>& timestamps) {
  std::vector<std::string> texts(timestamps.size());
  std::transform(timestamps.begin(), timestamps.end(), texts.begin(), format_timestamp);
  if (std::adjacent_find(texts.begin(), texts.end()) != texts.end()) {
    std::transform(timestamps.begin(), timestamps.end(), texts.begin(), exact_timestamp);
  }
  return texts;
}

void require_nanoseconds_apart(const std::vector<double>& timestamps, const std::string& place) {
  for (std::size_t i = 1; i < timestamps.size(); ++i) {
    require(to_nanoseconds(timestamps[i]) > to_nanoseconds(timestamps[i - 1]), place, ": frames ",
            i - 1, " and ", i, " lie within a nanosecond (", format_real(timestamps[i - 1]),
            " s and ", format_real(timestamps[i]),
            " s), expected stamps that whole nanoseconds tell apart");
  }
}

}  // namespace vo
