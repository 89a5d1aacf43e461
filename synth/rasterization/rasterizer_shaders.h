#pragma once

namespace synth {

/// Transforms vertices to camera axes, m from the eye, and clip space: rows from the top, so that
/// reading back needs no flip; depth = near / z, reversed, for a float's precision at any distance.
inline constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texcoord_0;
layout(location = 3) in vec2 texcoord_1;
layout(location = 4) in vec4 color;
layout(location = 5) in vec4 tangent;
uniform mat4 projection;
uniform mat3 R_camera_world;
uniform mat3 R_world_mesh;  // of tangents: any scale
uniform float is_shared;  // positions and normals are the mesh's, not the world's
uniform vec3 shared_place;
uniform mat3 normal_axes;  // any scale
uniform vec3 eye;
uniform float tangent_side;  // -1 where the mesh is mirrored
out vec3 p_camera;
out vec3 vertex_normal;
out vec2 uv_0;
out vec2 uv_1;
out vec4 vertex_color;
out vec4 vertex_tangent;
void main() {
  vec3 p_world = is_shared > 0 ? R_world_mesh * position + shared_place : position;
  vec3 normal_world = is_shared > 0 ? normalize(normal_axes * normal) : normal;
  p_camera = R_camera_world * (p_world - eye);
  vertex_normal = R_camera_world * normal_world;
  uv_0 = texcoord_0;
  uv_1 = texcoord_1;
  vertex_color = color;
  vertex_tangent = vec4(R_camera_world * (R_world_mesh * tangent.xyz), tangent_side * tangent.w);
  gl_Position = projection * vec4(p_camera, 1);
}
)";

/// Begins a fragment shader. Only what a material needs follows, as llvmpipe evaluates both sides
/// of a branch: kHoles or kSolid (surfaces without holes need not be shaded where they are hidden),
/// kLit, kAnisotropy, and kTexture for each texture slot in use.
inline constexpr const char* kVersion = "#version 450 core\n";
inline constexpr const char* kSolid = "layout(early_fragment_tests) in;\n";
inline constexpr const char* kHoles = "#define HAS_HOLES\n";
inline constexpr const char* kLit = "#define IS_LIT\n";
inline constexpr const char* kAnisotropy = "#define ANISOTROPY ";  // followed by its number
inline constexpr const char* kTexture = "#define HAS_TEXTURE_";    // followed by the slot's number

/// Shades as surface.cpp and shading.cpp do, with face normals from screen-space derivatives. The
/// texture slots: 0 base colour, 1 metallic-roughness, 2 normal, 3 occlusion, 4 emission, 5
/// specular, 6 its colour.
inline constexpr const char* kFragmentShader = R"(
in vec3 p_camera;
in vec3 vertex_normal;
in vec2 uv_0;
in vec2 uv_1;
in vec4 vertex_color;
in vec4 vertex_tangent;
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec4 out_surface;  // normal of the triangle, depth
layout(location = 2) out int out_mesh;

const float kPi = 3.14159265358979;
const int kMaxLights = 64;
uniform sampler2D textures[7];
uniform vec4 texture_rows[14];  // two of T_image_texcoord each, and then the coordinates' set
uniform vec4 base_color;
uniform vec4 factors;     // metallic, roughness, specular, normal scale
uniform vec3 straight;    // share of light along the normal that a dielectric reflects, or more
uniform vec4 emission;    // and occlusion strength
uniform float least_alpha;  // less is not there
uniform float log2_sample_width;  // of a colour sample, px
uniform float front_is_ccw;  // in clip space
uniform int mesh_number;  // from 1
uniform float has_normals;
uniform float has_tangents;
uniform vec4 lights[kMaxLights * 3];  // position, kind; direction, cos_outer; intensity, 1 / range
uniform float cone_widths[kMaxLights];
uniform int light_count;
uniform vec3 ambient_uniform;
uniform vec3 ambient_sky;
uniform vec3 ambient_axis;

vec2 uv_of(int slot) {
  vec4 x = texture_rows[2 * slot];
  vec4 y = texture_rows[2 * slot + 1];
  vec3 uv = vec3(x.w > 0.5 ? uv_1 : uv_0, 1);
  return vec2(dot(x.xyz, uv), dot(y.xyz, uv));
}

// The ray tracer's level of detail: a texel as wide as the sample's cone, for an even mapping.
float lod_of(int slot, vec2 uv, float cosine) {
  vec2 a = dFdx(uv);
  vec2 b = dFdy(uv);
  vec2 size = vec2(textureSize(textures[slot], 0));
  float texels = abs(a.x * b.y - a.y * b.x) * size.x * size.y;
  return 0.5 * log2(max(texels, 1e-30) / max(cosine, 0.05)) + log2_sample_width;
}

#ifdef ANISOTROPY
// The mean along the longer axis of the sample's footprint, as texture_patch.cpp has it.
vec4 texel(int slot, float cosine) {
  vec2 uv = uv_of(slot);
  vec2 size = vec2(textureSize(textures[slot], 0)) * exp2(log2_sample_width);
  vec2 a = dFdx(uv) * size;
  vec2 b = dFdy(uv) * size;
  float middle = 0.5 * (dot(a, a) + dot(b, b));
  float half_difference = 0.5 * (a.x * a.x + b.x * b.x) - 0.5 * (a.y * a.y + b.y * b.y);
  float xy = a.x * a.y + b.x * b.y;
  float root = length(vec2(half_difference, xy));
  vec2 axis = half_difference >= 0 ? vec2(half_difference + root, xy)
                                   : vec2(xy, root - half_difference);
  float longer = sqrt(middle + root);
  float shorter = sqrt(max(middle - root, 0));
  axis = root > 0 ? axis * (longer / length(axis)) : vec2(longer, 0);
  float count = clamp(ceil(longer / max(shorter, 1e-12)), 1, ANISOTROPY);
  float lod = log2(max(longer / count, 1e-12));
  vec2 along = axis / vec2(textureSize(textures[slot], 0));
  vec4 sum = vec4(0);
  for (float i = 0; i < count; ++i) {
    sum += textureLod(textures[slot], uv + ((i + 0.5) / count - 0.5) * along, lod);
  }
  return sum / count;
}
#else
vec4 texel(int slot, float cosine) {
  vec2 uv = uv_of(slot);
  float lod = lod_of(slot, uv, cosine);
  return textureLod(textures[slot], uv, lod);
}
#endif

#ifdef IS_LIT
vec3 mapped_normal(vec3 n, vec3 front, float cosine) {
  vec2 uv = uv_of(2);
  vec3 t = vertex_tangent.xyz;
  float side = vertex_tangent.w;
  if (has_tangents < 0.5) {
    vec2 a = dFdx(uv);
    vec2 b = dFdy(uv);
    float s = a.x * b.y - a.y * b.x < 0 ? -1 : 1;
    vec3 p_a = dFdx(p_camera);
    vec3 p_b = dFdy(p_camera);
    t = (p_a * b.y - p_b * a.y) * s;
    vec3 v = (p_b * a.x - p_a * b.x) * s;
    side = dot(cross(front, t), -v) < 0 ? -1 : 1;
  }
  t -= n * dot(n, t);
  float size = length(t);
  if (!(size > 0)) return n;
  t /= size;
  vec3 b = side * cross(n, t);
  vec3 c = 2 * texel(2, cosine).xyz - 1;
  return normalize(t * (factors.w * c.x) + b * (factors.w * c.y) + n * c.z);
}

// What a surface point reflects with: base colour; metallic, roughness, specular; a dielectric's
// share of light along the normal.
struct Finish {
  vec3 base;
  vec3 surface;
  vec3 straight;
};

vec3 reflectance(Finish finish, vec3 n, vec3 v, vec3 l) {
  vec3 base = finish.base;
  vec3 surface = finish.surface;
  float v_h = sqrt(clamp(0.5 + 0.5 * dot(l, v), 0.0, 1.0));
  float n_h = clamp((dot(n, l) + dot(n, v)) * 0.5 / max(1e-4, v_h), 0.0, 1.0);
  float n_l = max(1e-4, dot(n, l));
  float n_v = max(1e-4, dot(n, v));
  float alpha = max(1e-3, surface.y * surface.y);
  float alpha2 = alpha * alpha;
  float spread = n_h * n_h * (alpha2 - 1) + 1;
  float D = alpha2 / (kPi * spread * spread);
  float V = 0.5 / (n_l * sqrt(n_v * n_v * (1 - alpha2) + alpha2) +
                   n_v * sqrt(n_l * n_l * (1 - alpha2) + alpha2));
  float m = 1 - v_h;
  float grazing = m * m * m * m * m;
  vec3 glass = surface.z * (finish.straight + (1 - finish.straight) * grazing);
  vec3 metal = (base + (1 - base) * grazing) * (D * V);
  float passed = 1 - max(glass.r, max(glass.g, glass.b));
  vec3 dielectric = base * (passed / kPi) + glass * D * V;
  return mix(dielectric, metal, surface.x);
}

vec3 light_from(int i, vec3 face, vec3 n, vec3 v, Finish finish) {
  vec4 place = lights[3 * i];
  vec4 axis = lights[3 * i + 1];
  vec4 strength = lights[3 * i + 2];
  vec3 to_light = place.w > 0.5 ? place.xyz - p_camera : -axis.xyz;
  float along = dot(to_light, n);
  if (!(along > 0) || dot(to_light, face) <= 0) return vec3(0);
  vec3 irradiance = strength.xyz * along;
  if (place.w > 0.5) {
    float d2 = dot(to_light, to_light);
    float d = sqrt(d2);
    float fade = d2 * strength.w * strength.w;
    irradiance *= clamp(1 - fade * fade, 0.0, 1.0) / (d2 * d);
    if (place.w > 1.5) {
      float cone = clamp((-dot(axis.xyz, to_light) / d - axis.w) * cone_widths[i], 0.0, 1.0);
      irradiance *= cone * cone;
    }
  }
  return reflectance(finish, n, v, normalize(to_light)) * irradiance;
}

#endif

void main() {
  vec3 v = -normalize(p_camera);
  vec3 face = normalize(cross(dFdx(p_camera), dFdy(p_camera)));
  if (dot(face, v) < 0) face = -face;
  float cosine = dot(face, v);
  vec4 color = base_color * vertex_color;
#ifdef HAS_TEXTURE_0
  color *= texel(0, cosine);
#endif
#ifdef HAS_HOLES
  if (color.a < least_alpha) discard;
#endif
  out_surface = vec4(face, p_camera.z);
  out_mesh = mesh_number;
#ifndef IS_LIT
  out_color = vec4(color.rgb, 1);
#else
  bool is_front = gl_FrontFacing == (front_is_ccw > 0.5);
  vec3 front = is_front ? face : -face;
  vec3 n = has_normals > 0.5 && length(vertex_normal) > 1e-3 ? normalize(vertex_normal) : front;
  if (dot(n, front) < 0) n = -n;
  Finish finish = Finish(color.rgb, factors.xyz, straight);
  vec3 shine = emission.rgb;
  float openness = 1;
#ifdef HAS_TEXTURE_1
  finish.surface.xy *= texel(1, cosine).zy;
#endif
#ifdef HAS_TEXTURE_2
  n = mapped_normal(n, front, cosine);
#endif
#ifdef HAS_TEXTURE_3
  openness += emission.a * (texel(3, cosine).r - 1);
#endif
#ifdef HAS_TEXTURE_4
  shine *= texel(4, cosine).rgb;
#endif
#ifdef HAS_TEXTURE_5
  finish.surface.z *= texel(5, cosine).a;
#endif
#ifdef HAS_TEXTURE_6
  finish.straight *= texel(6, cosine).rgb;
#endif
  finish.straight = min(finish.straight, vec3(1));
  if (!is_front) n = -n;
  vec3 ambient = ambient_uniform + ambient_sky * (0.5 + 0.5 * dot(n, ambient_axis));
  vec3 radiance = shine + openness * color.rgb * ambient / kPi;
  for (int i = 0; i < light_count; ++i) {
    radiance += light_from(i, face, n, v, finish);
  }
  out_color = vec4(radiance, 1);
#endif
}
)";

}  // namespace synth
