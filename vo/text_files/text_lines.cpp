#include "vo/text_files/text_lines.h"

#include <algorithm>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"

namespace vo {
namespace {

constexpr std::string_view kBlanks = " \t\r,";

void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, begin);
    fields.push_back(line.substr(begin, end - begin));
    begin = end == std::string_view::npos ? end : line.find_first_not_of(kBlanks, end);
  }
}

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

/// Makes `line` the one that begins at an index of the text; returns where the next one begins.
std::size_t next_line(std::string_view text, std::size_t begin, TextLine& line) {
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  line.text = text.substr(begin, end - begin);
  ++line.number;
  return end + 1;
}

}  // namespace

std::string TextLine::place() const {
  return concat(file.string(), ":", number);
}

TextFile::TextFile(std::filesystem::path path)
    : path_(std::move(path)), text_(read_file(path_, kMaxListBytes)) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) {
    text_.erase(0, kByteOrderMark.size());
  }
}

std::size_t TextFile::line_count() const {
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')) + 1;
}

TextLine TextFile::first_line() const {
  TextLine line{path_, 0, {}, {}};
  std::size_t begin = 0;
  while (begin < text_.size() && line.fields.empty()) {
    begin = next_line(text_, begin, line);
    split(without_comment(line.text), line.fields);
  }
  return line;
}

void TextFile::for_each_line(const std::function<void(const TextLine& line)>& visit) const {
  TextLine line{path_, 0, {}, {}};
  for (std::size_t begin = 0; begin < text_.size();) {
    begin = next_line(text_, begin, line);
    split(without_comment(line.text), line.fields);
    if (!line.fields.empty()) {
      visit(line);
    }
  }
}

void TextFile::for_each_whole_line(const std::function<void(const TextLine& line)>& visit) const {
  TextLine line{path_, 0, {}, {}};
  for (std::size_t begin = 0; begin < text_.size();) {
    begin = next_line(text_, begin, line);
    split(line.text, line.fields);
    visit(line);
  }
}

double parse_number(const TextLine& line, std::size_t field) {
  try {
    return parse_real(line.fields.at(field));
  } catch (const Error& error) {
    fail(line.place(), ": ", error.what(), " as value ", field + 1);
  }
}

}  // namespace vo
