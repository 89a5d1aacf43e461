#pragma once

#include <CLI/CLI.hpp>

#include "vo/recordings/sequence_topics.h"

namespace tools {

/// Adds `--rgb-topic`, `--depth-topic`, `--camera-topic` and `--truth-topic`, by which the topics
/// of a sequence in a recording are chosen.
void add_topic_options(CLI::App& command, vo::SequenceTopics& topics);

}  // namespace tools
