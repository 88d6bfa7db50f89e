#include "profiler/metrics/flip_color.h"

#include <cmath>

namespace reprise {

namespace {

// Primaries of sRGB, exact fractions (Lindbloom's, rounded to single precision on use).
constexpr double kRgbToXyz[3][3] = {
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

constexpr double whiteOf(int row) {
  return kRgbToXyz[row][0] + kRgbToXyz[row][1] + kRgbToXyz[row][2];
}

// XYZ over the white's XYZ, so that white is (1, 1, 1).
Color relativeXyzFromRgb(const Color& rgb) {
  Color xyz;
  for (int row = 0; row < 3; ++row) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += kRgbToXyz[row][i] * rgb[i];
    xyz[row] = static_cast<float>(sum / whiteOf(row));
  }
  return xyz;
}

struct Matrix3 {
  double m[3][3];
};

Matrix3 invert(const double (&a)[3][3]) {
  Matrix3 inverse{};
  double determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    determinant += a[0][i] * (a[1][i1] * a[2][i2] - a[1][i2] * a[2][i1]);
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      inverse.m[i][j] = a[j1][i1] * a[j2][i2] - a[j1][i2] * a[j2][i1];
    }
  }
  for (auto& row : inverse.m) {
    for (double& value : row) value /= determinant;
  }
  return inverse;
}

float labCurve(float value) {
  constexpr float kDelta = 6.0f / 29.0f;
  if (value > kDelta * kDelta * kDelta) return std::cbrt(value);
  return value / (3 * kDelta * kDelta) + 4.0f / 29.0f;
}

}  // namespace

float linearFromSrgb(float value) {
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

float srgbFromLinear(float value) {
  return value <= 0.0031308f ? value * 12.92f : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

Color ycxczFromSrgb(const Color& srgb) {
  const Color xyz =
      relativeXyzFromRgb({linearFromSrgb(srgb[0]), linearFromSrgb(srgb[1]), linearFromSrgb(srgb[2])});
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Color clampedRgbFromYcxcz(const Color& ycxcz) {
  static const Matrix3 to_rgb = invert(kRgbToXyz);
  const double y = (ycxcz[0] + 16) / 116.0;
  const double xyz[3] = {(y + ycxcz[1] / 500.0) * whiteOf(0), y * whiteOf(1), (y - ycxcz[2] / 200.0) * whiteOf(2)};
  Color rgb;
  for (int row = 0; row < 3; ++row) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += to_rgb.m[row][i] * xyz[i];
    rgb[row] = static_cast<float>(sum < 0 ? 0 : sum > 1 ? 1 : sum);
  }
  return rgb;
}

Color huntLabFromRgb(const Color& rgb) {
  const Color xyz = relativeXyzFromRgb(rgb);
  const float fx = labCurve(xyz[0]), fy = labCurve(xyz[1]), fz = labCurve(xyz[2]);
  const float lightness = 116 * fy - 16;
  return {lightness, 0.01f * lightness * 500 * (fx - fy), 0.01f * lightness * 200 * (fy - fz)};
}

float hyabDistance(const Color& first, const Color& second) {
  return std::abs(first[0] - second[0]) + std::hypot(first[1] - second[1], first[2] - second[2]);
}

}  // namespace reprise
