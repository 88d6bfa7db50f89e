// Strongly connected components of a graph, after Tarjan, "Depth-First Search and Linear Graph Algorithms" (1972).
#pragma once

#include <vector>

namespace reprise {

// edges[a] holds b: a leads to b. Each node stands in one component, and components that others lead to come first. Without
// recursion: shaders may be as deep as they are long.
std::vector<std::vector<int>> componentsBehindFirst(const std::vector<std::vector<int>>& edges);

}  // namespace reprise
