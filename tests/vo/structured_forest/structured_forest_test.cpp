#include "vo/structured_forest/structured_forest.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core/persistence.hpp>

#include "tests/support/error_text.h"
#include "tests/support/small_forest.h"
#include "tests/support/temp_folder.h"
#include "vo/archives/gzip.h"
#include "vo/files/input.h"
#include "vo/structured_forest/luv.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace {

using support::all_bins;
using support::error_text;
using support::small_forest;
using support::TempFolder;
using testing::HasSubstr;

constexpr int kLightnessInMiddle = 8 * 16 + 8;  // feature: channel 0, column 8, row 8 of 16

cv::Mat_<cv::Vec3f> uniform(float grey) {
  return cv::Mat_<cv::Vec3f>(80, 100, cv::Vec3f(grey, grey, grey));
}

/// 64 patches cover a pixel, each voting 2 stride^2 / 256.
TEST(StructuredForest, APixelThatEveryPatchVotesForHasStrengthTwo) {
  const cv::Mat_<float> strength = small_forest(0, -1, all_bins()).edge_strength(uniform(0.5F));
  for (const cv::Point pixel : {cv::Point(40, 40), cv::Point(20, 60), cv::Point(77, 33)}) {
    EXPECT_NEAR(strength(pixel), 2, 1e-5) << pixel;
  }
}

TEST(StructuredForest, BinsCountDownTheColumnsOfThePatch) {
  cv::Mat_<float> strength = small_forest(0, -1, {0}).edge_strength(uniform(0.5F));
  EXPECT_GT(strength(0, 0), 0);
  strength = small_forest(0, -1, {5}).edge_strength(uniform(0.5F));
  EXPECT_EQ(cv::countNonZero(strength.rowRange(0, 4)), 0) << "row 5 of the patch";
  EXPECT_GT(strength(5, 0), 0);
  strength = small_forest(0, -1, {16 * 5}).edge_strength(uniform(0.5F));
  EXPECT_EQ(cv::countNonZero(strength.colRange(0, 4)), 0) << "column 5 of the patch";
  EXPECT_GT(strength(0, 5), 0);
}

TEST(StructuredForest, GoesToTheSecondChildAtOrAboveTheThreshold) {
  const float half = vo::rgb_to_luv(uniform(0.5F))(0, 0)[0];
  const auto forest = small_forest(kLightnessInMiddle, half, all_bins());
  EXPECT_EQ(cv::countNonZero(forest.edge_strength(uniform(0.4F))), 0);
  EXPECT_NEAR(forest.edge_strength(uniform(0.6F))(40, 50), 2, 1e-5);
}

TEST(StructuredForest, SeesNothingInAnImageNotLargerThanAPatch) {
  const auto forest = small_forest(0, -1, all_bins());
  EXPECT_EQ(cv::countNonZero(forest.edge_strength(uniform(1).rowRange(0, 16))), 0);
  EXPECT_GT(cv::countNonZero(forest.edge_strength(uniform(1).rowRange(0, 18))), 0);
}

/// L* of white is 100, of grey 0.1842 is 50; both have the chromaticity of white.
TEST(Luv, OfGreysHasTheirLightnessAndNoColour) {
  for (const auto& [grey, lightness] : {std::pair{1.0F, 100.0F}, std::pair{0.1842F, 50.0F}}) {
    const cv::Vec3f luv = vo::rgb_to_luv(uniform(grey))(0, 0);
    EXPECT_NEAR(luv[0] * 270, lightness, 0.1);
    EXPECT_NEAR(luv[1] * 270 - 88, 0, 0.1);
    EXPECT_NEAR(luv[2] * 270 - 134, 0, 0.1);
  }
}

void expect_same_nodes(const vo::StructuredForest& read, const vo::StructuredForest& written) {
  EXPECT_EQ(read.nodes().children, written.nodes().children);
  EXPECT_EQ(read.nodes().feature_ids, written.nodes().feature_ids);
  EXPECT_EQ(read.nodes().thresholds, written.nodes().thresholds);
  EXPECT_EQ(read.nodes().edge_boundaries, written.nodes().edge_boundaries);
  EXPECT_EQ(read.nodes().edge_bins, written.nodes().edge_bins);
}

TEST(StructuredForestFile, ReadsWhatWasWritten) {
  const TempFolder folder;
  const auto forest = small_forest(kLightnessInMiddle, 0.1234F, {1, 20, 255});
  const std::string text = structured_forest_yaml(forest);
  for (const auto& [name, bytes] :
       {std::pair{"a.yml", text}, std::pair{"a.yml.gz", vo::gzip(text)}}) {
    const auto read = vo::read_structured_forest(folder.write(name, bytes));
    expect_same_nodes(read, forest);
    EXPECT_EQ(read.parameters().trees_to_evaluate, 1);
  }
}

/// A forest as FileStorage writes it in the format of this extension.
std::string as_storage(const vo::StructuredForest& forest, const std::string& extension) {
  cv::FileStorage out(extension, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  cv::FileStorage in(structured_forest_yaml(forest),
                     cv::FileStorage::READ | cv::FileStorage::MEMORY);
  out << "options"
      << "{";
  for (const cv::FileNode& option : in["options"]) {
    out << option.name() << static_cast<int>(option);
  }
  out << "}";
  const vo::ForestNodes& nodes = forest.nodes();
  out << "childs"
      << "[" << nodes.children << "]"
      << "featureIds"
      << "[" << nodes.feature_ids << "]"
      << "thresholds"
      << "[" << nodes.thresholds << "]"
      << "edgeBoundaries"
      << "[" << nodes.edge_boundaries << "]"
      << "edgeBins"
      << "[" << nodes.edge_bins << "]";
  return out.releaseAndGetString();
}

TEST(StructuredForestFile, ReadsWhatOpenCvWritesInEachOfItsFormats) {
  const TempFolder folder;
  const auto forest = small_forest(kLightnessInMiddle, 0.1234F, {1, 20, 255});
  for (const char* extension : {".yml", ".xml", ".json"}) {
    const auto read =
        vo::read_structured_forest(folder.write("model", as_storage(forest, extension)));
    EXPECT_EQ(structured_forest_yaml(read), structured_forest_yaml(forest)) << extension;
  }
}

/// Versions of OpenCV write the same numbers by different digits, so that bytes are not compared.
TEST(StructuredForestFile, TheShippedModelIsWrittenAsItWasRead) {
  const TempFolder folder;
  const auto shipped =
      vo::read_structured_forest(EDVO_SOURCE_DIR "/assets/edges/structured_forest.yml.gz");
  const auto path = folder.write("model.yml", structured_forest_yaml(shipped));
  expect_same_nodes(vo::read_structured_forest(path), shipped);
}

/// What reading a model says in which `from` has become `to`.
std::string error_with(const std::string& from, const std::string& to) {
  const TempFolder folder;
  std::string text = structured_forest_yaml(small_forest(7, 0.5F, {1, 20, 255}));
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const auto path = folder.write("model.yml", text);
  return error_text([&] { vo::read_structured_forest(path); });
}

TEST(StructuredForestFile, NamesTheElementThatIsWrong) {
  EXPECT_THAT(error_with("stride: 2", "strife: 2"),
              HasSubstr("options.stride: expected a whole number"));
  EXPECT_THAT(error_with("stride: 2", "stride: many"),
              HasSubstr("options.stride: expected a whole number, got 'many'"));
  EXPECT_THAT(error_with("stride: 2", "stride: 2\n   stride: 2"), HasSubstr("options.stride"));
  EXPECT_THAT(error_with("stride: 2", "stride: -2"), HasSubstr("stride: expected 1 to 16, got -2"));
  EXPECT_THAT(error_with("patchSize: 32", "patchSize: 31"), HasSubstr("patchSize"));
  EXPECT_THAT(error_with("numberOfTrees: 2", "numberOfTrees: 4"), HasSubstr("childs: expected"));
  EXPECT_THAT(error_with("[ 2, 0, 0 ]", "[ 9, 0, 0 ]"), HasSubstr("childs[0]: expected 0 or"));
  EXPECT_THAT(error_with("[ 2, 0, 0 ]", "[ 1, 0, 0 ]"), HasSubstr("childs[0]: expected 0 or"));
  EXPECT_THAT(error_with("[ 2, 0, 0 ]", "[ 2, 0 ]"), HasSubstr("childs: expected as many"));
  EXPECT_THAT(error_with("[ 7, 0, 0 ]", "[ 7228, 0, 0 ]"), HasSubstr("featureIds[0]: expected 0"));
  EXPECT_THAT(error_with("[ 7, 0, 0 ]", "[ a, 0, 0 ]"), HasSubstr("featureIds[0]: expected a num"));
  EXPECT_THAT(error_with("thresholds:", "tresholds:"), HasSubstr("thresholds: expected a seq"));
  EXPECT_THAT(error_with("[ 0, 0, 0 ]", "[ 0, 4, 0 ]"), HasSubstr("edgeBoundaries[2]: expected"));
  EXPECT_THAT(error_with("1, 20, 255", "1, 20, 3328"),
              HasSubstr("edgeBins[2]: expected 0 to 3327"));
}

TEST(StructuredForestFile, TheShippedModelIsSmallAndReads) {
  const std::string model = EDVO_SOURCE_DIR "/assets/edges/structured_forest.yml.gz";
  EXPECT_LE(std::filesystem::file_size(model), 500000U);
  EXPECT_EQ(vo::read_structured_forest(model).parameters().trees, 8);
}

TEST(StructuredForestFile, RefusesWhatIsNoModel) {
  const TempFolder folder;
  const std::string gz = vo::gzip(structured_forest_yaml(small_forest(7, 0.5F, all_bins())));
  for (const auto& path :
       {folder.write("empty.yml", ""), folder.write("noise.yml.gz", "\x1f\x8b\x08 not a model"),
        folder.write("text.yml", "hello"), folder.write("tag.xml", "<?xml"),
        folder.write("deep.yml", std::string(100'000, '[')),
        folder.write("string.yml", "options: \"stride"),
        folder.write("broken.yml", "%YAML:1.0\n---\na: [1,"),
        folder.write("cut.yml.gz", gz.substr(0, gz.size() / 2)), folder.path() / "missing.yml"}) {
    EXPECT_THAT(error_text([&] { vo::read_structured_forest(path); }), HasSubstr(path.string()));
  }
}

}  // namespace
