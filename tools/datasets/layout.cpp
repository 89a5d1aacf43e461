#include "tools/datasets/layout.h"

#include <algorithm>

#include "vo/files/output.h"
#include "vo/output_folders/staged_folder.h"

namespace tools {
namespace {

/// Returns a number of at least three digits.
std::string three_digits(std::size_t number) {
  constexpr std::size_t kDigits = 3;
  std::string digits = std::to_string(number);
  return digits.insert(0, kDigits - std::min(kDigits, digits.size()), '0');
}

}  // namespace

DatasetLayout::DatasetLayout(const std::filesystem::path& path)
    : out(vo::resolved_output(path)), staging(vo::StagedFolder::staging_of(out)) {}

std::filesystem::path DatasetLayout::part(std::size_t index, const std::string& name) const {
  constexpr std::size_t kInOneFolder = 1000;
  return parts() / three_digits(index / kInOneFolder) / name;
}

std::string part_name(const DatasetSpec& spec, const DatasetPart& part) {
  return spec.sequences.at(part.sequence).name + "-" + three_digits(part.number);
}

std::string scene_folder(const DatasetSequence& sequence) {
  return sequence.split + "/" + sequence.scene + "/";
}

}  // namespace tools
