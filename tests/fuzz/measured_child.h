// Work done in a process of its own: what it took, and whether it ended by itself.
#pragma once

#include <functional>
#include <string>

namespace reprise {

struct ChildOutcome {
  bool ended = false;      // by returning; false for crashes and failed checks
  std::string answer;      // what `work` returned
  double cpu_s = 0;
  double peak_mib = 0;     // of resident memory
};

// Stops work that takes longer than `most_cpu_s`.
ChildOutcome runInChild(const std::function<std::string()>& work, int most_cpu_s);

}  // namespace reprise
