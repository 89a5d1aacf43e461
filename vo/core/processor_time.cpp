#include "vo/core/processor_time.h"

#include <ctime>

namespace vo {

double processor_ms() {
  constexpr double kMsPerSecond = 1e3;
  constexpr double kMsPerNanosecond = 1e-6;
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return kMsPerSecond * static_cast<double>(time.tv_sec) +
         kMsPerNanosecond * static_cast<double>(time.tv_nsec);
}

}  // namespace vo
