#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/gltf.h"
#include "tests/support/gltf_document.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace synth {

/// The message that loading ends with; empty if it does not fail.
inline std::string error_of(const std::filesystem::path& path) {
  try {
    load_gltf(path);
  } catch (const vo::Error& error) {
    return error.what();
  }
  return {};
}

inline std::string error_of(const GltfDocument& document) {
  const support::TempFolder folder;
  const std::filesystem::path path = document.write(folder);
  std::string message = error_of(path);
  EXPECT_THAT(message, testing::StartsWith(path.string() + ": "));
  return message;
}

struct Replacement {
  const char* pointer;
  nlohmann::json value;
  const char* message;
};

/// The member's place names the test.
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
inline void PrintTo(const Replacement& replacement, std::ostream* out) {
  *out << replacement.pointer;
}

/// The triangle with an element of an array replaced.
inline std::string error_with(const std::string& pointer, const nlohmann::json& value) {
  GltfDocument document = triangle_document();
  document.json[nlohmann::json::json_pointer(pointer)] = value;
  return error_of(document);
}

}  // namespace synth
