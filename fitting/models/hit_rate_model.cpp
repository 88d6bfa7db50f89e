#include "fitting/models/hit_rate_model.h"

namespace reprise {

double shareNotDue(std::uint32_t period_frames) {
  return period_frames == 0 ? 1 : 1 - 1.0 / period_frames;
}

double hitRate(double mu, std::uint32_t period_frames) {
  return mu * shareNotDue(period_frames);
}

}  // namespace reprise
