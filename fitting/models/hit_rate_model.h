// Hit rate as a function of the refresh period: λ(n) = μ (1 − 1/n), n the period in frames; μ for "never" (n = ∞).
// Survey section 4.1. μ in [0, 1] is the share of covered pixels that would hit if nothing were refreshed; 1 − μ is what
// disocclusion and the screen's border take. Known to be wrong: μ itself falls with n where old payloads fail the visibility test
// more often than fresh ones (key frames), and for patterns whose period does not divide the session.
#pragma once

#include <cstdint>

namespace reprise {

// period_frames: kNeverRefresh (0) is n = ∞. Result in [0, mu]; 0 at n = 1.
double hitRate(double mu, std::uint32_t period_frames);

// 1 − 1/n, the share of pixels that are not due in a frame; 1 for never.
double shareNotDue(std::uint32_t period_frames);

}  // namespace reprise
