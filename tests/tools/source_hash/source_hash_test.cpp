#include "tools/source_hash/source_hash.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"

namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

TEST(SourceHash, ASetIsReadLineByLine) {
  const tools::SourceSet set = tools::parse_source_set("folder /a b\nsource c.cpp\nfact g++ 12\n");
  EXPECT_EQ(set.folders, std::vector<fs::path>{"/a b"});
  EXPECT_EQ(set.sources, std::vector<std::string>{"c.cpp"});
  EXPECT_EQ(set.facts, std::vector<std::string>{"g++ 12"});
  EXPECT_THAT(support::error_text([] { tools::parse_source_set("file a"); }),
              HasSubstr("file a: expected folder, source or fact"));
}

/// The sources that the hash of this build's sequences is made of, where a file may be replaced.
class GeneratorSources : public testing::Test {
 protected:
  GeneratorSources() { set_.folders.insert(set_.folders.begin(), planted_.path()); }

  static std::string text_of(const std::string& name) {
    return vo::read_file(fs::path(EDVO_SOURCE_DIR) / name);
  }

  /// Returns the hash with the file's text replaced once.
  std::string hash_with(const std::string& name, const std::string& find,
                        const std::string& replacement) const {
    std::string text = text_of(name);
    const std::size_t at = text.find(find);
    EXPECT_NE(at, std::string::npos) << name << " has no " << find;
    text.replace(at, find.size(), replacement);
    planted_.write(name, text);
    const std::string hash = tools::hash_sources(set_).hash;
    fs::remove(planted_.path() / name);
    return hash;
  }

  bool reads(const std::string& name) const {
    const auto files = tools::hash_sources(set_).files;
    return std::find(files.begin(), files.end(), fs::path(EDVO_SOURCE_DIR) / name) != files.end();
  }

  support::TempFolder planted_;
  tools::SourceSet set_ = tools::parse_source_set(vo::read_file(EDVO_GENERATOR_SOURCES));
  std::string hash_ = tools::hash_sources(set_).hash;
};

TEST_F(GeneratorSources, AConstantInAHeaderOfTheLensOrTheNoiseCounts) {
  EXPECT_NE(hash_with("vo/geometry/lens.h", "double k2 = 0", "double k2 = 1e-3"), hash_);
  EXPECT_NE(hash_with("vo/core/hash.h", "0x9e3779b97f4a7c15U", "0x9e3779b97f4a7c17U"), hash_);
  EXPECT_NE(hash_with("vo/core/random_field.h", "-2 * std::log", "-3 * std::log"), hash_);
  EXPECT_NE(hash_with("synth/sensor/image_noise.h", "= 0", "= 1"), hash_);
}

TEST_F(GeneratorSources, CommentsAndWhiteSpaceDoNotCount) {
  EXPECT_EQ(hash_with("vo/geometry/lens.h", "///", "/// Here:"), hash_);
  EXPECT_EQ(hash_with("synth/sensor/image_noise.cpp", "\n", "\n\n// A comment.\n"), hash_);
  EXPECT_EQ(hash_with("synth/sensor/image_noise.cpp", " = ", "   =\n "), hash_);
}

TEST_F(GeneratorSources, TheTrackerDoesNotCount) {
  EXPECT_TRUE(reads("vo/geometry/lens.h"));
  EXPECT_TRUE(reads("synth/ray_tracing/embree_scene.cpp"));
  EXPECT_FALSE(reads("vo/tracking/tracker.h"));
  EXPECT_FALSE(reads("vo/core/normal_equations.h"));
}

TEST_F(GeneratorSources, TheCompilerCounts) {
  set_.facts.emplace_back("another compiler");
  EXPECT_NE(tools::hash_sources(set_).hash, hash_);
}

TEST_F(GeneratorSources, AHeaderThatIsNowhereIsNamed) {
  EXPECT_THAT(support::error_text(
                  [&] { hash_with("vo/geometry/lens.h", "#pragma once", "#include \"none.h\""); }),
              HasSubstr("none.h: is in none of the folders of sources"));
}

}  // namespace
