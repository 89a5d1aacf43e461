#include "vo/core/instruction_set.h"

namespace vo {

InstructionSet available_instruction_set() {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2") > 0 &&
                           __builtin_cpu_supports("fma") > 0 && __builtin_cpu_supports("bmi2") > 0;
  static const bool avx512 =
      __builtin_cpu_supports("avx512f") > 0 && __builtin_cpu_supports("avx512bw") > 0 &&
      __builtin_cpu_supports("avx512cd") > 0 && __builtin_cpu_supports("avx512dq") > 0 &&
      __builtin_cpu_supports("avx512vl") > 0;
  static const InstructionSet set = avx2 && avx512 ? InstructionSet::avx512
                                    : avx2         ? InstructionSet::avx2
                                                   : InstructionSet::baseline;
  return set;
#else
  return InstructionSet::baseline;
#endif
}

}  // namespace vo
