#include "cli/report/text.h"
#include "runtime/package/recipe.h"

namespace reprise {
namespace {

// RFC 4180. A leading '=', '+', '-' or '@' in a text would be a formula to a spreadsheet.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  const std::string clean = printable(text);
  if (!clean.empty() && std::string("=+-@").find(clean[0]) != std::string::npos) cell += "'";
  for (const char c : clean) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::string number(const std::optional<double>& value) { return value ? formatPrecise(*value) : ""; }
std::string lowEnd(const std::optional<RunInterval>& range) { return range ? formatPrecise(range->lo) : ""; }
std::string highEnd(const std::optional<RunInterval>& range) { return range ? formatPrecise(range->hi) : ""; }

bool isChoice(const RunChoice& choice, const RunCandidate& candidate, const RunConfiguration& one, const RunPoint& point) {
  return choice.kind == ChoiceKind::kVariant && choice.candidate_id == candidate.id && choice.strategy == one.strategy &&
         choice.pattern == one.pattern && choice.filter == one.filter && choice.encoding == one.encoding &&
         choice.block_pixels == one.block_pixels && choice.period_frames == point.period_frames;
}

}  // namespace

std::string pointsCsv(const RunResult& result) {
  std::string out =
      "candidate,type,place,cost_share,strategy,pattern,block_pixels,filter,encoding,period_frames,predicted_error,measured_error,"
      "predicted_frame_ms,measured_frame_ms,measured_frame_ms_lo,measured_frame_ms_hi,measured_speedup,speedup_lo,speedup_hi,"
      "predicted_hit_rate,cache_bytes_per_pixel,is_choice\r\n";
  for (const RunCandidate& candidate : result.candidates)
    for (const RunConfiguration& one : candidate.configurations)
      for (const RunPoint& point : one.points) {
        const std::string place = candidate.file + ":" + std::to_string(candidate.line);
        const std::string cells[] = {
            quoted(candidate.name.empty() ? candidate.id : candidate.name), quoted(candidate.type), quoted(place),
            formatPrecise(candidate.cost_share), quoted(one.strategy), quoted(one.pattern), std::to_string(one.block_pixels),
            quoted(one.filter), quoted(one.encoding), formatPeriod(point.period_frames), number(point.predicted_error),
            number(point.measured_error), number(point.predicted_frame_ms), number(point.measured_frame_ms),
            lowEnd(point.measured_frame_ms_ci95), highEnd(point.measured_frame_ms_ci95), number(point.measured_speedup),
            lowEnd(point.speedup_ci95), highEnd(point.speedup_ci95), number(point.predicted_hit_rate), number(one.cache_bytes_per_pixel),
            isChoice(result.choice, candidate, one, point) ? "1" : "0"};
        std::string separator;
        for (const std::string& cell : cells) out += separator + cell, separator = ",";
        out += "\r\n";
      }
  return out;
}

}  // namespace reprise
