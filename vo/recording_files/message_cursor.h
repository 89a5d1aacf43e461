#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "vo/recording_files/byte_cursor.h"

namespace vo {

/// The bytes in front of a message in CDR, from whose end numbers are aligned.
inline constexpr std::size_t kCdrEncapsulation = 4;

/// Reads the fields of a ROS message in their order: of ROS 1, without gaps, or of ROS 2, as CDR,
/// in which numbers lie at multiples of their size. Throws Error where the bytes end before.
class MessageCursor {
 public:
  /// `encoding` is that of RecordedTopic. Throws Error if it is neither `ros1` nor `cdr`, or for
  /// CDR in big endian.
  MessageCursor(std::string_view bytes, std::string_view encoding);

  bool is_ros1() const { return is_ros1_; }

  template <typename Number>
  Number number() {
    align(sizeof(Number));
    return cursor_.number<Number>();
  }

  std::string string();

  /// Returns the number of elements that follow, each of at least `element_size` bytes; throws
  /// Error if so many bytes are not left.
  std::uint32_t count(std::size_t element_size);

  /// Returns the bytes of an array of them.
  std::string_view bytes() { return cursor_.take(count(1)); }

 private:
  void align(std::size_t size);

  ByteCursor cursor_;
  bool is_ros1_;
};

}  // namespace vo
