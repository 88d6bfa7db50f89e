// Colour spaces of FLIP: sRGB → linear → XYZ → YCxCz (filtered) and L*a*b* with Hunt's adjustment (compared). White: D65.
#pragma once

#include <array>

namespace reprise {

using Color = std::array<float, 3>;

// The curve of sRGB (IEC 61966-2-1), on [0, 1].
float linearFromSrgb(float value);
float srgbFromLinear(float value);

// Opponent space: Y luminance, Cx red-green, Cz blue-yellow.
Color ycxczFromSrgb(const Color& srgb);
// Linear RGB, cut to [0, 1].
Color clampedRgbFromYcxcz(const Color& ycxcz);
// L*a*b* of linear RGB, a* and b* scaled by L*/100 (Hunt: darker colours differ less in chroma).
Color huntLabFromRgb(const Color& rgb);
// |ΔL| + √(Δa² + Δb²)
float hyabDistance(const Color& first, const Color& second);

}  // namespace reprise
