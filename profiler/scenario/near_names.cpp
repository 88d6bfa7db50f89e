#include "profiler/scenario/near_names.h"

#include <algorithm>
#include <cctype>

namespace reprise {
namespace {

char lowered(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

std::string afterDot(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

std::string quotedList(std::span<const std::string> names, const std::string& last_joint) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last_joint : ", ";
    text += "'" + names[i] + "'";
  }
  return text;
}

}  // namespace

int editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lowered(a[i - 1]) == lowered(b[j - 1]);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && lowered(a[i - 1]) == lowered(b[j - 2]) && lowered(a[i - 2]) == lowered(b[j - 1]);
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

std::vector<std::string> nearNames(const std::string& name, std::span<const std::string> known) {
  // The work is quadratic in the length: what is longer than any name of ours is no slip of the finger.
  if (name.size() > 200) return {};
  const int reach = std::max(2, static_cast<int>(name.size()) / 3);
  std::vector<std::pair<int, std::string>> found;
  for (const std::string& candidate : known) {
    int distance = editDistance(name, candidate);
    if (afterDot(name) == afterDot(candidate)) distance = std::min(distance, 1);
    const bool nothing_shared = distance >= static_cast<int>(std::max(name.size(), candidate.size()));
    if (distance <= reach && !nothing_shared) found.emplace_back(distance, candidate);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (const auto& [distance, candidate] : found) {
    if (names.size() < 3) names.push_back(candidate);
  }
  return names;
}

std::string suggestNames(const std::string& name, std::span<const std::string> known) {
  const std::vector<std::string> near = nearNames(name, known);
  if (!near.empty()) return "; did you mean " + quotedList(near, " or ") + "?";
  if (known.empty()) return "";
  return known.size() == 1 ? "; expected " + quotedList(known, "")
                           : "; expected one of " + quotedList(known, ", ");
}

}  // namespace reprise
