#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf.h"
#include "synth/gltf_check.h"
#include "vo/core/error.h"

namespace synth {
namespace {

const std::filesystem::path kModels = std::filesystem::path(EDVO_SHARED_DATA) / "gltf/conformance";

constexpr double kPrintedStep = 1e-5;       // m, of the bounds in the manifest
constexpr double kRelativeRounding = 1e-6;  // of bounds in float

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

bool is_below(const Row& row, const std::string& folder) {
  return row.at("path").compare(0, folder.size(), folder) == 0;
}

bool is_readable(const Row& row) {
  std::istringstream required(row.at("extensions_required"));
  for (std::string name; required >> name;) {
    if (!is_supported_extension(name)) {
      return false;
    }
  }
  return row.at("valid") == "1";
}

/// The manifest counts the triangles of each mesh once, however many nodes show it.
std::size_t count_triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    count += mesh.triangles.size();
  }
  return count;
}

Eigen::AlignedBox3d bounds_of(const Scene& scene) {
  Eigen::AlignedBox3d bounds;
  for (const Instance& instance : scene.instances) {
    for (const Eigen::Vector3f& p :
         scene.meshes.at(static_cast<std::size_t>(instance.mesh)).positions) {
      bounds.extend(instance.T_world_mesh * p.cast<double>());
    }
  }
  return bounds;
}

Eigen::Vector3d read_vector(const std::string& text) {
  std::istringstream stream(text);
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  stream >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

bool contains_any(const std::string& path, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return path.find(name) != std::string::npos; });
}

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

TEST_F(GltfConformance, LoadsEveryValidModelWithItsTriangles) {
  const std::vector<std::string> other_scenes_too = {"MultipleScenes"};
  int loaded = 0;
  for (const Row& row : rows) {
    if ((is_below(row, "khronos/") || is_below(row, "habitat/")) && is_readable(row) &&
        !contains_any(row.at("path"), other_scenes_too)) {
      const Scene scene = load_gltf(kModels / row.at("path"));
      EXPECT_EQ(count_triangles(scene), std::stoul(row.at("triangles"))) << row.at("path");
      ++loaded;
    }
  }
  EXPECT_GE(loaded, 80);
}

TEST_F(GltfConformance, PlacesEveryValidModelWithinItsBounds) {
  // MeshPrimitiveModes: the bounds include points and lines. TextureEncodingTest: they follow a
  // quaternion of length 0.99985 without normalising it.
  const std::vector<std::string> other_bounds = {"MeshPrimitiveModes", "TextureEncodingTest"};
  for (const Row& row : rows) {
    if ((is_below(row, "khronos/") || is_below(row, "habitat/")) && is_readable(row) &&
        !contains_any(row.at("path"), other_bounds)) {
      const Eigen::AlignedBox3d bounds = bounds_of(load_gltf(kModels / row.at("path")));
      const Eigen::Vector3d expected_min = read_vector(row.at("bounds_min"));
      const Eigen::Vector3d expected_max = read_vector(row.at("bounds_max"));
      const double tolerance =
          kPrintedStep + kRelativeRounding * expected_max.cwiseAbs().maxCoeff();
      EXPECT_LE((bounds.min() - expected_min).cwiseAbs().maxCoeff(), tolerance) << row.at("path");
      EXPECT_LE((bounds.max() - expected_max).cwiseAbs().maxCoeff(), tolerance) << row.at("path");
    }
  }
}

TEST_F(GltfConformance, EitherLoadsOrRejectsEveryFile) {
  int rejected = 0;
  for (const Row& row : rows) {
    const std::filesystem::path path = kModels / row.at("path");
    try {
      load_gltf(path);
    } catch (const vo::Error& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path.string())) << row.at("path");
      ++rejected;
    }
  }
  EXPECT_GE(rejected, 200);
}

}  // namespace
}  // namespace synth
