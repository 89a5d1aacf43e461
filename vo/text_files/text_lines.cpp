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

}  // namespace

std::string TextLine::place() const {
  return concat(file.string(), ":", number);
}

TextFile::TextFile(std::filesystem::path path)
    : path_(std::move(path)), text_(read_file(path_, kMaxListBytes)) {}

std::size_t TextFile::line_count() const {
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')) + 1;
}

void TextFile::for_each_line(const std::function<void(const TextLine& line)>& visit) const {
  TextLine line{path_, 0, {}};
  for (std::size_t begin = 0; begin < text_.size();) {
    const std::size_t end = std::min(text_.find('\n', begin), text_.size());
    const std::string_view text = std::string_view(text_).substr(begin, end - begin);
    ++line.number;
    split(text.substr(0, text.find('#')), line.fields);
    if (!line.fields.empty()) {
      visit(line);
    }
    begin = end + 1;
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
