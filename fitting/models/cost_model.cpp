#include "fitting/models/cost_model.h"

namespace reprise {

double frameTimeMs(const CostParameters& cost, double hits, double misses) {
  return (hits * cost.hit_ns + misses * cost.miss_ns) * 1e-6 + cost.overhead_ms;
}

}  // namespace reprise
