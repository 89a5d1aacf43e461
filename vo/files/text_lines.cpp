#include "vo/files/text_lines.h"

#include <cmath>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/output.h"

namespace vo {
namespace {

constexpr std::string_view kBlanks = " \t\r,";

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, begin);
    fields.emplace_back(line.substr(begin, end - begin));
    begin = end == std::string_view::npos ? end : line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

}  // namespace

std::vector<TextLine> read_text_lines(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  std::vector<TextLine> lines;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++number;
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    std::vector<std::string> fields = split(line.substr(0, line.find('#')));
    if (!fields.empty()) {
      lines.push_back({concat(path.string(), ":", number), std::move(fields)});
    }
    begin = end + 1;
  }
  return lines;
}

double parse_number(const TextLine& line, std::size_t field) {
  try {
    return parse_real(line.fields.at(field));
  } catch (const Error& error) {
    fail(line.place, ": ", error.what(), " as value ", field + 1);
  }
}

}  // namespace vo
