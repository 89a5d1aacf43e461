#pragma once

namespace vo {

/// The number of keyframes kept and the choice of those that a frame is aligned to.
struct MapOptions {
  int references = 1;        ///< keyframes that a frame is aligned to at once
  int max_keyframes = 40;    ///< keyframes kept; the oldest is dropped
  double min_overlap = 0.5;  ///< share of a keyframe's points that a reference must see

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, MapOptions& options) {
  visit("references", options.references, "keyframes that a frame is aligned to at once");
  visit("max_keyframes", options.max_keyframes, "kept; the oldest is forgotten");
  visit("min_overlap", options.min_overlap,
        "share of a keyframe's points in view for it to be aligned to");
}

}  // namespace vo
