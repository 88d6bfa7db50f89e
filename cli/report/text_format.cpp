#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "cli/report/text.h"
#include "runtime/package/recipe.h"

namespace reprise {
namespace {

// Length in bytes of the well-formed UTF-8 sequence at `at`, 0 if there is none.
std::size_t sequenceLength(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  }
  return length;
}

bool isControl(const std::string& text, std::size_t at) {
  const unsigned char lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x20 || lead == 0x7F) return true;
  return lead == 0xC2 && static_cast<unsigned char>(text[at + 1]) < 0xA0;  // U+0080 to U+009F
}

}  // namespace

std::string formatNumber(double value) {
  if (!std::isfinite(value)) return "n/a";
  const double size = std::abs(value);
  char text[40];
  if (size == 0) return "0";
  if (size < 1e-4 || size >= 1e7) {
    std::snprintf(text, sizeof text, "%.2e", value);
    return text;
  }
  // Rounding first, so that 9.996 becomes 10.0 and not 10.00.
  std::snprintf(text, sizeof text, "%.2e", size);
  const int exponent = std::atoi(std::string(text).substr(std::string(text).find('e') + 1).c_str());
  std::snprintf(text, sizeof text, "%.*f", std::max(0, 2 - exponent), value);
  return text;
}

std::string formatGiven(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string formatPrecise(double value) {
  if (!std::isfinite(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string errorText(const RunResult& result, double error) {
  if (result.threshold.metric != "share") return formatNumber(error) + " " + result.threshold.metric;
  return formatNumber(100 * error) + "% of what is allowed";
}

std::string thresholdsText(const RunResult& result) {
  std::string list;
  for (const RunThreshold& threshold : result.thresholds)
    list += (list.empty() ? "" : ", ") + threshold.metric + " " + formatGiven(threshold.value);
  if (result.thresholds.empty()) list = result.threshold.metric + " " + formatGiven(result.threshold.value);
  return result.quality.empty() ? list : "quality " + result.quality + " (" + list + ")";
}

std::string refreshText(std::uint32_t period_frames) {
  return period_frames == kNeverRefresh ? "never refreshed" : "refreshed every " + formatPeriod(period_frames) + " frames";
}

std::string formatPeriod(std::uint32_t period_frames) {
  return period_frames == kNeverRefresh ? "never" : std::to_string(period_frames);
}

std::string printable(const std::string& text) {
  std::string clean;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequenceLength(text, at);
    if (text[at] == '\n' || text[at] == '\t') {
      clean += ' ';
    } else if (length == 0 || isControl(text, at)) {
      clean += '?';
    } else {
      clean.append(text, at, length);
    }
    at += std::max<std::size_t>(1, length);
  }
  return clean;
}

}  // namespace reprise
