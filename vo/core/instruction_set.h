#pragma once

// Innermost loops are written once, as plain loops that the compiler turns into vector
// instructions, inlined (EDVO_INLINE) into one function per instruction set (EDVO_TARGET_...).
#define EDVO_INLINE inline __attribute__((always_inline))

#if defined(__x86_64__)
#define EDVO_TARGET_AVX2 __attribute__((target("arch=x86-64-v3")))
#define EDVO_TARGET_AVX512 __attribute__((target("arch=x86-64-v4,prefer-vector-width=512")))
#else
#define EDVO_TARGET_AVX2
#define EDVO_TARGET_AVX512
#endif

namespace vo {

/// Vector instructions that innermost loops are compiled for. All give the same bits: sums are kept
/// in the same lanes, nothing is fused or approximated.
enum class InstructionSet { baseline, avx2, avx512 };

/// What this machine has; asked once.
InstructionSet available_instruction_set();

}  // namespace vo
