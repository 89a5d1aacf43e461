#include "synth/rasterization/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "synth/rasterization/gl_context.h"
#include "synth/rasterization/gl_program.h"
#include "synth/rasterization/gl_scene.h"
#include "synth/rasterization/gl_target.h"
#include "synth/rasterization/rasterizer_shaders.h"
#include "synth/ray_tracing/embree_scene.h"
#include "synth/rendering/surface_ids.h"
#include "synth/scene/cofactors.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/shading.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr float kNear = 0.01F;            // m along the optical axis
constexpr std::size_t kMaxLights = 64;    // as in kFragmentShader
constexpr std::size_t kTextureSlots = 7;  // as in kFragmentShader

/// One pass that draws the scene.
struct Pass {
  Eigen::Vector2d offset;      ///< px, from the pixels' centres to the samples
  std::optional<double> turn;  ///< 0 to 1, place among the passes that colour averages

  /// Returns the alpha from which a blended surface is drawn in this pass: in all, it is drawn in
  /// the fraction of passes that its alpha gives. Meshes differ, so that none always hides another.
  double threshold(std::size_t mesh) const {
    constexpr double kGolden = 0.6180339887498949;
    const double shifted = turn.value_or(0) + kGolden * static_cast<double>(mesh);
    return turn ? shifted - std::floor(shifted) : 0.5;
  }
};

/// The camera of a capture, in the world-space geometry's coordinates.
struct Camera {
  const vo::PinholeCamera& pinhole;
  Eigen::Matrix3f R_camera_world;
  Eigen::Vector3f position;  ///< m
};

/// Returns the projection to clip space, with rows from the top and depth near / z.
Eigen::Matrix4f projection(const vo::PinholeCamera& camera, const Eigen::Vector2d& offset) {
  Eigen::Matrix4d P = Eigen::Matrix4d::Zero();
  P(0, 0) = 2 * camera.fx / camera.width;
  P(0, 2) = 2 * (camera.cx + 0.5 - offset.x()) / camera.width - 1;
  P(1, 1) = 2 * camera.fy / camera.height;
  P(1, 2) = 2 * (camera.cy + 0.5 - offset.y()) / camera.height - 1;
  P(2, 3) = kNear;
  P(3, 2) = 1;
  return P.cast<float>();
}

/// Returns a material's texture slots in the order of kFragmentShader.
std::array<const TextureSlot*, kTextureSlots> texture_slots(const Material& material) {
  return {&material.base_color_texture,    &material.metallic_roughness_texture,
          &material.normal_texture,        &material.occlusion_texture,
          &material.emissive_texture,      &material.specular_texture,
          &material.specular_color_texture};
}

class Rasterizer final : public Renderer {
 public:
  Rasterizer(const Scene& scene, const RenderOptions& options);

  using Renderer::render;
  RenderedFrame render(const Capture& capture) const override;

 private:
  std::string fragment_shader(const GlMesh& mesh) const;
  void set_view(const GlProgram& program, const Camera& camera, const Pass& pass) const;
  void set_lights(const GlProgram& program, const Camera& camera) const;
  void set_textures(const GlProgram& program, const GlMesh& mesh) const;
  void set_material(const GlProgram& program, const GlMesh& mesh, double threshold) const;
  void set_mesh(const GlProgram& program, const GlMesh& mesh, const Camera& camera) const;
  std::vector<std::size_t> nearest_first(const Camera& camera) const;
  void draw(const Camera& camera, const Pass& pass) const;
  void draw_color(const Camera& camera, RenderedFrame& frame) const;
  void read_surface(RenderedFrame& frame) const;
  void read_ids(RenderedFrame& frame) const;

  WorldGeometry world_;
  RenderMode mode_;
  int anisotropy_;
  AmbientLight ambient_;
  std::vector<PlacedLight> lights_;
  std::vector<PixelCell> cells_;
  float log2_cell_width_;  ///< px
  std::unique_ptr<GlContext> context_;
  GlFunctions gl_;
  GlScene drawn_;
  std::map<std::string, std::unique_ptr<GlProgram>>
      programs_;  ///< programs by fragment shader source
  std::vector<const GlProgram*> program_of_mesh_;
  std::unique_ptr<GlTarget> target_;
  mutable std::mutex mutex_;  ///< guards the context
};

Rasterizer::Rasterizer(const Scene& scene, const RenderOptions& options)
    : world_(flatten(scene)),
      mode_(options.mode),
      anisotropy_(options.anisotropy),
      ambient_(ambient_light(world_, options.ambient)),
      lights_(place_lights(world_)),
      cells_(grid_of_cells(options.samples_per_edge())),
      log2_cell_width_(-std::log2(static_cast<float>(options.samples_per_edge()))),
      context_(GlContext::make()),
      gl_([this](const char* name) { return context_->find_function(name); }) {
  require_rasterizable(scene);
  const GlContext::Current current(*context_);
  drawn_ = upload(gl_, world_);
  for (const GlMesh& mesh : drawn_.meshes) {
    const std::string shader = fragment_shader(mesh);
    std::unique_ptr<GlProgram>& program = programs_[shader];
    if (program == nullptr) {
      program = std::make_unique<GlProgram>(gl_, kVertexShader, shader);
    }
    program_of_mesh_.push_back(program.get());
  }
  target_ = std::make_unique<GlTarget>(gl_);
}

RenderedFrame Rasterizer::render(const Capture& capture) const {
  capture.camera.validate();
  capture.shutter.validate();
  require_rasterizable(capture.camera, capture.shutter);
  const CameraPose camera_pose = CapturePoses(capture).of_row(0);
  const Camera camera{*capture.camera.pinhole(),
                      camera_pose.R_world_camera.transpose().cast<float>(),
                      (camera_pose.position - world_.origin).cast<float>()};
  RenderedFrame frame = empty_frame(capture.camera, capture.channels);
  const std::lock_guard lock(mutex_);
  const GlContext::Current current(*context_);
  target_->bind({camera.pinhole.width, camera.pinhole.height});
  const bool has_color = capture.channels.color && mode_ != RenderMode::depth;
  if (has_color) {
    draw_color(camera, frame);
    if (capture.infrared) {
      frame.radiance = grey_of(frame.radiance, capture.infrared->scene_light);
    }
  }
  if (capture.channels.depth || capture.channels.normal || capture.channels.ids) {
    const bool was_drawn = has_color && cells_.size() == 1;
    if (!was_drawn) {
      draw(camera, {Eigen::Vector2d::Zero(), std::nullopt});
    }
    read_surface(frame);
    if (capture.channels.ids) {
      read_ids(frame);
    }
  }
  return frame;
}

void Rasterizer::set_lights(const GlProgram& program, const Camera& camera) const {
  std::vector<Eigen::Vector4f> values;
  std::vector<float> cone_widths;
  for (const PlacedLight& light : lights_) {
    const float kind = !light.has_place() ? 0.0F : light.kind == LightKind::spot ? 2.0F : 1.0F;
    const Eigen::Vector3f place = camera.R_camera_world * (light.position - camera.position);
    const Eigen::Vector3f axis = camera.R_camera_world * light.direction;
    values.emplace_back(place.x(), place.y(), place.z(), kind);
    values.emplace_back(axis.x(), axis.y(), axis.z(), light.cos_outer);
    values.emplace_back(light.intensity.x(), light.intensity.y(), light.intensity.z(),
                        light.inverse_range);
    cone_widths.push_back(light.inverse_cone_width);
  }
  program.set("light_count", static_cast<int>(lights_.size()));
  program.set("lights", values);
  for (std::size_t i = 0; i < cone_widths.size(); ++i) {
    program.set("cone_widths[" + std::to_string(i) + "]", cone_widths[i]);
  }
  program.set("ambient_uniform", ambient_.uniform);
  program.set("ambient_sky", ambient_.sky);
  program.set("ambient_axis", Eigen::Vector3f(camera.R_camera_world * ambient_.sky_axis));
}

/// Returns the source of a fragment shader with only what the mesh needs.
std::string Rasterizer::fragment_shader(const GlMesh& mesh) const {
  const Material& material = *mesh.world->material;
  const bool is_solid = material.alpha_mode == AlphaMode::opaque;
  const bool is_lit = !material.unlit && mode_ == RenderMode::direct;
  const bool is_colored = mode_ != RenderMode::depth || !is_solid;
  const std::array slots = texture_slots(material);
  std::string shader = std::string(kVersion) + (is_solid ? kSolid : kHoles) + (is_lit ? kLit : "");
  if (anisotropy_ > 1) {
    shader += kAnisotropy + std::to_string(anisotropy_) + "\n";
  }
  for (std::size_t i = 0; i < kTextureSlots; ++i) {
    const bool is_there = slots[i]->texture != kNone && drawn_.textures[slots[i]->texture] != 0 &&
                          !mesh.world->mesh->texcoords[slots[i]->texcoord_set].empty();
    if (is_there && (i == 0 ? is_colored : is_lit)) {
      shader += kTexture + std::to_string(i) + "\n";
    }
  }
  return shader + kFragmentShader;
}

void Rasterizer::set_textures(const GlProgram& program, const GlMesh& mesh) const {
  const std::array slots = texture_slots(*mesh.world->material);
  std::vector<Eigen::Vector4f> rows;
  for (std::size_t i = 0; i < kTextureSlots; ++i) {
    const TextureSlot& slot = *slots[i];
    gl_.ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + i));
    gl_.BindTexture(GL_TEXTURE_2D, slot.texture == kNone ? 0 : drawn_.textures[slot.texture]);
    for (int row = 0; row < 2; ++row) {
      const Eigen::RowVector3f transform = slot.T_image_texcoord.matrix().row(row);
      rows.emplace_back(transform.x(), transform.y(), transform.z(),
                        static_cast<float>(slot.texcoord_set));
    }
  }
  program.set("texture_rows", rows);
}

void Rasterizer::set_material(const GlProgram& program, const GlMesh& mesh,
                              double threshold) const {
  const Material& material = *mesh.world->material;
  program.set("base_color", material.base_color);
  program.set("factors", Eigen::Vector4f(material.metallic, material.roughness, material.specular,
                                         material.normal_scale));
  program.set("straight",
              Eigen::Vector3f(normal_reflectance(material.ior) * material.specular_color));
  program.set("emission", Eigen::Vector4f(material.emission.x(), material.emission.y(),
                                          material.emission.z(), material.occlusion_strength));
  const float least_alpha = material.alpha_mode == AlphaMode::opaque ? -1.0F
                            : material.alpha_mode == AlphaMode::mask
                                ? material.alpha_cutoff
                                : static_cast<float>(threshold);
  program.set("least_alpha", least_alpha);
}

void Rasterizer::set_view(const GlProgram& program, const Camera& camera, const Pass& pass) const {
  program.set("projection", projection(camera.pinhole, pass.offset));
  program.set("R_camera_world", camera.R_camera_world);
  program.set("eye", camera.position);
  program.set("log2_sample_width", log2_cell_width_);
  for (std::size_t slot = 0; slot < kTextureSlots; ++slot) {
    program.set("textures[" + std::to_string(slot) + "]", static_cast<int>(slot));
  }
  set_lights(program, camera);
}

void Rasterizer::set_mesh(const GlProgram& program, const GlMesh& mesh,
                          const Camera& camera) const {
  const bool rows_grow_down = camera.pinhole.fy > 0;
  program.set("front_is_ccw", rows_grow_down == (mesh.world->side > 0) ? 0.0F : 1.0F);
  program.set("has_normals", mesh.world->has_normals() ? 1.0F : 0.0F);
  program.set("has_tangents", mesh.world->mesh->tangents.empty() ? 0.0F : 1.0F);
  program.set("R_world_mesh", Eigen::Matrix3f(mesh.world->T_world_mesh.linear().cast<float>()));
  program.set("tangent_side", mesh.world->side);
  program.set("is_shared", mesh.world->shared == kNone ? 0.0F : 1.0F);
  if (mesh.world->shared != kNone) {
    const Eigen::Affine3d T = T_flat_shared(world_, *mesh.world);
    program.set("shared_place", Eigen::Vector3f(T.translation().cast<float>()));
    program.set("normal_axes", Eigen::Matrix3f(cofactors(T.linear()).cast<float>()));
  }
}

/// Returns mesh indices by distance from the camera, as hidden fragments need not be shaded.
std::vector<std::size_t> Rasterizer::nearest_first(const Camera& camera) const {
  std::vector<float> distances2;
  for (const GlMesh& mesh : drawn_.meshes) {
    distances2.push_back(mesh.bounds.squaredExteriorDistance(camera.position));
  }
  std::vector<std::size_t> order(distances2.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distances2[a] < distances2[b]; });
  return order;
}

void Rasterizer::draw(const Camera& camera, const Pass& pass) const {
  target_->clear();
  gl_.VertexAttrib4f(kColorAttribute, 1, 1, 1, 1);
  for (const auto& [shader, program] : programs_) {
    program->use();
    set_view(*program, camera, pass);
  }
  for (const std::size_t i : nearest_first(camera)) {
    const GlMesh& mesh = drawn_.meshes[i];
    const GlProgram& program = *program_of_mesh_[i];
    program.use();
    set_textures(program, mesh);
    set_material(program, mesh, pass.threshold(i));
    set_mesh(program, mesh, camera);
    program.set("mesh_number", static_cast<int>(i) + 1);
    gl_.BindVertexArray(mesh.vertices);
    gl_.DrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
  }
}

/// Draws colour as the mean of one pass for each cell of a pixel.
void Rasterizer::draw_color(const Camera& camera, RenderedFrame& frame) const {
  const auto count = static_cast<double>(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    draw(camera,
         {cells_[i].offset,
          count > 1 ? std::optional((static_cast<double>(i) + 0.5) / count) : std::nullopt});
    const cv::Mat_<cv::Vec4f>& drawn = target_->read_color();
    std::transform(frame.radiance.begin(), frame.radiance.end(), drawn.begin(),
                   frame.radiance.begin(), [](const cv::Vec3f& sum, const cv::Vec4f& color) {
                     return sum + cv::Vec3f(color[0], color[1], color[2]);
                   });
  }
  frame.radiance *= 1 / count;
}

/// Reads depth and normals of the last pass, which was drawn through the pixels' centres.
void Rasterizer::read_surface(RenderedFrame& frame) const {
  const cv::Mat_<cv::Vec4f>& drawn = target_->read_surface();
  if (!frame.depth.empty()) {
    std::transform(drawn.begin(), drawn.end(), frame.depth.begin(),
                   [](const cv::Vec4f& texel) { return texel[3]; });
  }
  if (!frame.normal.empty()) {
    std::transform(drawn.begin(), drawn.end(), frame.normal.begin(),
                   [](const cv::Vec4f& texel) { return cv::Vec3f(texel[0], texel[1], texel[2]); });
  }
}

/// Reads instance and material ids of the last pass, drawn through the pixels' centres.
void Rasterizer::read_ids(RenderedFrame& frame) const {
  const SurfaceIds ids = surface_ids(world_);
  const cv::Mat_<std::int32_t>& drawn = target_->read_meshes();
  const auto id_at = [](std::int32_t mesh_number, const std::vector<std::uint16_t>& id_of_mesh) {
    return mesh_number == 0 ? std::uint16_t{0}
                            : id_of_mesh[static_cast<std::size_t>(mesh_number - 1)];
  };
  std::transform(drawn.begin(), drawn.end(), frame.instance.begin(),
                 [&](std::int32_t number) { return id_at(number, ids.instance); });
  std::transform(drawn.begin(), drawn.end(), frame.material.begin(),
                 [&](std::int32_t number) { return id_at(number, ids.material); });
}

}  // namespace

void require_rasterizable(const Scene& scene) {
  vo::require(scene.environment.empty(),
              "rasterizer: cannot draw an environment, expected render.kind = ray_tracer");
  vo::require(scene.lights.size() <= kMaxLights, "rasterizer: the scene has ", scene.lights.size(),
              " lights, expected at most ", kMaxLights, " or render.kind = ray_tracer");
}

void require_rasterizable(const vo::CameraModel& camera, const Shutter& shutter) {
  vo::require(camera.pinhole_for("rasterizer").distortion.is_zero(),
              "rasterizer: cannot draw through a lens that distorts, expected a camera without "
              "distortion or render.kind = ray_tracer");
  vo::require(shutter.exposure_time == 0 && shutter.readout_time == 0,
              "rasterizer: cannot draw motion blur or a rolling shutter, expected "
              "exposure_time and readout_time 0 or render.kind = ray_tracer");
}

std::unique_ptr<Renderer> make_rasterizer(const Scene& scene, const RenderOptions& options) {
  return std::make_unique<Rasterizer>(scene, options);
}

}  // namespace synth
