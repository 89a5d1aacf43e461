#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/textured_plane.h"
#include "tools/bench/opencv_peer.h"
#include "vo/alignment/align.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/residuals/linearize.h"

namespace {

/// Two frames of the textured plane at 640x480 a few pixels apart, single-threaded.
struct Pair {
  vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(640, 480, 62);
  vo::TrackerOptions options = vo::preset_options(vo::TrackerPreset::paper);
  vo::SE3 T_world_current{Eigen::Quaterniond::Identity(), {0.012, 0.006, 0.01}};
  vo::RgbdFrame first = support::TexturedPlane().render(camera, {});
  vo::RgbdFrame second = support::TexturedPlane().render(camera, T_world_current);

  Pair() { cv::setNumThreads(1); }

  vo::FramePyramid pyramid(const vo::RgbdFrame& frame) const {
    vo::FramePyramid result = vo::build_pyramid(frame, camera, options.pyramid);
    vo::add_edges(result, options.edges);
    return result;
  }
};

void build_pyramid(benchmark::State& state) {
  const Pair pair;
  for (auto _ : state) {
    benchmark::DoNotOptimize(vo::build_pyramid(pair.first, pair.camera, pair.options.pyramid));
  }
}
BENCHMARK(build_pyramid)->Unit(benchmark::kMillisecond);

void detect_edges(benchmark::State& state) {
  const Pair pair;
  const vo::GrayImage gray = vo::to_gray(pair.first.image);
  for (auto _ : state) {
    benchmark::DoNotOptimize(vo::detect_edges(gray, pair.options.edges));
  }
}
BENCHMARK(detect_edges)->Unit(benchmark::kMillisecond);

/// What `detect_edges` cannot be faster than: OpenCV's Canny on bytes with a known threshold.
void opencv_canny(benchmark::State& state) {
  const Pair pair;
  cv::Mat edges;
  for (auto _ : state) {
    cv::Canny(pair.first.image, edges, 50, 100, 3, /*L2gradient=*/true);
    benchmark::DoNotOptimize(edges);
  }
}
BENCHMARK(opencv_canny)->Unit(benchmark::kMillisecond);

void linearize(benchmark::State& state) {
  const Pair pair;
  const vo::FramePyramid current = pair.pyramid(pair.second);
  const vo::EdgePoints points =
      vo::edge_points(pair.pyramid(pair.first), current, pair.options.points);
  const vo::SE3 T_cur_ref = pair.T_world_current.inverse();
  for (auto _ : state) {
    benchmark::DoNotOptimize(vo::linearize({points.levels[0], current.levels[0], T_cur_ref, {}, {}},
                                           pair.options.align,
                                           {pair.options.align.loss_scale, {}}));
  }
  const auto evaluated =
      static_cast<double>(state.iterations()) * static_cast<double>(points.levels[0].size());
  state.counters["points/s"] = benchmark::Counter(evaluated, benchmark::Counter::kIsRate);
}
BENCHMARK(linearize)->Unit(benchmark::kMillisecond);

void align(benchmark::State& state) {
  const Pair pair;
  const vo::FramePyramid current = pair.pyramid(pair.second);
  const vo::EdgePoints points =
      vo::edge_points(pair.pyramid(pair.first), current, pair.options.points);
  for (auto _ : state) {
    benchmark::DoNotOptimize(vo::align(points, current, vo::SE3(), pair.options.align));
  }
}
BENCHMARK(align)->Unit(benchmark::kMillisecond);

/// A whole frame of preset default; the counter says how many times as long OpenCV's dense odometry
/// takes for the same frame in the same run.
void track_beside_opencv(benchmark::State& state) {
  const Pair pair;
  const auto opencv = tools::opencv_peer(tools::OpencvOdometry::rgbd);
  if (!opencv) {
    state.SkipWithError("OpenCV's rgbd module is not built in");
    return;
  }
  const auto options = vo::preset_options(vo::TrackerPreset::best_measured);
  const tools::FrameTracker ours = tools::edvo_peer("default", options).start(pair.camera);
  const tools::FrameTracker theirs = opencv->start(pair.camera);
  double our_ms = 0;
  double their_ms = 0;
  int count = 0;
  for (auto _ : state) {
    const vo::RgbdFrame& frame = count++ % 2 == 0 ? pair.first : pair.second;
    const double ms = ours(frame).cpu_ms;
    our_ms += ms;
    their_ms += theirs(frame).cpu_ms;
    state.SetIterationTime(ms / 1e3);
  }
  state.counters["opencv/edvo"] = their_ms / our_ms;
}
BENCHMARK(track_beside_opencv)->Unit(benchmark::kMillisecond)->UseManualTime();

}  // namespace
