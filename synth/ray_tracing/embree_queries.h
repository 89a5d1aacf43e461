#pragma once

#include <vector>

#if EDVO_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/// Embree's queries under the same names for its versions 3, which Debian 12 has, and 4, which
/// Debian 13 has.
namespace synth {

/// Says whether the rays of a query take similar ways, which Embree may make use of.
enum class Coherence { coherent, incoherent };

#if EDVO_EMBREE_VERSION >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

/// Returns the context of a query, which Embree passes to the filter functions.
EmbreeContext embree_context();

/// Finds the nearest hit of each active ray, -1 in `active`, of a packet.
void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      const int* active, RTCRayHit16& rays);

/// Sets tfar to minus infinity for each active ray of a packet that anything stops.
void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence, const int* active,
                    RTCRay16& rays);

/// Finds the nearest hit of each ray.
void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      std::vector<RTCRayHit>& rays);

/// Sets tfar to minus infinity for each ray that anything stops.
void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence,
                    std::vector<RTCRay>& rays);

}  // namespace synth
