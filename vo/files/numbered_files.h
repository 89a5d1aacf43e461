#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// A file of a frame in a folder whose names have numbers.
struct NumberedFile {
  std::int64_t number = 0;
  std::filesystem::path path;
};

/// The pattern of the names of a folder's files: `prefix`, digits, `suffix`, `ending`.
struct NumberedNames {
  std::string prefix;
  std::string suffix;
  std::string ending;  ///< empty: any that `is_image_ending`
};

/// Returns the digits, with at most one point between them, that the name of a file without its
/// ending ends with.
std::string_view number_at_end(std::string_view stem);

/// Returns whether a name's ending is one of images: .png, .jpg, .jpeg, .pgm or .ppm, in either
/// case.
bool is_image_ending(std::string_view ending);

/// Returns the names of what is in a folder, sorted. Throws Error naming it if it cannot be listed.
std::vector<std::string> names_in(const std::filesystem::path& folder);

/// Returns the files with such names in order of their numbers; none if there is no such folder.
/// Throws Error naming the file for a number that another file has, and for a link that leads out
/// of `root`, the sequence's folder, of which `folder` is a part.
std::vector<NumberedFile> numbered_files(const std::filesystem::path& root,
                                         const std::filesystem::path& folder,
                                         const NumberedNames& names);

/// Returns the file of a number, or nullptr.
const NumberedFile* find_number(const std::vector<NumberedFile>& files, std::int64_t number);

}  // namespace vo
