#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"
#include "tests/support/sequence_layouts.h"
#include "vo/dataset/sequence.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using nlohmann::json;
using support::ProgramResult;
using support::run_program;

/// The greatest distance between positions of two trajectories, m; infinite if their lengths
/// differ.
double greatest_distance(const vo::Trajectory& a, const vo::Trajectory& b) {
  double greatest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    greatest = std::max(
        greatest, (a[i].T_world_camera.translation() - b[i].T_world_camera.translation()).norm());
  }
  return greatest;
}

/// One rendered sequence in each layout that is read and not written.
class Layouts : public support::ProgramTest {
 protected:
  Layouts() {
    support::write_seven_scenes(file("7-scenes"), source);
    support::write_scannet(file("scannet"), source);
    support::write_open3d(file("open3d"), source);
    support::write_tartanair(file("tartanair"), source);
  }

  /// The poses of a sequence as it is tracked.
  vo::Trajectory tracked(const std::string& sequence) const {
    const ProgramResult result =
        run_program("track " + path(sequence) + " --preset paper --quiet --force --out " +
                    path(sequence + ".txt"));
    EXPECT_EQ(result.exit_code, 0) << sequence << ": " << result.err;
    return result.exit_code == 0 ? vo::read_trajectory(file(sequence + ".txt")) : vo::Trajectory();
  }

  vo::SequenceSource source = support::rendered_sequence(6);
};

TEST_F(Layouts, EachIsTrackedAlike) {
  const vo::SequenceLayout layout{.camera = source.camera};
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    vo::write_files(file("tum"), vo::encode_frame(layout, i, source.read(i)));
  }
  vo::write_files(file("tum"), vo::encode_lists(layout, source.truth));
  const vo::Trajectory expected = tracked("tum");
  ASSERT_EQ(expected.size(), source.truth.size());
  for (const std::string name : {"7-scenes", "scannet", "open3d"}) {
    EXPECT_EQ(greatest_distance(tracked(name), expected), 0) << name << " holds the same pixels";
  }
  EXPECT_LT(greatest_distance(tracked("tartanair"), expected), 2e-4) << "m; depth is not rounded";
}

TEST_F(Layouts, EachIsConvertedWithItsPoses) {
  for (const std::string layout : {"7-scenes", "scannet", "open3d", "tartanair"}) {
    const std::string tum = layout + "_tum";
    const ProgramResult converted =
        run_program("convert " + path(layout) + " " + path(tum) + " --format tum --json");
    ASSERT_EQ(converted.exit_code, 0) << converted.err;
    EXPECT_EQ(json::parse(converted.out)["from"], layout);
    EXPECT_EQ(json::parse(converted.out)["frames"], 6);
    EXPECT_LT(greatest_distance(vo::read_trajectory(file(tum + "/groundtruth.txt")), source.truth),
              1e-8);
    EXPECT_LT(greatest_distance(tracked(tum), tracked(layout)), 1e-4) << layout;
  }
}

TEST_F(Layouts, TheShareOfTrackedFramesIsKnownOfEach) {
  for (const std::string layout : {"7-scenes", "scannet", "open3d", "tartanair"}) {
    tracked(layout);
    const std::string estimate = path(layout + ".txt");
    const ProgramResult result = run_program("evaluate " + estimate + " " + estimate +
                                             " --json --quiet --sequence " + path(layout));
    ASSERT_EQ(result.exit_code, 0) << layout << ": " << result.err;
    EXPECT_EQ(json::parse(result.out)["tracked_fraction"], 1.0) << layout;
  }
}

TEST_F(Layouts, AFormatThatIsNotWrittenIsNamed) {
  const ProgramResult result =
      run_program("convert " + path("scannet") + " " + path("o") + " --format 7-scenes");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, testing::HasSubstr("expected one of tum, euroc, icl-nuim, icl-tum"));
}

}  // namespace
