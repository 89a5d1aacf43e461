#include "vo/sequence_odometry/time_log.h"

#include "vo/core/fields.h"
#include "vo/motion_files/timestamp.h"

namespace vo {

std::string format_time_log(const SequenceResult& result) {
  std::string text = "timestamp,pyramid_ms,edges_ms,alignment_ms,mapping_ms\n";
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const StageTimes& times = result.times[i];
    text += format_timestamp(result.frames[i].timestamp);
    for (const double time :
         {times.pyramid_ms, times.edges_ms, times.alignment_ms, times.mapping_ms}) {
      text += "," + format_real(time);
    }
    text += "\n";
  }
  return text;
}

}  // namespace vo
