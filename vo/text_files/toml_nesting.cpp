#include "vo/text_files/toml_nesting.h"

#include <algorithm>
#include <cstddef>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kMaxKeyParts = 64;
constexpr int kMaxInlineTables = 16;

/// Walks through TOML text outside of strings and comments.
class NestingScanner {
 public:
  NestingScanner(std::string_view text, const std::filesystem::path& path)
      : rest_(text), path_(path) {}

  void scan() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '#') {
        skip(rest_.find('\n'));
      } else if (c == '"' || c == '\'') {
        skip_string(c);
      } else {
        count(c);
        skip(1);
      }
    }
  }

 private:
  void count(char c) {
    switch (c) {
      case '.':
        ++key_parts_;
        break;
      case '{':
        ++inline_tables_;
        key_parts_ = 1;
        break;
      case '}':
        --inline_tables_;
        key_parts_ = 1;
        break;
      case '[':
      case ']':
      case '=':
      case ',':
      case '\n':
        key_parts_ = 1;
        break;
      default:
        break;
    }
    require(key_parts_ <= kMaxKeyParts, path_.string(), ":", line_, ": a key has more than ",
            kMaxKeyParts, " parts");
    require(inline_tables_ <= kMaxInlineTables, path_.string(), ":", line_, ": more than ",
            kMaxInlineTables, " inline tables lie within each other");
  }

  void skip(std::size_t length) {
    const std::string_view skipped = rest_.substr(0, length);
    line_ += std::count(skipped.begin(), skipped.end(), '\n');
    rest_.remove_prefix(skipped.size());
  }

  /// Skips a string; one that does not end is left to the parser.
  void skip_string(char quote) {
    const bool is_long = rest_.substr(0, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
    const std::string_view end = rest_.substr(0, is_long ? 3 : 1);
    std::size_t at = end.size();
    while (at < rest_.size() && rest_.substr(at, end.size()) != end) {
      const bool is_escape = quote == '"' && rest_[at] == '\\';
      if (!is_long && rest_[at] == '\n') {
        break;
      }
      at += is_escape ? 2 : 1;
    }
    skip(std::min(at, rest_.size()) + end.size());
  }

  std::string_view rest_;
  const std::filesystem::path& path_;
  std::ptrdiff_t line_ = 1;
  int key_parts_ = 1;
  int inline_tables_ = 0;
};

}  // namespace

void require_shallow_toml(std::string_view text, const std::filesystem::path& path) {
  NestingScanner(text, path).scan();
}

}  // namespace vo
