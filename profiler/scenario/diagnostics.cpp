#include "profiler/scenario/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace reprise {

void Diagnostics::add(const std::string& kind, const std::string& message, const Place& place) {
  if (!full()) errors.push_back({ErrorKind::kInput, "scenario." + kind, message, place});
}

void sortByPlace(Diagnostics& diagnostics) {
  std::stable_sort(diagnostics.errors.begin(), diagnostics.errors.end(), [](const Error& a, const Error& b) {
    const bool a_unknown = a.place.line == 0, b_unknown = b.place.line == 0;
    return std::tie(a_unknown, a.place.line, a.place.column) <
           std::tie(b_unknown, b.place.line, b.place.column);
  });
}

Error mergeErrors(const Diagnostics& diagnostics) {
  REPRISE_CHECK(!diagnostics.errors.empty(), "there is no error to report");
  Error first = diagnostics.errors.front();
  for (std::size_t i = 1; i < diagnostics.errors.size(); ++i)
    first.message += "\n" + formatError(diagnostics.errors[i]);
  return first;
}

}  // namespace reprise
