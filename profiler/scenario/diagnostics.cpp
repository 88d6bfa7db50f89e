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

}  // namespace reprise
