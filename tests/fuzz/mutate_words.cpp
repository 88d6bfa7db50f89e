#include "tests/fuzz/mutate_words.h"

#include <algorithm>
#include <iterator>

namespace reprise {
namespace {

constexpr std::size_t kHeaderWords = 5, kBoundWord = 3;
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::uint32_t kEdges[] = {0,      1,      2,      3,          4,          5,          8,         16,
                                    31,     32,     33,     64,         255,        1023,       0x7fffffff, 0x80000000,
                                    0x10000, 0x3f800000, 0x7f800000, 0x7fc00000, 0xfffffffe, 0xffffffff};

using Words = std::vector<std::uint32_t>;

struct Span {
  std::size_t begin = 0, length = 0;
};

std::vector<Span> instructionsOf(const Words& words) {
  std::vector<Span> spans;
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::size_t length = words[at] >> 16;
    if (length == 0 || length > words.size() - at) break;
    spans.push_back({at, length});
    at += length;
  }
  return spans;
}

class Mutator {
 public:
  Mutator(Words& words, std::size_t most_words, std::minstd_rand& random)
      : words_(words), most_words_(most_words), random_(random), spans_(instructionsOf(words)) {}

  void mutate() {
    if (spans_.empty()) return;
    switch (below(8)) {
      case 0:
      case 1:
      case 2: changeOperand(); break;
      case 3: takeLikeOpcode(); break;
      case 4: takeLikeInstruction(); break;
      case 5: drop(); break;
      case 6: doubleIt(); break;
      default: swapNeighbours(); break;
    }
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  const Span& any() { return spans_[below(spans_.size())]; }
  auto at(std::size_t index) { return words_.begin() + static_cast<std::ptrdiff_t>(index); }

  // An instruction of the same length as `span`.
  const Span& alike(const Span& span) {
    for (int attempt = 0; attempt < 16; ++attempt)
      if (const Span& other = any(); other.length == span.length) return other;
    return span;
  }

  void changeOperand() {
    const Span& span = any();
    if (span.length < 2) return;
    std::uint32_t& word = words_[span.begin + 1 + below(span.length - 1)];
    switch (below(4)) {
      case 0: word = kEdges[below(std::size(kEdges))]; break;
      case 1: word = static_cast<std::uint32_t>(below(words_[kBoundWord] + 1)); break;
      case 2: word += below(2) == 0 ? 1u : 0xffffffffu; break;
      default: {
        const Span& other = any();
        word = words_[other.begin + (other.length > 1 ? 1 + below(other.length - 1) : 0)];
      }
    }
  }

  void takeLikeOpcode() {
    const Span& span = any();
    words_[span.begin] = words_[alike(span).begin];
  }

  // All but the result, which is the third word of most instructions.
  void takeLikeInstruction() {
    const Span& span = any();
    const Span& other = alike(span);
    for (std::size_t i = 0; i < span.length; ++i)
      if (i != 2) words_[span.begin + i] = words_[other.begin + i];
  }

  void drop() {
    const Span& span = any();
    words_.erase(at(span.begin), at(span.begin + span.length));
  }

  void doubleIt() {
    const Span span = any();
    if (words_.size() + span.length > most_words_) return;
    Words copy(at(span.begin), at(span.begin + span.length));
    if (copy.size() > 2) copy[2] = words_[kBoundWord]++;
    words_.insert(at(span.begin + span.length), copy.begin(), copy.end());
  }

  void swapNeighbours() {
    const std::size_t index = below(spans_.size());
    if (index + 1 == spans_.size()) return;
    const Span &first = spans_[index], &second = spans_[index + 1];
    std::rotate(at(first.begin), at(second.begin), at(second.begin + second.length));
  }

  Words& words_;
  std::size_t most_words_;
  std::minstd_rand& random_;
  std::vector<Span> spans_;
};

}  // namespace

void mutateWords(Words& words, std::size_t most_words, std::minstd_rand& random) {
  if (words.size() <= kHeaderWords || words.front() != kMagic) return;
  Mutator(words, most_words, random).mutate();
}

}  // namespace reprise
