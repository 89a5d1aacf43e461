#include "vo/structured_forest/forest_text.h"

#include <algorithm>
#include <cstddef>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

/// Reads a text from its start to its end.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  char front() const { return text_[at_]; }
  bool starts_with(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  bool at_line_start() const { return at_ == 0 || text_[at_ - 1] == '\n'; }

  void skip(std::size_t count) { at_ = std::min(at_ + count, text_.size()); }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlank, at_), text_.size()); }

  /// Returns what comes before the first of these characters, or the rest, and moves behind it.
  std::string_view until_any(std::string_view characters) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(characters, at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  /// Returns what comes before a word and moves behind the word; throws Error if there is none.
  std::string_view up_to(std::string_view word) {
    const std::size_t begin = at_;
    const std::size_t end = text_.find(word, at_);
    require(end != std::string_view::npos, "line ", line(), ": expected ", word, ", got the end");
    at_ = end + word.size();
    return text_.substr(begin, end - begin);
  }

  std::ptrdiff_t line() const {
    return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Reads the words of YAML as FileStorage writes it, and of JSON: a word before a colon is a key.
class YamlReader {
 public:
  YamlReader(std::string_view text, const VisitForestValue& visit) : cursor_(text), visit_(visit) {}

  void read() {
    for (cursor_.skip_blanks(); !cursor_.at_end(); cursor_.skip_blanks()) {
      read_word();
    }
    require(depth_ == 0, "line ", cursor_.line(), ": expected the end of a list, got the end");
  }

 private:
  void read_word() {
    const char c = cursor_.front();
    if (c == '#' || (c == '%' && cursor_.at_line_start())) {
      cursor_.until_any("\n");
    } else if (c == '[' || c == '{' || c == ']' || c == '}' || c == ',') {
      depth_ += c == '[' || c == '{' ? 1 : 0;
      depth_ -= c == ']' || c == '}' ? 1 : 0;
      cursor_.skip(1);
    } else if (c == '"') {
      read_quoted();
    } else {
      std::string_view word = cursor_.until_any(" \t\r\n,[]{}\"");
      if (word.ends_with(':')) {
        key_ = word.substr(0, word.size() - 1);
      } else if (word != "-" && word != "---" && word != "...") {
        visit_(key_, word);
      }
    }
  }

  void read_quoted() {
    cursor_.skip(1);
    const std::string_view word = cursor_.up_to("\"");
    cursor_.skip_blanks();
    if (cursor_.starts_with(":")) {
      cursor_.skip(1);
      key_ = word;
    } else {
      visit_(key_, word);
    }
  }

  Cursor cursor_;
  const VisitForestValue& visit_;
  std::string_view key_;
  int depth_ = 0;
};

/// Reads XML as FileStorage writes it: the tag around values is their key, but for `_`, which is an
/// element of a list.
void read_xml(std::string_view text, const VisitForestValue& visit) {
  Cursor cursor(text);
  std::string_view key;
  for (cursor.skip_blanks(); !cursor.at_end(); cursor.skip_blanks()) {
    if (cursor.starts_with("<!--")) {
      cursor.up_to("-->");
    } else if (cursor.starts_with("<")) {
      cursor.skip(1);
      const std::string_view tag = cursor.up_to(">");
      const std::string_view name = tag.substr(0, tag.find_first_of(kBlank));
      if (name != "_" && name != "/_") {
        key = name.starts_with("/") ? std::string_view() : name;
      }
    } else {
      visit(key, cursor.until_any(" \t\r\n<"));
    }
  }
}

}  // namespace

void for_each_forest_value(std::string_view text, const VisitForestValue& visit) {
  if (text.substr(std::min(text.find_first_not_of(kBlank), text.size())).starts_with('<')) {
    read_xml(text, visit);
  } else {
    YamlReader(text, visit).read();
  }
}

}  // namespace vo
