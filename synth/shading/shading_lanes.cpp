#include "synth/shading/shading_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace synth {
namespace {

void put(Lanes3& lanes, std::size_t lane, const Eigen::Vector3f& value) {
  lanes.x[lane] = value.x();
  lanes.y[lane] = value.y();
  lanes.z[lane] = value.z();
}

EDVO_INLINE float dot(const Lanes3& a, const Lanes3& b, std::size_t lane) {
  return a.x[lane] * b.x[lane] + a.y[lane] * b.y[lane] + a.z[lane] * b.z[lane];
}

EDVO_INLINE void find_light(const PlacedLight& light, const Lanes3& places, const LitLanes& lit,
                            LightLanes& result) {
  if (light.has_place()) {
    for (std::size_t i = 0; i < kPacketSize; ++i) {
      const float x = places.x[i] - lit.position.x[i];
      const float y = places.y[i] - lit.position.y[i];
      const float z = places.z[i] - lit.position.z[i];
      result.to_light.x[i] = x;
      result.to_light.y[i] = y;
      result.to_light.z[i] = z;
    }
  } else {
    result.to_light.x.fill(-light.direction.x());
    result.to_light.y.fill(-light.direction.y());
    result.to_light.z.fill(-light.direction.z());
  }
  Lanes share;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    const float along_normal = dot(result.to_light, lit.normal, i);
    const float along_face = dot(result.to_light, lit.face_normal, i);
    share[i] = std::min(along_normal, along_face) > 0 ? along_normal : 0;
  }
  if (light.has_place()) {
    for (std::size_t i = 0; i < kPacketSize; ++i) {
      const float along_axis = -(light.direction.x() * result.to_light.x[i] +
                                 light.direction.y() * result.to_light.y[i] +
                                 light.direction.z() * result.to_light.z[i]);
      share[i] *= fading(light, along_axis, dot(result.to_light, result.to_light, i));
    }
  }
  std::fill(share.begin() + lit.size, share.end(), 0.0F);
  result.share = share;
}

/// Returns the cosine between the normal and the direction halfway between light and viewer.
EDVO_INLINE float halfway_cosine(const LightLanes& light, const LitLanes& lit, float per_length,
                                 std::size_t i) {
  const float x = light.to_light.x[i] * per_length + lit.to_viewer.x[i];
  const float y = light.to_light.y[i] * per_length + lit.to_viewer.y[i];
  const float z = light.to_light.z[i] * per_length + lit.to_viewer.z[i];
  const float along = x * lit.normal.x[i] + y * lit.normal.y[i] + z * lit.normal.z[i];
  return along / std::sqrt(x * x + y * y + z * z);
}

EDVO_INLINE void reflect(const LitLanes& lit, const LightLanes& light,
                         const Eigen::Vector3f& intensity, Lanes3& radiance) {
  Lanes tint;
  Lanes3 gloss;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    const float distance2 = dot(light.to_light, light.to_light, i);
    const float per_length = 1 / std::sqrt(distance2);
    const Reflectance reflected = reflectance(
        {lit.metallic[i],
         lit.specular[i],
         lit.alpha2[i],
         {lit.normal_reflectance.x[i], lit.normal_reflectance.y[i], lit.normal_reflectance.z[i]}},
        {.n_l = dot(light.to_light, lit.normal, i) * per_length,
         .n_v = dot(lit.to_viewer, lit.normal, i),
         .l_v = dot(light.to_light, lit.to_viewer, i) * per_length,
         .n_h = halfway_cosine(light, lit, per_length, i)});
    tint[i] = light.share[i] > 0 ? light.share[i] * reflected.tint : 0;
    gloss.x[i] = light.share[i] > 0 ? light.share[i] * reflected.gloss[0] : 0;
    gloss.y[i] = light.share[i] > 0 ? light.share[i] * reflected.gloss[1] : 0;
    gloss.z[i] = light.share[i] > 0 ? light.share[i] * reflected.gloss[2] : 0;
  }
  const auto add = [&](const Lanes& base, const Lanes& highlight, float strength, Lanes& sum) {
    for (std::size_t i = 0; i < kPacketSize; ++i) {
      sum[i] += (base[i] * tint[i] + highlight[i]) * strength;
    }
  };
  add(lit.base_color.x, gloss.x, intensity.x(), radiance.x);
  add(lit.base_color.y, gloss.y, intensity.y(), radiance.y);
  add(lit.base_color.z, gloss.z, intensity.z(), radiance.z);
}

EDVO_TARGET_AVX2 void find_light_avx2(const PlacedLight& light, const Lanes3& places,
                                      const LitLanes& lit, LightLanes& result) {
  find_light(light, places, lit, result);
}

EDVO_TARGET_AVX2 void reflect_avx2(const LitLanes& lit, const LightLanes& light,
                                   const Eigen::Vector3f& intensity, Lanes3& radiance) {
  reflect(lit, light, intensity, radiance);
}

}  // namespace

void add_point(LitLanes& lit, const SurfacePoint& point) {
  const auto lane = static_cast<std::size_t>(lit.size++);
  put(lit.position, lane, point.position);
  put(lit.start, lane, point.position + point.rounding * point.face_normal);
  put(lit.face_normal, lane, point.face_normal);
  put(lit.normal, lane, point.normal);
  put(lit.to_viewer, lane, point.to_viewer);
  put(lit.base_color, lane, point.base_color);
  lit.scene_share[lane] = point.share;
  const SurfaceFinish finish = finish_of(point);
  lit.metallic[lane] = finish.metallic;
  lit.specular[lane] = finish.specular;
  lit.alpha2[lane] = finish.alpha2;
  put(lit.normal_reflectance, lane, point.normal_reflectance);
}

Lanes3 same_place(const PlacedLight& light) {
  Lanes3 places;
  places.x.fill(light.position.x());
  places.y.fill(light.position.y());
  places.z.fill(light.position.z());
  return places;
}

void LightLanes::set(std::size_t lane, const Eigen::Vector3f& to_light_of_lane,
                     float share_of_lane) {
  put(to_light, lane, to_light_of_lane);
  share[lane] = share_of_lane;
}

void LightLanes::keep(const LaneMask& active) {
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    share[i] = active[i] == 0 ? 0 : share[i];
  }
}

LightLanes direct_light(const PlacedLight& light, const Lanes3& places, const LitLanes& lit,
                        vo::InstructionSet set) {
  LightLanes result;
  if (set == vo::InstructionSet::baseline) {
    find_light(light, places, lit, result);
  } else {
    find_light_avx2(light, places, lit, result);
  }
  return result;
}

void add_reflected(const LitLanes& lit, const LightLanes& light, const Eigen::Vector3f& intensity,
                   vo::InstructionSet set, Lanes3& radiance) {
  if (set == vo::InstructionSet::baseline) {
    reflect(lit, light, intensity, radiance);
  } else {
    reflect_avx2(lit, light, intensity, radiance);
  }
}

}  // namespace synth
