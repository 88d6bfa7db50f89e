#include "compiler/candidates/slice_changes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "compiler/candidates/slice_text.h"

namespace reprise {
namespace {

constexpr int kMostSize = 1'000'000;
constexpr int kSmallEdit = 2;                     // then nothing better is looked for
constexpr std::size_t kMostSearchedPairs = 20'000;
constexpr int kMostDepth = 1'500;

int capped(long size) { return static_cast<int>(std::min<long>(size, kMostSize)); }

// Of every term: how many terms it is made of, each counted wherever it stands, itself in it not.
std::vector<int> sizesOf(const SliceTerms& terms) {
  std::vector<int> sizes(terms.size(), 0);
  std::vector<char> entered(terms.size(), 0);
  std::vector<int> stack = {};
  for (std::size_t first = 0; first < terms.size(); ++first) {
    stack.push_back(static_cast<int>(first));
    while (!stack.empty()) {
      const std::size_t at = static_cast<std::size_t>(stack.back());
      if (entered[at] == 2) {
        stack.pop_back();
        continue;
      }
      if (entered[at] == 0) {
        entered[at] = 1;
        for (const int part : terms[at].parts)
          if (entered[static_cast<std::size_t>(part)] == 0) stack.push_back(part);
        continue;
      }
      long size = 1;
      for (const int part : terms[at].parts) size += sizes[static_cast<std::size_t>(part)];
      sizes[at] = capped(size);
      entered[at] = 2;
      stack.pop_back();
    }
  }
  return sizes;
}

// "texture noise": texture, noise.
std::pair<std::string, std::string> kindAndName(const std::string& input) {
  const std::size_t space = input.find(' ');
  return {input.substr(0, space), input.substr(space + 1)};
}

std::string inputChange(const std::string& before, const std::string& after) {
  const auto [kind_before, name_before] = kindAndName(before);
  const auto [kind_after, name_after] = kindAndName(after);
  return kind_after + " '" + name_after + "' is read in place of " + (kind_before == kind_after ? "" : kind_before + " ") + "'" + name_before + "'";
}

enum class Edit { kPending, kNone, kConstant, kInput, kParts, kOperation, kAround, kUnwrapped, kReplaced };

struct Step {
  int cost = 0;
  Edit edit = Edit::kNone;  // kPending: it is being compared
  int part = 0;  // of kAround: after's part that was there; of kUnwrapped: before's part that is left
};

class Comparison {
 public:
  Comparison(const SliceTerms& before, const SliceTerms& after)
      : before_(before), after_(after), size_before_(sizesOf(before)), size_after_(sizesOf(after)) {}

  // Of a pair that is being compared already, as loops have it, no further edit is counted.
  int cost(int before, int after, int depth = 0) {
    const long key = keyOf(before, after);
    if (const auto known = steps_.find(key); known != steps_.end()) return known->second.cost;
    steps_[key] = {0, Edit::kPending, 0};
    const Step step = depth > kMostDepth ? replaced(before, after) : cheapest(before, after, depth);
    steps_[key] = step;
    return step.cost;
  }

  int replacing(int before, int after) const { return replaced(before, after).cost; }

  void tell(int before, int after, int node, std::vector<SliceChange>& changes) {
    if (!told_.insert(keyOf(before, after)).second || cost(before, after) == 0) return;
    const Step step = steps_.at(keyOf(before, after));
    const SliceTerm& old = beforeAt(before);
    const SliceTerm& now = afterAt(after);
    if (now.node != kNoNode) node = now.node;
    switch (step.edit) {
      case Edit::kPending:
      case Edit::kNone: return;
      case Edit::kConstant: return add("the constant " + old.head + " is now " + now.head, node, changes);
      case Edit::kInput: return add(inputChange(old.head, now.head), node, changes);
      case Edit::kReplaced: return add("`" + shortTextOf(before_, before) + "` is now `" + shortTextOf(after_, after) + "`", node, changes);
      case Edit::kOperation: add("`" + old.head + "` is now `" + now.head + "`", node, changes); break;
      case Edit::kAround:
        add("there is an added " + around(after_, after, step.part), node, changes);
        return tell(before, now.parts[static_cast<std::size_t>(step.part)], node, changes);
      case Edit::kUnwrapped:
        add("there is no more " + around(before_, before, step.part), node, changes);
        return tell(old.parts[static_cast<std::size_t>(step.part)], after, node, changes);
      case Edit::kParts: break;
    }
    tellParts(old, now, node, changes);
  }

 private:
  static long keyOf(int before, int after) { return (static_cast<long>(before) << 32) | after; }
  const SliceTerm& beforeAt(int term) const { return before_[static_cast<std::size_t>(term)]; }
  const SliceTerm& afterAt(int term) const { return after_[static_cast<std::size_t>(term)]; }
  int sizeBefore(int term) const { return size_before_[static_cast<std::size_t>(term)]; }
  int sizeAfter(int term) const { return size_after_[static_cast<std::size_t>(term)]; }

  Step replaced(int before, int after) const { return {capped(long{sizeBefore(before)} + sizeAfter(after) + 1), Edit::kReplaced, 0}; }

  // Of parts in their order; those that one of both has more count whole.
  int costOfParts(const SliceTerm& old, const SliceTerm& now, int depth) {
    long sum = 0;
    const std::size_t both = std::min(old.parts.size(), now.parts.size());
    for (std::size_t i = 0; i < both; ++i) sum += cost(old.parts[i], now.parts[i], depth + 1);
    for (std::size_t i = both; i < old.parts.size(); ++i) sum += 1 + sizeBefore(old.parts[i]);
    for (std::size_t i = both; i < now.parts.size(); ++i) sum += 1 + sizeAfter(now.parts[i]);
    return capped(sum);
  }

  Step cheapest(int before, int after, int depth) {
    const SliceTerm& old = beforeAt(before);
    const SliceTerm& now = afterAt(after);
    if (old.head == kUnknownHead || now.head == kUnknownHead) return {};
    if (isConstantHead(old.head) && isConstantHead(now.head)) return old.head == now.head ? Step{} : Step{1, Edit::kConstant, 0};
    if (isInputHead(old.head) && isInputHead(now.head) && old.parts.empty() && now.parts.empty())
      return old.head == now.head ? Step{} : Step{1, Edit::kInput, 0};
    Step best = replaced(before, after);
    const auto offer = [&](const Step& step) {
      if (step.cost < best.cost) best = step;
    };
    const bool has_parts = !old.parts.empty() && !now.parts.empty();
    if (old.head == now.head) {
      const int cost = costOfParts(old, now, depth);
      if (cost == 0) return {};
      offer({cost, Edit::kParts, 0});
    } else if (has_parts && old.parts.size() == now.parts.size()) {
      offer({capped(2 + costOfParts(old, now, depth)), Edit::kOperation, 0});
    }
    if (best.cost <= kSmallEdit || steps_.size() > kMostSearchedPairs) return best;
    searchAround(before, after, depth, best);
    return best;
  }

  // Of a pair of which one stands in an operation that the other is not in; none where they have nothing in common. A loop that comes back
  // to what is being compared is no operation around it.
  std::optional<int> costInside(int before, int after, int depth) {
    const long key = keyOf(before, after);
    if (const auto known = steps_.find(key); known != steps_.end() && known->second.edit == Edit::kPending) return std::nullopt;
    const int inside = cost(before, after, depth + 1);
    const Edit edit = steps_.at(key).edit;
    return edit == Edit::kConstant || edit == Edit::kInput || edit == Edit::kReplaced ? std::nullopt : std::optional(inside);
  }

  void searchAround(int before, int after, int depth, Step& best) {
    const auto offer = [&](const std::optional<int>& inside, int others, Edit edit, std::size_t part) {
      if (inside && long{*inside} + others < best.cost) best = {*inside + others, edit, static_cast<int>(part)};
    };
    const SliceTerm& old = beforeAt(before);
    const SliceTerm& now = afterAt(after);
    for (std::size_t i = 0; i < now.parts.size(); ++i) offer(costInside(before, now.parts[i], depth), otherSizes(now, i, size_after_), Edit::kAround, i);
    for (std::size_t i = 0; i < old.parts.size(); ++i) offer(costInside(old.parts[i], after, depth), otherSizes(old, i, size_before_), Edit::kUnwrapped, i);
  }

  static int otherSizes(const SliceTerm& term, std::size_t without, const std::vector<int>& sizes) {
    long sum = 1;
    for (std::size_t i = 0; i < term.parts.size(); ++i)
      if (i != without) sum += sizes[static_cast<std::size_t>(term.parts[i])];
    return capped(sum);
  }

  // "`FAdd` of varying normal", "`Sin`".
  static std::string around(const SliceTerms& terms, int term, int without) {
    const SliceTerm& whole = terms[static_cast<std::size_t>(term)];
    std::string others;
    for (std::size_t i = 0; i < whole.parts.size(); ++i)
      if (static_cast<int>(i) != without) others += (others.empty() ? "" : " and ") + shortTextOf(terms, whole.parts[i]);
    return "`" + whole.head + "`" + (others.empty() ? "" : " of " + others);
  }

  void tellParts(const SliceTerm& old, const SliceTerm& now, int node, std::vector<SliceChange>& changes) {
    const std::size_t both = std::min(old.parts.size(), now.parts.size());
    for (std::size_t i = 0; i < both; ++i) tell(old.parts[i], now.parts[i], node, changes);
    for (std::size_t i = both; i < old.parts.size(); ++i)
      add("`" + now.head + "` has no more " + shortTextOf(before_, old.parts[i]), node, changes);
    for (std::size_t i = both; i < now.parts.size(); ++i)
      add("`" + now.head + "` has another part, " + shortTextOf(after_, now.parts[i]), node, changes);
  }

  static void add(std::string text, int node, std::vector<SliceChange>& changes) {
    const bool said = std::any_of(changes.begin(), changes.end(), [&](const SliceChange& one) { return one.text == text; });
    if (!said) changes.push_back({std::move(text), node});
  }

  const SliceTerms& before_;
  const SliceTerms& after_;
  std::vector<int> size_before_, size_after_;
  std::unordered_map<long, Step> steps_;  // by pair
  std::set<long> told_;
};

}  // namespace

std::vector<SliceChange> changesBetween(const SliceTerms& before, const SliceTerms& after) {
  std::vector<SliceChange> changes;
  if (!before.empty() && !after.empty()) Comparison(before, after).tell(0, 0, kNoNode, changes);
  return changes;
}

std::vector<SliceChange> changesOfKept(const SliceTerms& kept_before, const SliceTerms& all_after) {
  std::vector<SliceChange> changes;
  if (kept_before.empty() || all_after.empty()) return changes;
  Comparison comparison(kept_before, all_after);
  std::vector<int> left = all_after[0].parts, changed;
  for (const int term : kept_before[0].parts) {
    const auto same = std::find_if(left.begin(), left.end(), [&](int now) { return comparison.cost(term, now) == 0; });
    if (same != left.end()) left.erase(same);
    else changed.push_back(term);
  }
  for (const int term : changed) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](int a, int b) { return comparison.cost(term, a) < comparison.cost(term, b); });
    if (nearest == left.end() || comparison.cost(term, *nearest) >= comparison.replacing(term, *nearest)) {
      changes.push_back({"the kept term `" + shortTextOf(kept_before, term) + "` is gone", all_after[0].node, true});
      continue;
    }
    comparison.tell(term, *nearest, all_after[0].node, changes);
    left.erase(nearest);
  }
  return changes;
}

double shareEdited(const SliceTerms& before, const SliceTerms& after) {
  if (before.empty() || after.empty()) return 1;
  Comparison comparison(before, after);
  return static_cast<double>(comparison.cost(0, 0)) / sizesOf(before)[0];
}

}  // namespace reprise
