#include <gtest/gtest.h>

#include "vo/structured_forest/structured_forest.h"
#include "vo/structured_forest/structured_forest_file.h"

#ifdef EDVO_HAS_XIMGPROC
#include <opencv2/ximgproc.hpp>
#endif

namespace {

#ifdef EDVO_HAS_XIMGPROC

/// Colours that change on all scales.
cv::Mat_<cv::Vec3f> test_image(const cv::Size& size) {
  cv::Mat_<cv::Vec3f> image(size, cv::Vec3f(0.5F, 0.5F, 0.5F));
  cv::RNG random(7);
  for (int i = 0; i < 200; ++i) {
    const cv::Rect patch(random.uniform(0, size.width), random.uniform(0, size.height),
                         random.uniform(1, size.width / 2), random.uniform(1, size.height / 2));
    image(patch & cv::Rect({}, size)) = cv::Vec3f(
        random.uniform(0.0F, 1.0F), random.uniform(0.0F, 1.0F), random.uniform(0.0F, 1.0F));
  }
  return image;
}

TEST(StructuredForest, GivesTheEdgeMapOfOpenCv) {
  const std::string model = EDVO_SOURCE_DIR "/assets/edges/structured_forest.yml.gz";
  const vo::StructuredForest ours = vo::read_structured_forest(model);
  const auto theirs = cv::ximgproc::createStructuredEdgeDetection(model);
  for (const cv::Size size : {cv::Size(320, 240), cv::Size(161, 123), cv::Size(62, 47)}) {
    const cv::Mat_<cv::Vec3f> image = test_image(size);
    cv::Mat_<float> expected;
    theirs->detectEdges(image, expected);
    const cv::Mat_<float> strength = ours.edge_strength(image);
    EXPECT_GT(cv::norm(expected, cv::NORM_INF), 0.3);
    // A feature that differs in its last bit may send a patch the other way: 1 in 1000 pixels.
    const cv::Mat difference = cv::abs(expected - strength);
    EXPECT_LE(cv::countNonZero(difference > 1e-5), static_cast<int>(strength.total()) / 1000)
        << size;
  }
}

#else

TEST(StructuredForest, GivesTheEdgeMapOfOpenCv) {
  GTEST_SKIP() << "OpenCV's ximgproc (libopencv-contrib-dev) was not found";
}

#endif

}  // namespace
