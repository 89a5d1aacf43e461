#pragma once

#include <string>

#include "tests/support/program_test.h"

namespace support {

/// A sweep of two scenarios with two values of one option and two of another, each with two seeds:
/// 16 trials.
class SweepMatrix : public ProgramTest {
 protected:
  SweepMatrix() {
    write_scenario("a", "0.5\n[sensor]\npreset = \"kinect-v1\"");
    write_scenario("b", "0.5");
  }

  std::string matrix() const {
    return path("scenarios") +
           " --set 'sensor.noise.full_well=[6000,6000,6000],[900,900,900]' "
           "--set odometry.preset=paper,default --seeds 2 --cache " +
           path("cache");
  }
};

}  // namespace support
