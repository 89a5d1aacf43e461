#include "vo/image/hysteresis.h"

#include <array>
#include <cstring>
#include <utility>

#include "vo/image/pixel_bits.h"

namespace vo {
namespace {

using Word = std::uint64_t;

/// Eight mask pixels for each value of eight bits.
constexpr std::array<Word, 256> mask_pixels() {
  std::array<Word, 256> pixels{};
  for (Word bits = 0; bits < pixels.size(); ++bits) {
    for (Word i = 0; i < 8; ++i) {
      pixels[bits] |= ((bits >> i) & 1U) * 0xffU << (8 * i);
    }
  }
  return pixels;
}

}  // namespace

Hysteresis::Hysteresis(cv::Size size)
    : size_(size),
      words_((static_cast<std::size_t>(size.width) + kBits - 1) / kBits),
      strong_(words_ * static_cast<std::size_t>(size.height)),
      edges_(strong_.size()) {}

void Hysteresis::set(int v, int word, const uchar* classes) {
  const std::size_t index = offset(v) + static_cast<std::size_t>(word);
  edges_[index] = packed_word(classes, 0);
  strong_[index] = packed_word(classes, 1);
}

void Hysteresis::follow() {
  for (int v = 0; v < size_.height; ++v) {
    grow_right(row(strong_, v), row(edges_, v));
    grow_left(row(strong_, v), row(edges_, v));
  }
  std::vector<char> unseen_below(static_cast<std::size_t>(size_.height), 1);  // since it changed
  std::vector<char> unseen_above = unseen_below;
  const auto spread_unseen = [&](int from, int to, std::vector<char>& unseen) {
    const bool changed =
        std::exchange(unseen[static_cast<std::size_t>(from)], 0) != 0 && spread(from, to);
    if (changed) {
      unseen_below[static_cast<std::size_t>(to)] = 1;
      unseen_above[static_cast<std::size_t>(to)] = 1;
    }
    return changed;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int v = 1; v < size_.height; ++v) {
      changed |= spread_unseen(v - 1, v, unseen_below);
    }
    for (int v = size_.height - 1; v > 0; --v) {
      changed |= spread_unseen(v, v - 1, unseen_above);
    }
  }
}

/// From one row to the one beside it; whether anything became strong.
bool Hysteresis::spread(int from, int to) {
  const Word* source = row(strong_, from);
  Word* strong = row(strong_, to);
  const Word* edges = row(edges_, to);
  bool changed = false;
  for (std::size_t w = 0; w < words_; ++w) {
    const Word weak = edges[w] & ~strong[w];
    if (weak == 0) {
      continue;
    }
    const Word before = w > 0 ? source[w - 1] >> (kBits - 1) : 0;
    const Word after = w + 1 < words_ ? source[w + 1] << (kBits - 1) : 0;
    const Word touched = source[w] | source[w] << 1U | source[w] >> 1U | before | after;
    strong[w] |= weak & touched;
    changed |= (weak & touched) != 0;
  }
  if (changed) {
    grow_right(strong, edges);
    grow_left(strong, edges);
  }
  return changed;
}

/// Adding a seed to a run of ones carries from the seed to the run's end, where it leaves zeros.
void Hysteresis::grow_right(Word* strong, const Word* edges) const {
  Word carry = 0;
  for (std::size_t w = 0; w < words_; ++w) {
    const Word seeded = edges[w] + strong[w];
    const Word sum = seeded + carry;
    carry = seeded < edges[w] || sum < seeded ? 1 : 0;
    strong[w] |= edges[w] & ~sum;
  }
}

/// Parallel prefix: seeds move by 1, 2, 4, ... pixels where all pixels on the way are edges.
void Hysteresis::grow_left(Word* strong, const Word* edges) const {
  Word from_right = 0;
  for (std::size_t w = words_; w-- > 0;) {
    Word seeds = strong[w] | (edges[w] & from_right << (kBits - 1));
    Word way = edges[w];
    for (unsigned step = 1; step < kBits && (edges[w] & ~seeds) != 0; step *= 2) {
      seeds |= way & seeds >> step;
      way &= way >> step;
    }
    strong[w] = seeds;
    from_right = seeds & 1U;
  }
}

EdgeMask Hysteresis::strong() const {
  static constexpr std::array<Word, 256> kPixels = mask_pixels();
  EdgeMask mask(size_);
  constexpr std::size_t kBytes = 8;
  std::vector<Word> pixels(words_ * kBits / kBytes);
  for (int v = 0; v < size_.height; ++v) {
    const Word* strong = strong_.data() + offset(v);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::size_t shift = kBytes * (i % kBytes);
      pixels[i] = kPixels[(strong[i / kBytes] >> shift) & 0xffU];
    }
    std::memcpy(mask[v], pixels.data(), static_cast<std::size_t>(size_.width));
  }
  return mask;
}

}  // namespace vo
