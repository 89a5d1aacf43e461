#include "synth/gltf_document/gltf_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace synth {
namespace {

GltfFile parsed(const std::string& text) {
  return parse_gltf_file({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a");
}

TEST(GltfFile, NumbersWithoutAFractionAreIntegersAtAnyDepth) {
  const nlohmann::json document =
      parsed(R"({"a": 3.0, "b": [{"c": [30e-1, 0.5]}], "d": -2.0})").json;
  EXPECT_TRUE(document["a"].is_number_unsigned());
  EXPECT_EQ(document["a"], 3U);
  EXPECT_TRUE(document["b"][0]["c"][0].is_number_unsigned());
  EXPECT_EQ(document["b"][0]["c"][0], 3U);
  EXPECT_EQ(document["b"][0]["c"][1], 0.5);
  EXPECT_TRUE(document["d"].is_number_float()) << "no index is negative";
}

/// A parser that looks through the array at each of its elements takes minutes for this one.
TEST(GltfFile, ALongArrayTakesTimeInProportionToItsLength) {
  constexpr std::size_t kElements = 500'000;
  std::string text = R"({"nodes": [{"mesh": 0})";
  for (std::size_t i = 1; i < kElements; ++i) {
    text += ",{}";
  }
  EXPECT_EQ(parsed(text + "]}").json["nodes"].size(), kElements);
}

}  // namespace
}  // namespace synth
