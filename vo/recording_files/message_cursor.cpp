#include "vo/recording_files/message_cursor.h"

namespace vo {
namespace {

std::string_view without_encapsulation(std::string_view bytes, std::string_view encoding) {
  if (encoding == "ros1") {
    return bytes;
  }
  require(encoding == "cdr", "is encoded as '", std::string(encoding),
          "', expected cdr (ROS 2) or ros1");
  require(bytes.size() >= kCdrEncapsulation, "ends early: expected CDR, got ", bytes.size(),
          " bytes");
  require(bytes[0] == 0 && bytes[1] == 1, "is in CDR of another kind (", static_cast<int>(bytes[0]),
          " ", static_cast<int>(bytes[1]), "), expected plain CDR in little endian (0 1)");
  return bytes.substr(kCdrEncapsulation);
}

}  // namespace

MessageCursor::MessageCursor(std::string_view bytes, std::string_view encoding)
    : cursor_(without_encapsulation(bytes, encoding)), is_ros1_(encoding == "ros1") {}

std::string MessageCursor::string() {
  std::string_view text = cursor_.take(number<std::uint32_t>());
  if (!is_ros1_ && text.ends_with('\0')) {
    text.remove_suffix(1);  // CDR counts the zero at a string's end
  }
  return std::string(text);
}

std::uint32_t MessageCursor::count(std::size_t element_size) {
  const auto elements = number<std::uint32_t>();
  require(elements <= cursor_.left() / element_size, "ends early: states ", elements,
          " elements, which ", cursor_.left(), " bytes cannot hold");
  return elements;
}

void MessageCursor::align(std::size_t size) {
  const std::size_t over = is_ros1_ ? 0 : cursor_.position() % size;
  cursor_.take(over == 0 ? 0 : size - over);
}

}  // namespace vo
