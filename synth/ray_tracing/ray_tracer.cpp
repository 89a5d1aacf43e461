#include "synth/ray_tracing/ray_tracer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/color_tracer.h"
#include "synth/ray_tracing/depth_sight_tracer.h"
#include "synth/ray_tracing/embree_scene.h"
#include "synth/ray_tracing/hit_cache.h"
#include "synth/ray_tracing/point_tracer.h"
#include "synth/rendering/surface_ids.h"
#include "synth/scene/world_geometry.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr int kTile = 8;  // px, a multiple of the edge of a packet's 4 x 4 block

/// The pixels of one square tile, in an order that keeps neighbours close.
struct Tile {
  Tile(const cv::Point& corner, const cv::Size& image);

  std::array<cv::Point, kTile * kTile> pixels;
  std::size_t count = 0;
};

/// Lists a tile's pixels in Morton order: an index's even bits are the column, its odd the row.
Tile::Tile(const cv::Point& corner, const cv::Size& image) {
  for (int i = 0; i < kTile * kTile; ++i) {
    const int column = (i & 1) | (i >> 1 & 2) | (i >> 2 & 4);
    const int row = (i >> 1 & 1) | (i >> 2 & 2) | (i >> 3 & 4);
    const cv::Point pixel = corner + cv::Point(column, row);
    if (pixel.x < image.width && pixel.y < image.height) {
      pixels[count++] = pixel;
    }
  }
}

/// Returns the depth of a packet's hit at a pixel's centre; `last` keeps the last hit's plane.
float depth_of_hit(const View& view, const cv::Point& pixel, const HitPacket& packet, int lane,
                   HitCache<DepthPlane>& last) {
  const auto make = [&](int mesh, int triangle) { return view.plane_of(mesh, triangle, pixel); };
  if (!view.has_one_eye()) {
    last = {};
  }
  const DepthPlane& plane = last.get(packet.mesh(lane), packet.triangle(lane), make);
  const std::optional<double> exact = view.depth_of(plane, pixel);
  return exact ? static_cast<float>(*exact) : packet.lanes.ray.tfar[lane];
}

/// Returns the point of a triangle that a packet's ray has met, without its depth.
TrianglePoint point_of(const HitPacket& packet, int lane) {
  return {.mesh = packet.mesh(lane),
          .triangle = packet.triangle(lane),
          .weights = packet.weights(lane).cast<double>()};
}

/// Returns each cell's part of the samples, which two `parts` share like a checkerboard, and the
/// index of its sample in it.
std::vector<SampleId> samples_of_cells(int per_edge, int parts) {
  std::vector<SampleId> ids;
  std::array<int, 2> counts{};
  for (int y = 0; y < per_edge; ++y) {
    for (int x = 0; x < per_edge; ++x) {
      const int part = (x + y) % parts;
      ids.push_back({{}, counts[static_cast<std::size_t>(part)]++, part});
    }
  }
  return ids;
}

cv::Vec3f pixel_of(const Eigen::Vector3f& color) {
  return {color.x(), color.y(), color.z()};
}

class RayTracer final : public Renderer {
 public:
  RayTracer(WorldGeometry world, const RenderOptions& options);

  using Renderer::render;
  RenderedFrame render(const Capture& capture) const override;
  NoisyFrame render_noisy(const Capture& capture) const override;
  Eigen::Vector3d position(const TrianglePoint& point, double time) const override {
    return position_in(world_, point, world_.share_at(time));
  }

 private:
  template <typename RenderColor>
  RenderedFrame render_tiles(const Capture& capture, RenderColor render_color) const;
  void render_surface(const View& view, const Tile& tile, const SurfaceIds& ids,
                      RenderedFrame& frame) const;
  void add_sample(const View& view, const cv::Point& pixel, std::size_t cell,
                  ColorPacket& packet) const;
  template <typename Add>
  void trace_cells(const View& view, const Tile& tile, ColorMemory& memory, PacketSights* sights,
                   Add add) const;
  void render_color(const View& view, const Tile& tile, ColorMemory& memory,
                    RenderedFrame& frame) const;
  void render_noisy_tile(const View& view, const Tile& tile, ColorMemory& memory,
                         NoisyPicture& picture) const;

  WorldGeometry world_;
  EmbreeScene embree_;
  bool has_color_;
  bool denoises_;
  std::vector<PixelCell> cells_;   ///< cells of a pixel, one colour sample each
  std::vector<SampleId> samples_;  ///< of the cells
  float width_of_cell_;            ///< px
  int anisotropy_;                 ///< RenderOptions::anisotropy
  ColorTracer color_tracer_;
};

RayTracer::RayTracer(WorldGeometry world, const RenderOptions& options)
    : world_(std::move(world)),
      embree_(world_),
      has_color_(options.mode != RenderMode::depth),
      denoises_(options.denoise),
      cells_(grid_of_cells(options.samples_per_edge())),
      samples_(samples_of_cells(options.samples_per_edge(), denoises_ ? 2 : 1)),
      width_of_cell_(1 / static_cast<float>(options.samples_per_edge())),
      anisotropy_(options.anisotropy),
      color_tracer_(world_, embree_, options) {}

/// Renders the channels of a capture tile by tile; `render_color` is called with each tile, to
/// render its colour.
template <typename RenderColor>
RenderedFrame RayTracer::render_tiles(const Capture& capture, RenderColor render_color) const {
  const vo::CameraModel& camera = capture.camera;
  camera.validate();
  capture.shutter.validate();
  const View view(world_, capture);
  RenderedFrame frame = empty_frame(camera, capture.channels);
  const SurfaceIds ids = capture.channels.ids ? surface_ids(world_) : SurfaceIds();
  ColorMemory memory = color_tracer_.new_memory(capture);
  const cv::Size size(camera.width(), camera.height());
  for (int v = 0; v < size.height; v += kTile) {
    for (int u = 0; u < size.width; u += kTile) {
      const Tile tile({u, v}, size);
      const Channels& channels = capture.channels;
      if (channels.depth || channels.normal || channels.ids || channels.sight || channels.points) {
        render_surface(view, tile, ids, frame);
      }
      render_color(view, tile, memory, frame);
    }
  }
  return frame;
}

RenderedFrame RayTracer::render(const Capture& capture) const {
  if (denoises_ && capture.channels.color) {
    return without_noise(render_noisy(capture), capture);
  }
  RenderedFrame frame = render_tiles(capture, [&](const View& view, const Tile& tile,
                                                  ColorMemory& memory, RenderedFrame& rendered) {
    if (capture.channels.color && has_color_) {
      render_color(view, tile, memory, rendered);
    }
  });
  if (capture.infrared) {
    frame.radiance = grey_of(frame.radiance);
  }
  return frame;
}

NoisyFrame RayTracer::render_noisy(const Capture& capture) const {
  vo::require(denoises_, "render: expected a renderer that denoises");
  capture.camera.validate();
  NoisyFrame noisy{{}, NoisyPicture({capture.camera.width(), capture.camera.height()})};
  noisy.frame = render_tiles(
      capture, [&](const View& view, const Tile& tile, ColorMemory& memory, RenderedFrame&) {
        render_noisy_tile(view, tile, memory, noisy.picture);
      });
  return noisy;
}

/// Renders a tile's depth, normals, ids, points and sight.
void RayTracer::render_surface(const View& view, const Tile& tile, const SurfaceIds& ids,
                               RenderedFrame& frame) const {
  HitCache<DepthPlane> last;
  const DepthSightTracer sight_tracer(world_, embree_, view);
  for (std::size_t first = 0; first < tile.count; first += kPacketSize) {
    HitPacket packet;
    const cv::Point* pixels = &tile.pixels[first];
    const auto size = static_cast<int>(std::min<std::size_t>(kPacketSize, tile.count - first));
    for (int i = 0; i < size; ++i) {
      view.add_ray_at_centre(pixels[i], packet);
    }
    embree_.intersect(packet, Sight::solid);
    if (!frame.sight.first.empty()) {
      sight_tracer.follow(pixels, packet, frame.sight);
    }
    for (int i = 0; i < size; ++i) {
      if (!packet.has_hit(i)) {
        continue;
      }
      if (!frame.depth.empty()) {
        frame.depth(pixels[i]) = depth_of_hit(view, pixels[i], packet, i, last);
      }
      if (!frame.normal.empty()) {
        frame.normal(pixels[i]) = view.normal(pixels[i], packet, i);
      }
      if (!frame.instance.empty()) {
        const auto mesh = static_cast<std::size_t>(packet.mesh(i));
        frame.instance(pixels[i]) = ids.instance[mesh];
        frame.material(pixels[i]) = ids.material[mesh];
      }
      if (!frame.points.points.empty()) {
        frame.points.at(pixels[i].x, pixels[i].y) = point_of(packet, i);
      }
    }
  }
}

/// Adds the sample of a cell of a pixel to a packet.
void RayTracer::add_sample(const View& view, const cv::Point& pixel, std::size_t cell,
                           ColorPacket& packet) const {
  const auto lane = static_cast<std::size_t>(packet.start.rays.size);
  packet.ids[lane] = samples_[cell];
  packet.ids[lane].pixel = pixel;
  view.add_ray_at_cell(pixel, cells_[cell], packet.start.rays);
  if (packet.infrared != nullptr && !packet.infrared->projectors.empty()) {
    packet.eyes[lane] = view.pose_at_cell(pixel, cells_[cell]);
  }
  if (packet.has_sides) {
    packet.sides[lane] = view.pixel_sides(pixel);
  }
}

/// Traces the cells of a tile in order, pixel by pixel, and calls `add` for each with the index of
/// its pixel in the tile, the index of the cell, its lane and its colour.
template <typename Add>
void RayTracer::trace_cells(const View& view, const Tile& tile, ColorMemory& memory,
                            PacketSights* sights, Add add) const {
  ColorPacket packet;
  packet.seed = view.seed();
  packet.sample_width = view.pixel_width() * width_of_cell_;
  packet.has_sides = anisotropy_ > 1 && view.has_pixel_sides();
  packet.infrared = view.infrared();
  std::array<std::pair<std::size_t, std::size_t>, kPacketSize> places;  // pixel and cell of a ray
  const auto trace = [&] {
    const PacketColors colors = color_tracer_.trace(packet, memory, sights);
    for (std::size_t i = 0; i < static_cast<std::size_t>(packet.start.rays.size); ++i) {
      add(places[i].first, places[i].second, i, colors[i]);
    }
    packet.start.rays.size = 0;
  };
  for (std::size_t place = 0; place < tile.count; ++place) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      places[static_cast<std::size_t>(packet.start.rays.size)] = {place, cell};
      add_sample(view, tile.pixels[place], cell, packet);
      if (packet.start.rays.size == kPacketSize) {
        trace();
      }
    }
  }
  if (packet.start.rays.size > 0) {
    trace();
  }
}

/// Renders a tile's colour: the mean over each pixel's cells.
void RayTracer::render_color(const View& view, const Tile& tile, ColorMemory& memory,
                             RenderedFrame& frame) const {
  std::array<Eigen::Vector3f, kTile * kTile> sums;
  sums.fill(Eigen::Vector3f::Zero());
  trace_cells(view, tile, memory, nullptr,
              [&](std::size_t place, std::size_t, std::size_t, const Eigen::Vector3f& color) {
                sums[place] += color;
              });
  for (std::size_t place = 0; place < tile.count; ++place) {
    frame.radiance(tile.pixels[place]) = pixel_of(sums[place] / static_cast<float>(cells_.size()));
  }
}

/// Renders what a denoiser needs of a tile: means over each pixel's cells.
void RayTracer::render_noisy_tile(const View& view, const Tile& tile, ColorMemory& memory,
                                  NoisyPicture& picture) const {
  struct Sums {
    std::array<Eigen::Vector3f, 2> noisy{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    FirstSight sight;
  };
  std::array<Sums, kTile * kTile> sums;
  PacketSights sights;
  const auto add = [&](std::size_t place, std::size_t cell, std::size_t lane,
                       const Eigen::Vector3f& color) {
    FirstSight& sight = sights[lane];
    Sums& sum = sums[place];
    const Eigen::Vector3f noisy = color - sight.shown;
    sum.noisy[static_cast<std::size_t>(samples_[cell].half)] += noisy;
    sum.sight.shown += sight.shown;
    sum.sight.reflectance += sight.reflectance;
    sum.sight.normal += sight.normal;
    sum.sight.nearness += sight.nearness;
    sight = {};
  };
  trace_cells(view, tile, memory, &sights, add);
  const std::size_t cells_of_half = cells_.size() / 2;
  const auto per_half = static_cast<float>(cells_of_half);
  const auto n = static_cast<float>(cells_.size());
  for (std::size_t place = 0; place < tile.count; ++place) {
    const cv::Point& pixel = tile.pixels[place];
    const Sums& sum = sums[place];
    picture.halves[0](pixel) = pixel_of(sum.noisy[0] / (n - per_half));
    picture.halves[1](pixel) = pixel_of(sum.noisy[1] / per_half);
    picture.shown(pixel) = pixel_of(sum.sight.shown / n);
    picture.reflectance(pixel) = pixel_of(sum.sight.reflectance / n);
    picture.normal(pixel) = pixel_of(sum.sight.normal / n);
    picture.nearness(pixel) = sum.sight.nearness / n;
  }
}

}  // namespace

std::unique_ptr<Renderer> make_ray_tracer(const Scene& scene, const RenderOptions& options) {
  return std::make_unique<RayTracer>(flatten(scene), options);
}

std::unique_ptr<Renderer> make_ray_tracer(const SceneDuring& during, const RenderOptions& options) {
  return std::make_unique<RayTracer>(flatten(during), options);
}

}  // namespace synth
