#include "tools/bench/render_bench.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <memory>
#include <numbers>

#include <nlohmann/json.hpp>

#include "synth/camera/make_renderer.h"
#include "synth/scene/world_geometry.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using synth::RendererKind;
using synth::RenderMode;
using synth::RenderOptions;

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::size_t count_triangles(const synth::Scene& scene) {
  std::size_t count = 0;
  for (const synth::Instance& instance : scene.instances) {
    count += instance.mesh == synth::kNone ? 0 : scene.meshes[instance.mesh].triangles.size();
  }
  return count;
}

/// Measures the mean cost of a frame after one uncounted frame, which allocates and compiles.
RenderCost measure(const synth::Scene& scene, const RenderOptions& options,
                   const vo::PinholeCamera& camera, const vo::Trajectory& views) {
  const std::unique_ptr<synth::Renderer> renderer = make_renderer(scene, options);
  renderer->render(camera, views.front().T_world_camera);
  const double cpu_start = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  const double wall_start = seconds_of(CLOCK_MONOTONIC);
  for (const vo::StampedPose& view : views) {
    renderer->render(camera, view.T_world_camera);
  }
  const double cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu_start;
  const double wall = seconds_of(CLOCK_MONOTONIC) - wall_start;
  const auto frames = static_cast<double>(views.size());
  return {.renderer = std::string(vo::to_string(options.kind)),
          .mode = std::string(vo::to_string(options.mode)),
          .samples = options.mode == RenderMode::depth ? 1 : options.samples,
          .width = camera.width,
          .height = camera.height,
          .triangles = count_triangles(scene),
          .cpu_s = cpu / frames,
          .wall_s = wall / frames};
}

vo::PinholeCamera scaled(const vo::PinholeCamera& camera, double scale) {
  vo::PinholeCamera result = camera;
  result.width = static_cast<int>(camera.width * scale);
  result.height = static_cast<int>(camera.height * scale);
  result.fx *= scale;
  result.fy *= scale;
  result.cx = (camera.cx + 0.5) * scale - 0.5;
  result.cy = (camera.cy + 0.5) * scale - 0.5;
  return result;
}

template <typename Made>
void split(std::vector<Made>& values, int a, int b) {
  if (!values.empty()) {
    values.push_back((values[static_cast<std::size_t>(a)] + values[static_cast<std::size_t>(b)]) /
                     2);
  }
}

int split_edge(synth::Mesh& mesh, int a, int b) {
  split(mesh.positions, a, b);
  split(mesh.normals, a, b);
  split(mesh.tangents, a, b);
  split(mesh.colors, a, b);
  for (std::vector<Eigen::Vector2f>& texcoords : mesh.texcoords) {
    split(texcoords, a, b);
  }
  return static_cast<int>(mesh.positions.size()) - 1;
}

std::string row_of(const RenderCost& cost) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%-11s %-7s %7d %5dx%-5d %10zu %10.4f %9.1f\n",
                cost.renderer.c_str(), cost.mode.c_str(), cost.samples, cost.width, cost.height,
                cost.triangles, cost.cpu_s, 1 / cost.wall_s);
  return text.data();
}

nlohmann::ordered_json json_of(const std::vector<RenderCost>& costs) {
  auto list = nlohmann::ordered_json::array();
  for (const RenderCost& cost : costs) {
    list.push_back({{"renderer", cost.renderer},
                    {"mode", cost.mode},
                    {"samples", cost.samples},
                    {"width", cost.width},
                    {"height", cost.height},
                    {"triangles", cost.triangles},
                    {"cpu_s_per_frame", cost.cpu_s},
                    {"wall_s_per_frame", cost.wall_s}});
  }
  return list;
}

}  // namespace

vo::Trajectory views_from_the_middle(const synth::Scene& scene) {
  constexpr int kDirections = 4;
  const Eigen::AlignedBox3d box = visible_bounds(synth::flatten(scene));
  vo::require(!box.isEmpty(), "bench: the scene has no triangles");
  const Eigen::AngleAxisd upright(std::numbers::pi, Eigen::Vector3d::UnitX());
  vo::Trajectory views;
  for (int i = 0; i < kDirections; ++i) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * (i + 0.5) / kDirections,
                                 Eigen::Vector3d::UnitY());
    views.push_back({static_cast<double>(i), vo::SE3(turn * upright, box.center())});
  }
  return views;
}

synth::Scene subdivided(const synth::Scene& scene) {
  synth::Scene finer = scene;
  for (synth::Mesh& mesh : finer.meshes) {
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = split_edge(mesh, a, b);
      const int bc = split_edge(mesh, b, c);
      const int ca = split_edge(mesh, c, a);
      triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(triangles);
  }
  return finer;
}

RenderBench bench_rendering(const synth::Scene& scene, const vo::PinholeCamera& camera,
                            const vo::Trajectory& views) {
  const RenderOptions depth{.mode = RenderMode::depth};
  const RenderOptions unlit{.mode = RenderMode::unlit, .samples = 16};
  const RenderOptions direct{.mode = RenderMode::direct, .samples = 16};
  RenderBench bench;
  for (const RenderOptions& options : {depth, unlit, direct}) {
    bench.costs.push_back(measure(scene, options, camera, views));
  }
  try {
    for (const RenderMode mode : {RenderMode::unlit, RenderMode::direct}) {
      const RenderOptions raster{.kind = RendererKind::rasterizer, .mode = mode, .samples = 1};
      bench.costs.push_back(measure(scene, raster, camera, views));
    }
  } catch (const vo::Error& error) {
    bench.absent = error.what();
  }
  const vo::Trajectory first(views.begin(), views.begin() + 1);
  for (const int samples : {1, 4, 16}) {
    bench.growth.push_back(
        measure(scene, {.mode = RenderMode::direct, .samples = samples}, camera, first));
  }
  for (const double scale : {0.5, 1.0, 2.0}) {
    bench.growth.push_back(measure(scene, depth, scaled(camera, scale), first));
  }
  bench.growth.push_back(measure(subdivided(scene), depth, camera, first));
  return bench;
}

std::string format_table(const RenderBench& bench) {
  const std::string header =
      "renderer    mode    samples        size  triangles  CPU s/frame  frames/s\n";
  std::string text = header;
  for (const RenderCost& cost : bench.costs) {
    text += row_of(cost);
  }
  text += bench.absent.empty() ? "" : "no rasterizer: " + bench.absent + "\n";
  text += "\nHow it grows with samples, resolution and triangles, from the first view:\n" + header;
  for (const RenderCost& cost : bench.growth) {
    text += row_of(cost);
  }
  return text;
}

std::string format_json(const RenderBench& bench) {
  const nlohmann::ordered_json result = {
      {"costs", json_of(bench.costs)}, {"growth", json_of(bench.growth)}, {"absent", bench.absent}};
  return json_text(json_document({"bench_render"}, result));
}

}  // namespace tools
