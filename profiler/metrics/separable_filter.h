// Separable filters of single-channel images.
#pragma once

#include <vector>

namespace reprise {

struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;  // row by row
};

// Weights of a filter of odd length, its middle at the pixel itself.
using Kernel = std::vector<float>;

// A Gaussian of standard deviation sigma (pixels), 2·radius + 1 weights that sum to 1.
Kernel gaussianKernel(double sigma, int radius);

// out(x, y) = Σ_j Σ_i vertical[j] horizontal[i] in(x + i, y + j); pixels beyond the border repeat the border.
Plane filterPlane(const Plane& in, const Kernel& horizontal, const Kernel& vertical);

}  // namespace reprise
