#include "fitting/solve/student_t.h"

#include <array>

#include "runtime/base/check.h"

namespace reprise {

double studentT975(int degrees_of_freedom) {
  REPRISE_CHECK(degrees_of_freedom >= 1, degrees_of_freedom);
  constexpr std::array<double, 4> kExact = {12.7062, 4.30265, 3.18245, 2.77645};
  if (degrees_of_freedom <= 4) return kExact[degrees_of_freedom - 1];
  constexpr double z = 1.959964;
  const double n = degrees_of_freedom;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

}  // namespace reprise
