// Random numbers that are the same on every machine and with every standard library (splitmix64).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace reprise {

class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t bits = state_ += 0x9e3779b97f4a7c15ull;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ull;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebull;
    return bits ^ (bits >> 31);
  }

  // 0 to count - 1; count is positive.
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  // Both ends included.
  int between(int least, int most) { return least + below(most - least + 1); }
  bool chance(int percent) { return below(100) < percent; }

  // An index of `weights`, each as likely as its weight says; at least one is positive.
  int weighted(std::span<const int> weights) {
    int total = 0;
    for (const int weight : weights) total += weight;
    int left = below(total);
    std::size_t i = 0;
    while (left >= weights[i]) left -= weights[i++];
    return static_cast<int>(i);
  }

  // One of the values, of which there is at least one.
  template <typename Values>
  const auto& of(const Values& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
  }

 private:
  std::uint64_t state_;
};

}  // namespace reprise
