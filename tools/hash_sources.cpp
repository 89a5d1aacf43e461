// hash_sources LIST HEADER DEPFILE: writes the header that tells the hash of the listed sources,
// and which files it depends on.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "tools/source_hash/source_hash.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/output.h"

namespace {

std::string header_of(const std::string& hash) {
  return "#pragma once\n\nnamespace tools {\n\n"
         "/// Returns the hash of all that makes the frames of a sequence but the scene and the "
         "recipe:\n/// the renderer's sources, its compiler and libraries.\n"
         "inline constexpr const char* generator_hash() {\n  return \"" +
         hash + "\";\n}\n\n}  // namespace tools\n";
}

std::string depfile_of(const std::string& header, const tools::SourceHash& hashed) {
  std::string text = header + ":";
  for (const std::filesystem::path& file : hashed.files) {
    text += " \\\n  " + file.string();
  }
  return text + "\n";
}

/// Leaves a file alone that has this text already, so that nothing is compiled anew for it.
void write_if_changed(const std::filesystem::path& file, const std::string& text) {
  if (!std::filesystem::exists(file) || vo::read_file(file) != text) {
    vo::write_file(file, text, vo::ExistingOutput::replace);
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    constexpr int kWords = 4;
    vo::require(count == kWords, "hash_sources: expected LIST HEADER DEPFILE");
    const tools::SourceHash hashed =
        tools::hash_sources(tools::parse_source_set(vo::read_file(words[1])));
    write_if_changed(words[2], header_of(hashed.hash));
    vo::write_file(words[3], depfile_of(words[2], hashed), vo::ExistingOutput::replace);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
