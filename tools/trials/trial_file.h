#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/laboratory/results.h"
#include "tools/trials/trial.h"
#include "vo/files/output.h"

namespace tools {

/// What a trial is measured with, by name: a hash of each. Of trials with equal keys, one can stand
/// for the other.
using TrialKey = std::vector<std::pair<std::string, std::string>>;

/// Makes the keys of trials. It holds the hashes that many of them share: of the program, of the
/// tracker with its limits and the files that its command names, and of scenes.
class TrialKeys {
 public:
  explicit TrialKeys(const TrialSettings& settings);

  /// Returns the key of a scenario with a seed. Its bounds and its reason are not in it: they judge
  /// a trial and do not change it. Throws vo::Error naming a file of the scene that is missing.
  TrialKey key(const Scenario& scenario, int seed);

 private:
  const std::string& scene_hash(const std::filesystem::path& gltf);

  std::string tracker_;
  std::string pictures_;
  std::vector<std::pair<std::filesystem::path, std::string>> scenes_;
};

/// A trial in a file: a first line with the schema and a hash of the second, which has key and
/// trial. docs/formats.md describes it.
struct TrialFile {
  TrialKey key;
  TrialResult trial;
};

/// Returns the hashes of the forest models that a scenario names, which its fields do not tell
/// apart; of one that is missing, too. Empty where it names none.
std::string forest_models_hash(const Scenario& scenario);

/// Writes the file of a trial and the folder that it lies in, without a lock (`unlocked_file.h`).
void write_trial(const std::filesystem::path& path, const TrialFile& file,
                 vo::Durability durability);

/// Reads the file of a trial. Throws vo::Error where it is damaged or no such file.
TrialFile read_trial(const std::filesystem::path& path);

/// Returns the name of what the keys disagree on first; empty where they are equal.
std::string difference(const TrialKey& found, const TrialKey& expected);

}  // namespace tools
