#include "vo/core/instruction_set.h"

#include <cstdlib>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace vo {
namespace {

constexpr const char* kVariable = "EDVO_INSTRUCTION_SET";

InstructionSet widest_of_this_machine() {
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") > 0 && __builtin_cpu_supports("fma") > 0 &&
                    __builtin_cpu_supports("bmi2") > 0;
  const bool avx512 =
      __builtin_cpu_supports("avx512f") > 0 && __builtin_cpu_supports("avx512bw") > 0 &&
      __builtin_cpu_supports("avx512cd") > 0 && __builtin_cpu_supports("avx512dq") > 0 &&
      __builtin_cpu_supports("avx512vl") > 0;
  return avx2 && avx512 ? InstructionSet::avx512
         : avx2         ? InstructionSet::avx2
                        : InstructionSet::baseline;
#else
  return InstructionSet::baseline;
#endif
}

InstructionSet named(const char* name) {
  try {
    return parse_enum<InstructionSet>(name);
  } catch (const Error& error) {
    fail_as(ErrorKind::usage, kVariable, ": ", error.what());
  }
}

InstructionSet chosen() {
  const InstructionSet widest = widest_of_this_machine();
  const char* name = std::getenv(kVariable);  // NOLINT(concurrency-mt-unsafe): nothing sets it
  if (name == nullptr) {
    return widest;
  }
  const InstructionSet wanted = named(name);
  if (wanted > widest) {
    fail_as(ErrorKind::usage, kVariable, ": this machine has no ", name, ", expected at most ",
            to_string(widest));
  }
  return wanted;
}

}  // namespace

InstructionSet available_instruction_set() {
  static const InstructionSet set = chosen();
  return set;
}

}  // namespace vo
