#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vo {

struct TextLine;

inline constexpr double kNanosecond = 1e-9;  ///< s

/// The greatest distance of a stamp from 0, s: nanoseconds in 64 bits hold no more.
inline constexpr double kMaxTimestamp = 9e9;

/// Returns the stamp, s, of a line. Throws Error naming the line unless it is within
/// `kMaxTimestamp` of 0.
double checked_timestamp(const TextLine& line, double timestamp);

/// Returns the stamp of a line's field, s. Throws Error naming the line unless it is a number
/// within `kMaxTimestamp` of 0.
double parse_timestamp(const TextLine& line, std::size_t field);

/// Returns a stamp of a line's field, in nanoseconds, as seconds: a whole number by `seconds_of`,
/// which 64 bits hold and a double does not. Throws Error as `parse_timestamp` does.
double parse_nanoseconds(const TextLine& line, std::size_t field);

/// Returns the exact value of seconds rounded to whole nanoseconds, the unit of stamps in EuRoC's
/// files and in recordings.
std::int64_t to_nanoseconds(double seconds);

/// Returns whole nanoseconds as seconds: of those that `to_nanoseconds` returned, the seconds that
/// it was given, to half a nanosecond where they were finer.
double seconds_of(std::int64_t nanoseconds);

/// Returns a stamp, s, with 6 decimals: `0.033333`.
std::string format_timestamp(double timestamp);

/// Returns increasing stamps, s, as every list of a sequence writes them: with 6 decimals, or,
/// where two would be written alike, each with the digits that read back as the same number.
std::vector<std::string> format_timestamps(const std::vector<double>& timestamps);

/// Throws Error naming `place` and the first two of increasing stamps, s, that fall in one
/// nanosecond, the unit of EuRoC's files and of recordings.
void require_nanoseconds_apart(const std::vector<double>& timestamps, const std::string& place);

}  // namespace vo
