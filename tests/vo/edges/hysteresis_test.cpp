#include "vo/edges/hysteresis.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/hash.h"

namespace {

enum PixelClass : uchar { no_edge, weak_edge, strong_edge };

/// Some share of the pixels weak, fewer strong.
vo::ByteImage random_classes(cv::Size size, double edges, double strong, std::uint64_t seed) {
  vo::ByteImage classes(size);
  for (int i = 0; i < size.area(); ++i) {
    const double value = vo::random_uniform({seed, static_cast<std::uint64_t>(i)});
    classes(i / size.width, i % size.width) = value < strong  ? strong_edge
                                              : value < edges ? weak_edge
                                                              : no_edge;
  }
  return classes;
}

/// One path of weak pixels that winds from the middle outwards; its first pixel is strong.
vo::ByteImage spiral(int size) {
  vo::ByteImage classes(size, size, uchar{no_edge});
  cv::Point at(size / 2, size / 2);
  cv::Point step(1, 0);
  const auto is_inside = [&](cv::Point p) { return cv::Rect(0, 0, size, size).contains(p); };
  for (int length = 2; is_inside(at); length += 2) {
    for (int turn = 0; turn < 2; ++turn, step = {-step.y, step.x}) {
      for (int i = 0; i < length && is_inside(at); ++i, at += step) {
        classes(at) = weak_edge;
      }
    }
  }
  classes(size / 2, size / 2) = strong_edge;
  return classes;
}

/// By the definition: neighbours of strong pixels, until there are none that are weak.
vo::EdgeMask flooded(vo::ByteImage classes) {
  std::vector<cv::Point> strong;
  for (int i = 0; i < static_cast<int>(classes.total()); ++i) {
    if (const cv::Point at(i % classes.cols, i / classes.cols); classes(at) == strong_edge) {
      strong.push_back(at);
    }
  }
  while (!strong.empty()) {
    const cv::Point at = strong.back();
    strong.pop_back();
    for (int v = std::max(0, at.y - 1); v <= std::min(classes.rows - 1, at.y + 1); ++v) {
      for (int u = std::max(0, at.x - 1); u <= std::min(classes.cols - 1, at.x + 1); ++u) {
        if (classes(v, u) == weak_edge) {
          classes(v, u) = strong_edge;
          strong.emplace_back(u, v);
        }
      }
    }
  }
  cv::Mat mask = classes == strong_edge;
  return mask;
}

vo::EdgeMask followed(const vo::ByteImage& classes) {
  vo::Hysteresis hysteresis;
  hysteresis.reset({300, 300});  // what it was used for before is forgotten
  hysteresis.set(1, 1, {~std::uint64_t{0}, ~std::uint64_t{0}});
  hysteresis.reset(classes.size());
  constexpr int kWord = 64;
  for (int v = 0; v < classes.rows; ++v) {
    for (int first = 0; first < classes.cols; first += kWord) {
      vo::EdgeWord word;
      for (int u = first; u < std::min(first + kWord, classes.cols); ++u) {
        const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(u - first);
        word.edges |= classes(v, u) != no_edge ? bit : 0;
        word.strong |= classes(v, u) == strong_edge ? bit : 0;
      }
      hysteresis.set(v, first / kWord, word);
    }
  }
  hysteresis.follow();
  vo::EdgeMask mask(classes.size());
  hysteresis.write_strong(mask);
  return mask;
}

TEST(Hysteresis, FollowsWhatAFloodReaches) {
  for (const cv::Size size : {cv::Size(200, 40), {64, 30}, {65, 30}, {130, 1}, {1, 50}, {1, 1}}) {
    for (const double edges : {0.1, 0.3, 0.45, 0.8, 1.0}) {
      const vo::ByteImage classes =
          random_classes(size, edges, edges / 30, static_cast<std::uint64_t>(size.area()));
      EXPECT_EQ(cv::norm(followed(classes), flooded(classes), cv::NORM_INF), 0)
          << size << ' ' << edges;
    }
  }
}

TEST(Hysteresis, FollowsAPathToItsEndHoweverItWinds) {
  const vo::ByteImage classes = spiral(150);
  const vo::EdgeMask found = followed(classes);
  EXPECT_GT(cv::countNonZero(found), 150 * 150 / 3);
  EXPECT_EQ(cv::countNonZero(found), cv::countNonZero(classes));
}

}  // namespace
