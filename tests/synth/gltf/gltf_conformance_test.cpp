#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/gltf.h"
#include "synth/gltf/gltf_summary.h"
#include "synth/gltf_document/check_document.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/error_text.h"
#include "vo/core/error.h"

namespace synth {
namespace {

const std::filesystem::path kModels = std::filesystem::path(EDVO_SHARED_DATA) / "gltf/conformance";

constexpr double kPrintedStep = 1e-5;  // m, of the bounds in the manifest
constexpr double kRelative = 1e-4;     // of bounds in float

using Row = std::map<std::string, std::string>;  // value by column

/// The fields of a line whose fields may be quoted and contain no quotes.
std::vector<std::string> split_csv(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

std::vector<Row> read_manifest() {
  std::ifstream stream(kModels / "manifest.csv");
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> fields = split_csv(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i) {
      row[names[i]] = fields[i];
    }
  }
  return rows;
}

/// The first required extension that the loader does not understand, "" if there is none.
std::string unsupported_extension(const Row& row) {
  std::istringstream required(row.at("extensions_required"));
  for (std::string name; required >> name;) {
    if (!is_supported_extension(name)) {
      return name;
    }
  }
  return {};
}

Eigen::AlignedBox3d read_box(const Row& row) {
  Eigen::AlignedBox3d box;
  for (const char* column : {"bounds_min", "bounds_max"}) {
    std::istringstream stream(row.at(column));
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    if (stream >> corner.x() >> corner.y() >> corner.z()) {
      box.extend(corner);
    }
  }
  return box;
}

/// m, between corners of the same name.
double difference(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  return std::max((a.min() - b.min()).cwiseAbs().maxCoeff(),
                  (a.max() - b.max()).cwiseAbs().maxCoeff());
}

/// Errors of the Khronos validator after which the geometry or a reference means nothing.
constexpr std::array kBreaking = {"ACCESSOR_ANIMATION_INPUT_NEGATIVE",
                                  "ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION",
                                  "ACCESSOR_INDEX_OOB",
                                  "ACCESSOR_INDEX_PRIMITIVE_RESTART",
                                  "ACCESSOR_INVALID_FLOAT",
                                  "ACCESSOR_INVALID_IBM",
                                  "ACCESSOR_MATRIX_ALIGNMENT",
                                  "ACCESSOR_OFFSET_ALIGNMENT",
                                  "ACCESSOR_SMALL_BYTESTRIDE",
                                  "ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE",
                                  "ANIMATION_CHANNEL_TARGET_NODE_MATRIX",
                                  "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS",
                                  "ANIMATION_DUPLICATE_TARGETS",
                                  "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT",
                                  "ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS",
                                  "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT",
                                  "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT",
                                  "BUFFER_BYTE_LENGTH_MISMATCH",
                                  "BUFFER_MISSING_GLB_DATA",
                                  "BUFFER_VIEW_TOO_LONG",
                                  "CAMERA_ZFAR_LEQUAL_ZNEAR",
                                  "GLB_CHUNK_LENGTH_UNALIGNED",
                                  "GLB_CHUNK_TOO_BIG",
                                  "GLB_DUPLICATE_CHUNK",
                                  "GLB_EMPTY_CHUNK",
                                  "GLB_INVALID_VERSION",
                                  "GLB_LENGTH_MISMATCH",
                                  "GLB_LENGTH_TOO_SMALL",
                                  "GLB_UNEXPECTED_BIN_CHUNK",
                                  "GLB_UNEXPECTED_END_OF_CHUNK_DATA",
                                  "GLB_UNEXPECTED_END_OF_CHUNK_HEADER",
                                  "GLB_UNEXPECTED_FIRST_CHUNK",
                                  "INVALID_IBM_ACCESSOR_COUNT",
                                  "INVALID_INDEX",
                                  "IO_ERROR",
                                  "MESH_INVALID_WEIGHTS_COUNT",
                                  "MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT",
                                  "MESH_PRIMITIVE_ACCESSOR_UNALIGNED",
                                  "MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE",
                                  "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT",
                                  "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT",
                                  "MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT",
                                  "MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE",
                                  "MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH",
                                  "MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT",
                                  "MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR",
                                  "MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT",
                                  "NODE_LOOP",
                                  "NODE_MATRIX_TRS",
                                  "NODE_PARENT_OVERRIDE",
                                  "NODE_SKIN_NO_SCENE",
                                  "NODE_SKIN_WITH_NON_SKINNED_MESH",
                                  "NODE_WEIGHTS_INVALID",
                                  "ROTATION_NON_UNIT",
                                  "SCENE_NON_ROOT_NODE",
                                  "SKIN_IBM_INVALID_FORMAT",
                                  "SKIN_NO_COMMON_ROOT",
                                  "SKIN_SKELETON_INVALID",
                                  "UNKNOWN_ASSET_MAJOR_VERSION",
                                  "UNRESOLVED_REFERENCE"};

/// Errors of the Khronos validator about byteStrides that glTF does not allow. In all its files
/// they are of one element, or of views that nothing reads, and so change nothing.
constexpr std::array kNeedlessStride = {"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE",
                                        "BUFFER_VIEW_INVALID_BYTE_STRIDE",
                                        "BUFFER_VIEW_TOO_BIG_BYTE_STRIDE",
                                        "IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE",
                                        "SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE",
                                        "VALUE_MULTIPLE_OF"};

class GltfConformance : public testing::Test {
 protected:
  void SetUp() override {
    rows = read_manifest();
    if (rows.empty()) {
      GTEST_SKIP() << "no models in " << kModels;
    }
  }

  std::vector<Row> rows;
};

TEST_F(GltfConformance, EveryValidModelLoadsWithItsCountsAndBounds) {
  for (const Row& row : rows) {
    if (row.at("valid") != "1" || !unsupported_extension(row).empty()) {
      continue;
    }
    SCOPED_TRACE(row.at("path"));
    GltfSummary summary;
    EXPECT_EQ(support::error_text([&] { summary = summarize_gltf(kModels / row.at("path"), {}); }),
              "no error");
    EXPECT_EQ(summary.triangles, std::stoul(row.at("triangles")));
    EXPECT_EQ(summary.draw_calls, std::stoul(row.at("draw_calls")));
    EXPECT_EQ(summary.vertices, std::stoul(row.at("vertices")));
    const Eigen::AlignedBox3d expected = read_box(row);
    if (!expected.isEmpty()) {
      const double size =
          std::max(expected.min().cwiseAbs().maxCoeff(), expected.max().cwiseAbs().maxCoeff());
      EXPECT_LE(difference(summary.bounds, expected), kPrintedStep + kRelative * size);
    }
  }
}

TEST_F(GltfConformance, ARequiredExtensionThatIsNotSupportedIsNamed) {
  for (const Row& row : rows) {
    const std::string extension = unsupported_extension(row);
    if (row.at("valid") == "1" && !extension.empty()) {
      EXPECT_THAT(support::error_text([&] { load_gltf(kModels / row.at("path")); }),
                  testing::HasSubstr("requires the extension " + extension))
          << row.at("path");
    }
  }
}

TEST_F(GltfConformance, WhatBreaksGeometryOrReferencesIsRejected) {
  for (const Row& row : rows) {
    const bool breaks =
        std::find(kBreaking.begin(), kBreaking.end(), row.at("first_error")) != kBreaking.end();
    if (row.at("valid") == "0" && breaks) {
      const std::string path = (kModels / row.at("path")).string();
      EXPECT_THAT(support::error_text([&] { load_gltf(path); }), testing::StartsWith(path))
          << row.at("first_error");
    }
  }
}

TEST_F(GltfConformance, AStrideThatChangesNothingIsNoted) {
  int seen = 0;
  for (const Row& row : rows) {
    const std::string path = row.at("path");
    if (path.compare(0, 17, "validator_invalid") != 0 ||
        std::find(kNeedlessStride.begin(), kNeedlessStride.end(), row.at("first_error")) ==
            kNeedlessStride.end()) {
      continue;
    }
    Notes notes;
    EXPECT_EQ(support::error_text([&] { load_gltf(kModels / path, &notes); }), "no error") << path;
    EXPECT_THAT(notes, testing::Contains(testing::StartsWith("byteStrides"))) << path;
    ++seen;
  }
  EXPECT_EQ(seen, 6);
}

TEST_F(GltfConformance, EitherLoadsOrRejectsEveryFileAtAnyTime) {
  for (const Row& row : rows) {
    const std::filesystem::path path = kModels / row.at("path");
    try {
      const Scene scene = load_gltf(path, {.loop = true});
      for (const double time : {0.0, 0.37, 100.0}) {
        EXPECT_EQ(scene_at(scene, time).instances.size(), scene.instances.size());
      }
    } catch (const vo::Error& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path.string()));
    }
  }
}

}  // namespace
}  // namespace synth
