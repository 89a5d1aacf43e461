#pragma once

#include <cmath>

namespace vo {

/// The first and second moments of pairs of intensities: a point's own, and the image's there.
struct IntensityMoments {
  double n = 0;
  double ref = 0;
  double cur = 0;
  double ref_ref = 0;
  double cur_cur = 0;
  double ref_cur = 0;

  void add(double r, double c) {
    n += 1;
    ref += r;
    cur += c;
    ref_ref += r * r;
    cur_cur += c * c;
    ref_cur += r * c;
  }

  void add(const IntensityMoments& other) {
    n += other.n;
    ref += other.ref;
    cur += other.cur;
    ref_ref += other.ref_ref;
    cur_cur += other.cur_cur;
    ref_cur += other.ref_cur;
  }

  double ref_variance() const { return n * ref_ref - ref * ref; }  ///< n^2 times the variance
  double cur_variance() const { return n * cur_cur - cur * cur; }  ///< n^2 times the variance

  /// Returns Pearson's correlation, or 0 without contrast.
  double correlation() const {
    const double variances = ref_variance() * cur_variance();
    return variances > 0 ? (n * ref_cur - ref * cur) / std::sqrt(variances) : 0;
  }
};

}  // namespace vo
