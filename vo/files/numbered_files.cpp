#include "vo/files/numbered_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 10> kImageEndings = {
    ".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".PNG", ".JPG", ".JPEG", ".PGM", ".PPM"};

/// Returns the number of a name that is as `names` says.
std::optional<std::int64_t> number_of(std::string_view name, const NumberedNames& names) {
  if (!name.starts_with(names.prefix)) {
    return std::nullopt;
  }
  name.remove_prefix(names.prefix.size());
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || number < 0 || name.starts_with('-')) {
    return std::nullopt;
  }
  name.remove_prefix(static_cast<std::size_t>(end - name.data()));
  if (!name.starts_with(names.suffix)) {
    return std::nullopt;
  }
  name.remove_prefix(names.suffix.size());
  const bool ends_so = names.ending.empty() ? is_image_ending(name) : name == names.ending;
  return ends_so ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string_view number_at_end(std::string_view stem) {
  std::size_t begin = stem.size();
  bool has_point = false;
  while (begin > 0) {
    const char c = stem[begin - 1];
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_point = c == '.' && !has_point && begin < stem.size();
    if (!is_digit && !is_point) {
      break;
    }
    has_point = has_point || is_point;
    --begin;
  }
  const std::string_view number = stem.substr(begin);
  return number.starts_with('.') ? number.substr(1) : number;
}

bool is_image_ending(std::string_view text) {
  return std::find(kImageEndings.begin(), kImageEndings.end(), text) != kImageEndings.end();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (FolderEntry& entry : entries_of(folder)) {
    names.push_back(std::move(entry.name));
  }
  return names;
}

std::vector<NumberedFile> numbered_files(const fs::path& root, const fs::path& folder,
                                         const NumberedNames& names) {
  std::vector<NumberedFile> files;
  if (!fs::is_directory(root / folder)) {
    return files;
  }
  for (const std::string& name : names_in(root / folder)) {
    if (const auto number = number_of(name, names)) {
      files.push_back({*number, path_in(root, (folder / name).string(), root.string())});
    }
  }
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return a.number != b.number ? a.number < b.number : a.path < b.path;
  });
  const auto twice = std::adjacent_find(
      files.begin(), files.end(),
      [](const NumberedFile& a, const NumberedFile& b) { return a.number == b.number; });
  require(twice == files.end(), twice == files.end() ? "" : (twice + 1)->path.string(),
          ": has the number of another file, expected one of each");
  return files;
}

const NumberedFile* find_number(const std::vector<NumberedFile>& files, std::int64_t number) {
  const auto found = std::lower_bound(
      files.begin(), files.end(), number,
      [](const NumberedFile& file, std::int64_t wanted) { return file.number < wanted; });
  return found != files.end() && found->number == number ? &*found : nullptr;
}

}  // namespace vo
