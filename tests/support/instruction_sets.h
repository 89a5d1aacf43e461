#pragma once

#include <vector>

#include "vo/core/instruction_set.h"

namespace support {

inline std::vector<vo::InstructionSet> instruction_sets_of_this_machine() {
  std::vector<vo::InstructionSet> sets{vo::InstructionSet::baseline};
  for (const vo::InstructionSet set : {vo::InstructionSet::avx2, vo::InstructionSet::avx512}) {
    if (vo::available_instruction_set() >= set) {
      sets.push_back(set);
    }
  }
  return sets;
}

}  // namespace support
