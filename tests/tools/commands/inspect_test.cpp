#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"

namespace {

using nlohmann::json;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

TEST(Inspect, SaysWhatAFileHolds) {
  const TempFolder folder;
  // A triangle whose corners are all at the origin, as its accessor has no bytes, moved to (1, 2,
  // 3).
  const auto scene = folder.write("scene.gltf", R"({
    "asset": {"version": "2.0"}, "extensionsUsed": ["EXT_other"],
    "accessors": [{"type": "VEC3", "componentType": 5126, "count": 3}],
    "materials": [{"name": "brass"}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "nodes": [{"mesh": 0, "translation": [1, 2, 3]}, {"name": "eye", "camera": 0}]})");
  const auto result = run_program("inspect '" + scene.string() + "' --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json summary = json::parse(result.out);
  EXPECT_EQ(summary["triangles"], 1);
  EXPECT_EQ(summary["draw_calls"], 1);
  EXPECT_EQ(summary["vertices"], 3);
  EXPECT_EQ(summary["shown_triangles"], 1);
  EXPECT_EQ(summary["sharing_instances"], 0);
  EXPECT_EQ(summary["bounds"]["min"], json({1.0, 2.0, 3.0}));
  EXPECT_EQ(summary["bounds"]["max"], json({1.0, 2.0, 3.0}));
  EXPECT_EQ(summary["materials"], json({"brass"}));
  EXPECT_EQ(summary["cameras"][0]["name"], "eye");
  EXPECT_EQ(summary["extensions_used"], json({"EXT_other"}));
  EXPECT_EQ(summary["notes"], json({"the extension EXT_other is ignored"}));
}

TEST(Inspect, NamesAnExtensionThatIsNotSupported) {
  const TempFolder folder;
  const auto scene = folder.write("scene.gltf", R"({
    "asset": {"version": "2.0"}, "extensionsRequired": ["KHR_texture_basisu"]})");
  const auto result = run_program("inspect '" + scene.string() + "'");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("requires the extension KHR_texture_basisu"));
}

}  // namespace
