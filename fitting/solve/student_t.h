// The 97.5% quantile of Student's t distribution: half the width of a 95% interval in standard errors.
#pragma once

namespace reprise {

// degrees_of_freedom ≥ 1 (checked). Exact to 0.2% (Cornish-Fisher expansion from 4 on, Abramowitz and Stegun 26.7.5).
double studentT975(int degrees_of_freedom);

}  // namespace reprise
