#include "fitting/selection/pace.h"

#include <limits>

namespace reprise {

double paceOf(const FrameWork& training, const FrameWork& validation) {
  const auto known = [](const FrameWork& work) { return work.frame_ms > 0 && work.fragments_per_frame > 0; };
  if (!known(training) || !known(validation)) return std::numeric_limits<double>::quiet_NaN();
  return validation.frame_ms / validation.fragments_per_frame * training.fragments_per_frame / training.frame_ms;
}

}  // namespace reprise
