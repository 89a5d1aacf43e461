#pragma once

#include <array>
#include <utility>

// Innermost loops are written once, as plain loops that the compiler turns into vector
// instructions, inlined (EDVO_INLINE) into one function per instruction set (EDVO_TARGET_...). So
// are the lambdas that they call (EDVO_INLINE_LAMBDA): a call leads to baseline instructions.
#define EDVO_INLINE_LAMBDA __attribute__((always_inline))
#define EDVO_INLINE inline EDVO_INLINE_LAMBDA

#if defined(__x86_64__) && defined(__clang__)
// Clang takes 512-bit registers only where a function asks for them and for no processor by name.
#define EDVO_TARGET_AVX2 __attribute__((target("arch=x86-64-v3")))
#define EDVO_TARGET_AVX512                                                                      \
  __attribute__((target("avx512f,avx512bw,avx512cd,avx512dq,avx512vl,avx2,fma,bmi,bmi2,lzcnt"), \
                 min_vector_width(512)))
#elif defined(__x86_64__)
#define EDVO_TARGET_AVX2 __attribute__((target("arch=x86-64-v3")))
#define EDVO_TARGET_AVX512 __attribute__((target("arch=x86-64-v4,prefer-vector-width=512")))
#else
#define EDVO_TARGET_AVX2
#define EDVO_TARGET_AVX512
#endif

namespace vo {

/// Vector instructions that innermost loops are compiled for. All give bit-identical results: sums
/// are kept in equal lanes, nothing is fused or approximated.
enum class InstructionSet { baseline, avx2, avx512 };

constexpr auto enum_names(InstructionSet) {
  return std::array{std::pair{InstructionSet::baseline, "baseline"},
                    std::pair{InstructionSet::avx2, "avx2"},
                    std::pair{InstructionSet::avx512, "avx512"}};
}

/// The widest vector instructions of this machine, or those that the environment variable
/// EDVO_INSTRUCTION_SET names, if the machine has them. Both are asked once. Throws Error of kind
/// usage for another name, or for instructions that the machine lacks.
InstructionSet available_instruction_set();

/// Returns the one of a function's three versions that is compiled for a set.
template <typename Function>
constexpr Function version_for(InstructionSet set, Function baseline, Function avx2,
                               Function avx512) {
  switch (set) {
    case InstructionSet::baseline:
      return baseline;
    case InstructionSet::avx2:
      return avx2;
    case InstructionSet::avx512:
      return avx512;
  }
  return baseline;
}

}  // namespace vo
