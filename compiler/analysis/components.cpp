#include "compiler/analysis/components.h"

#include <algorithm>
#include <cstddef>

namespace reprise {
namespace {

constexpr int kUnseen = -1;

struct Visit {
  int node = 0;
  std::size_t next = 0;  // edge
};

}  // namespace

std::vector<std::vector<int>> componentsBehindFirst(const std::vector<std::vector<int>>& edges) {
  std::vector<std::vector<int>> components;
  std::vector<int> number(edges.size(), kUnseen), lowest(edges.size(), 0);
  std::vector<bool> open(edges.size(), false);
  std::vector<int> path;  // nodes whose component is not complete
  std::vector<Visit> visits;
  int count = 0;
  const auto at = [](auto& values, int index) -> decltype(auto) { return values[static_cast<std::size_t>(index)]; };
  const auto enter = [&](int node) {
    at(number, node) = at(lowest, node) = count++;
    open[static_cast<std::size_t>(node)] = true;
    path.push_back(node);
    visits.push_back({node, 0});
  };
  const auto leave = [&](int node) {
    visits.pop_back();
    if (!visits.empty()) at(lowest, visits.back().node) = std::min(at(lowest, visits.back().node), at(lowest, node));
    if (at(lowest, node) != at(number, node)) return;
    const auto first = std::find(path.rbegin(), path.rend(), node).base() - 1;
    components.emplace_back(first, path.end());
    for (const int member : components.back()) open[static_cast<std::size_t>(member)] = false;
    path.erase(first, path.end());
  };
  for (std::size_t root = 0; root < edges.size(); ++root) {
    if (number[root] != kUnseen) continue;
    enter(static_cast<int>(root));
    while (!visits.empty()) {
      Visit& visit = visits.back();
      if (visit.next == at(edges, visit.node).size()) {
        leave(visit.node);
        continue;
      }
      const int target = at(edges, visit.node)[visit.next++];
      if (at(number, target) == kUnseen) {
        enter(target);
      } else if (open[static_cast<std::size_t>(target)]) {
        at(lowest, visit.node) = std::min(at(lowest, visit.node), at(number, target));
      }
    }
  }
  return components;
}

}  // namespace reprise
