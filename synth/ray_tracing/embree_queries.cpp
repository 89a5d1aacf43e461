#include "synth/ray_tracing/embree_queries.h"

namespace synth {

#if EDVO_EMBREE_VERSION >= 4

namespace {

RTCRayQueryFlags flags_of(Coherence coherence) {
  return coherence == Coherence::coherent ? RTC_RAY_QUERY_FLAG_COHERENT
                                          : RTC_RAY_QUERY_FLAG_INCOHERENT;
}

RTCIntersectArguments intersect_arguments(EmbreeContext& context, Coherence coherence) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.flags = flags_of(coherence);
  return arguments;
}

RTCOccludedArguments occlude_arguments(EmbreeContext& context, Coherence coherence) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  arguments.flags = flags_of(coherence);
  return arguments;
}

}  // namespace

EmbreeContext embree_context() {
  EmbreeContext context;
  rtcInitRayQueryContext(&context);
  return context;
}

void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      const int* active, RTCRayHit16& rays) {
  RTCIntersectArguments arguments = intersect_arguments(context, coherence);
  rtcIntersect16(active, scene, &rays, &arguments);
}

void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence, const int* active,
                    RTCRay16& rays) {
  RTCOccludedArguments arguments = occlude_arguments(context, coherence);
  rtcOccluded16(active, scene, &rays, &arguments);
}

void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      std::vector<RTCRayHit>& rays) {
  RTCIntersectArguments arguments = intersect_arguments(context, coherence);
  for (RTCRayHit& ray : rays) {
    rtcIntersect1(scene, &ray, &arguments);
  }
}

void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence,
                    std::vector<RTCRay>& rays) {
  RTCOccludedArguments arguments = occlude_arguments(context, coherence);
  for (RTCRay& ray : rays) {
    rtcOccluded1(scene, &ray, &arguments);
  }
}

#else

namespace {

void set_coherence(EmbreeContext& context, Coherence coherence) {
  context.flags = coherence == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                   : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
}

}  // namespace

EmbreeContext embree_context() {
  EmbreeContext context;
  rtcInitIntersectContext(&context);
  return context;
}

void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      const int* active, RTCRayHit16& rays) {
  set_coherence(context, coherence);
  rtcIntersect16(active, scene, &context, &rays);
}

void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence, const int* active,
                    RTCRay16& rays) {
  set_coherence(context, coherence);
  rtcOccluded16(active, scene, &context, &rays);
}

void embree_intersect(RTCScene scene, EmbreeContext& context, Coherence coherence,
                      std::vector<RTCRayHit>& rays) {
  set_coherence(context, coherence);
  rtcIntersect1M(scene, &context, rays.data(), static_cast<unsigned>(rays.size()),
                 sizeof(RTCRayHit));
}

void embree_occlude(RTCScene scene, EmbreeContext& context, Coherence coherence,
                    std::vector<RTCRay>& rays) {
  set_coherence(context, coherence);
  rtcOccluded1M(scene, &context, rays.data(), static_cast<unsigned>(rays.size()), sizeof(RTCRay));
}

#endif

}  // namespace synth
