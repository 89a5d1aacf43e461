#include "tools/cli/topic_arguments.h"

namespace tools {

void add_topic_options(CLI::App& command, vo::SequenceTopics& topics) {
  command.add_option("--rgb-topic", topics.image,
                     "images of a recording (MCAP, bag), where several topics have some");
  command.add_option("--depth-topic", topics.depth,
                     "depth of a recording, registered to the images");
  command.add_option("--camera-topic", topics.camera, "CameraInfo of a recording's images");
  command.add_option("--truth-topic", topics.truth,
                     "poses of a recording's camera; /tf:PARENT.CHILD are those of frames in /tf");
}

}  // namespace tools
