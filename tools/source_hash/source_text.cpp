#include "tools/source_hash/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace tools {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Reads a source from its beginning to its end and keeps the code.
class SourceReader {
 public:
  explicit SourceReader(std::string_view source) : source_(source) {}

  std::string code() {
    while (at_ < source_.size()) {
      read_next();
    }
    return code_;
  }

 private:
  bool is_at(std::string_view text) const { return source_.substr(at_).starts_with(text); }

  void read_next() {
    if (is_at("//")) {
      skip_line_comment();
    } else if (is_at("/*")) {
      const std::size_t end = source_.find("*/", at_ + 2);
      at_ = end == std::string_view::npos ? source_.size() : end + 2;
      has_gap_ = true;
    } else if (is_at("\\\n")) {
      at_ += 2;
    } else if (is_space(source_[at_])) {
      ends_line_ = ends_line_ || source_[at_] == '\n';
      has_gap_ = true;
      ++at_;
    } else {
      keep_gap();
      keep_code();
    }
  }

  void skip_line_comment() {
    do {
      at_ = std::min(source_.find('\n', at_ + 1), source_.size());
    } while (at_ < source_.size() && source_[at_ - 1] == '\\');
    has_gap_ = true;
  }

  /// Writes what stands for the white space and comments since the last code.
  void keep_gap() {
    const bool starts_directive = source_[at_] == '#' && (ends_line_ || code_.empty());
    if (!code_.empty() && has_gap_) {
      code_ += ends_line_ && (is_directive_ || starts_directive) ? '\n' : ' ';
    }
    is_directive_ = starts_directive || (is_directive_ && !ends_line_);
    has_gap_ = false;
    ends_line_ = false;
  }

  void keep_code() {
    if (source_[at_] == '"') {
      keep(is_raw_string() ? raw_string_end() : literal_end('"'));
    } else if (source_[at_] == '\'' && !is_within_number()) {
      keep(literal_end('\''));
    } else {
      keep(at_ + 1);
    }
  }

  void keep(std::size_t end) {
    end = std::min(end, source_.size());
    code_ += source_.substr(at_, end - at_);
    at_ = end;
  }

  /// Returns the letters and digits that the code ends in; apostrophes between digits belong to
  /// them.
  std::string_view last_word() const {
    std::size_t begin = code_.size();
    while (begin > 0 && (is_word(code_[begin - 1]) || code_[begin - 1] == '\'')) {
      --begin;
    }
    return std::string_view(code_).substr(begin);
  }

  bool is_within_number() const {
    const std::string_view word = last_word();
    return !word.empty() && std::isdigit(static_cast<unsigned char>(word.front())) != 0;
  }

  bool is_raw_string() const {
    constexpr std::array<std::string_view, 5> kPrefixes{"R", "LR", "uR", "UR", "u8R"};
    return std::find(kPrefixes.begin(), kPrefixes.end(), last_word()) != kPrefixes.end();
  }

  std::size_t raw_string_end() const {
    const std::size_t open = source_.find('(', at_);
    if (open == std::string_view::npos) {
      return source_.size();
    }
    const std::string closing = ")" + std::string(source_.substr(at_ + 1, open - at_ - 1)) + "\"";
    const std::size_t close = source_.find(closing, open);
    return close == std::string_view::npos ? source_.size() : close + closing.size();
  }

  std::size_t literal_end(char quote) const {
    std::size_t end = at_ + 1;
    while (end < source_.size() && source_[end] != quote) {
      end += source_[end] == '\\' ? 2 : 1;
    }
    return end + 1;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  std::string code_;
  bool has_gap_ = false;       ///< white space or a comment since the last code
  bool ends_line_ = false;     ///< a line's end among it
  bool is_directive_ = false;  ///< the last code belongs to a preprocessor directive
};

}  // namespace

std::string without_comments(std::string_view source) {
  return SourceReader(source).code();
}

}  // namespace tools
