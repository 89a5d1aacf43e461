#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

struct XXH3_state_s;

namespace vo {

/// Hash of 128 bits (XXH3) of bytes that are added one after another, to tell whether two contents
/// are equal, on any machine. Not for security.
class ContentHash {
 public:
  ContentHash();

  void add(std::string_view bytes);

  /// Adds the bytes of plain values, whose type must have no padding.
  template <typename T>
  void add_values(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
  }

  std::string hex() const;  ///< hash of the bytes so far as 32 hexadecimal digits

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };

  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// Returns the ContentHash of the bytes as 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

}  // namespace vo
