#include <algorithm>
#include <functional>

#include "cli/report/text.h"
#include "cli/report/wrap_text.h"

namespace reprise {
namespace {

constexpr std::size_t kLabelColumns = 15;

std::string padded(const std::string& text, std::size_t columns) {
  if (columnsOf(text) > columns) return text.substr(0, bytesOfColumns(text, columns - 2)) + "..";
  return text + std::string(columns - columnsOf(text), ' ');
}

void fact(std::string& out, const std::string& label, const std::string& text) {
  if (!text.empty()) wrap(out, padded("  " + label, kLabelColumns), text);
}

std::string number(const std::optional<double>& value, const std::string& unit = "") {
  return value ? formatNumber(*value) + unit : "n/a";
}

std::string interval(const std::optional<RunInterval>& ci) {
  return ci ? " (95%: " + formatNumber(ci->lo) + " to " + formatNumber(ci->hi) + ")" : "";
}

std::string placeText(const std::string& file, int line, int column) {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  if (line > 0 && column > 0) text += ":" + std::to_string(column);
  return text;
}

template <class T>
std::string blockAndEncoding(const T& variant) {
  std::string text = variant.pattern;
  if (variant.block_pixels > 0) {
    text += " " + std::to_string(variant.block_pixels) + "x" + std::to_string(variant.block_pixels);
  }
  return text + ", " + variant.filter + ", " + variant.encoding;
}

struct Best {
  const RunConfiguration* configuration = nullptr;
  double error = 0, frame_ms = 0;
  std::uint32_t period_frames = 0;
};

// The fastest point of a candidate under the threshold, measured values before predicted ones. Period 1
// reuses nothing and does not count.
Best bestUnderThreshold(const RunCandidate& candidate, double threshold) {
  Best best;
  for (const RunConfiguration& configuration : candidate.configurations) {
    for (const RunPoint& point : configuration.points) {
      const std::optional<double> error = point.measured_error ? point.measured_error : point.predicted_error;
      const std::optional<double> frame_ms =
          point.measured_frame_ms ? point.measured_frame_ms : point.predicted_frame_ms;
      if (!error || !frame_ms || !(*error <= threshold) || point.period_frames == 1) continue;
      if (best.configuration && *frame_ms >= best.frame_ms) continue;
      best = {&configuration, *error, *frame_ms, point.period_frames};
    }
  }
  return best;
}

// Each threshold with what the worst session took of it.
std::string errorFact(const RunResult& result) {
  const RunChoice& choice = result.choice;
  std::string text;
  for (const RunThreshold& threshold : result.thresholds)
    for (const RunMetric& metric : result.metrics)
      if (metric.metric == threshold.metric)
        text += (text.empty() ? "" : ", ") + threshold.metric + " " + formatNumber(metric.worst_session) + " of " + formatGiven(threshold.value) + " allowed";
  if (text.empty()) text = number(choice.measured_error) + " " + result.threshold.metric + " of " + formatGiven(result.threshold.value) + " allowed";
  const auto inUnit = [&](const std::optional<double>& error) { return error ? errorText(result, *error) : "n/a"; };
  return text + "; predicted " + inUnit(choice.predicted_error) + ", worst frame " + inUnit(choice.worst_frame_error);
}

void metricTable(std::string& out, const RunResult& result) {
  if (result.metrics.empty()) return;
  out += "\nMetrics in validation" + std::string(result.choice.kind == ChoiceKind::kVariant ? "" : ", of the last variant") + "\n";
  const auto row = [&](const std::string& name, const std::string& all, const std::string& session, const std::string& frame) {
    out += "  " + padded(name, 14) + " " + padded(all, 12) + " " + padded(session, 14) + " " + frame + "\n";
  };
  row("metric", "all sessions", "worst session", "worst frame");
  for (const RunMetric& metric : result.metrics)
    row(metric.metric, formatNumber(metric.all_sessions), formatNumber(metric.worst_session), formatNumber(metric.worst_frame));
}

void choiceFacts(std::string& out, const RunResult& result) {
  const RunChoice& choice = result.choice;
  for (const RunPayloadValue& value : choice.payload) {
    fact(out, "payload",
         value.name + " (" + value.type + ") at " + placeText(value.file, value.line, value.column));
  }
  if (choice.kind == ChoiceKind::kVariant) {
    fact(
        out, "variant",
        choice.strategy + ", " + blockAndEncoding(choice) + ", period " + formatPeriod(choice.period_frames));
    fact(out, "speed-up",
         number(choice.measured_speedup) + interval(choice.speedup_ci95) + ", predicted " +
             number(choice.predicted_speedup) + "; by wall time " + number(choice.wall_speedup) +
             interval(choice.wall_speedup_ci95));
    fact(out, "error", errorFact(result));
    fact(out, "frame time",
         number(choice.measured_frame_ms, " ms") + ", predicted " + number(choice.predicted_frame_ms, " ms") +
             "; p95 " + number(choice.p95_ms, " ms") + ", worst " + number(choice.worst_ms, " ms"));
    fact(out, "cache",
         number(choice.cache_bytes_per_pixel) + " bytes per pixel, hit rate " + number(choice.hit_rate));
  }
  if (!result.original.frame_ms) return;
  fact(out, "original",
       number(result.original.frame_ms, " ms") + ", with a depth prepass " +
           number(result.original.with_prepass_ms, " ms") + "; wall " +
           number(result.original.wall_ms, " ms"));
  if (result.limit.frame_ms)
    fact(out, "limit", formatNumber(*result.limit.frame_ms) + " ms: the tail alone with a free payload");
}

void machineFacts(std::string& out, const RunResult& result) {
  fact(out, "device", result.device.name + (result.device.driver.empty() ? "" : ", " + result.device.driver));
  fact(out, "host", result.device.host);
  fact(out, "clock", result.clock == "process_cpu" ? "process CPU time" : result.clock);
  if (!result.scenario.path.empty())
    fact(out, "scenario",
         result.scenario.path + ", " + std::to_string(result.scenario.width) + "x" +
             std::to_string(result.scenario.height) + ", seed " + std::to_string(result.scenario.seed) +
             (result.scenario.eye_distance ? ", stereo: frame times are half a pair's, errors the right eyes'" : ""));
  fact(out, "shader", result.shader.fragment);
  fact(out, "repeat with", result.command);
}

void candidateTable(std::string& out, const RunResult& result) {
  const auto trained = std::count_if(
      result.candidates.begin(), result.candidates.end(),
      [](const RunCandidate& candidate) { return candidate.status == CandidateStatus::kTrained; });
  out += "\nCandidates: " + std::to_string(result.candidates.size()) + ", of which " +
         std::to_string(trained) + " trained\n";
  if (trained == 0) return;
  const auto row = [&](const std::vector<std::string>& cells) {
    constexpr std::size_t kWidths[] = {20, 7, 18, 7, 9, 9};
    std::string line = "  ";
    for (std::size_t i = 0; i < cells.size(); ++i) line += padded(cells[i], kWidths[i]) + " ";
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  row({"name", "cost %", "fastest allowed", "period", "error", "ms"});
  for (const RunCandidate& candidate : result.candidates) {
    if (candidate.status != CandidateStatus::kTrained) continue;
    const Best best = bestUnderThreshold(candidate, result.threshold.value);
    const std::string share = formatNumber(100 * candidate.cost_share);
    if (best.configuration) {
      row({printable(candidate.name), share, printable(best.configuration->strategy),
           formatPeriod(best.period_frames), formatNumber(best.error), formatNumber(best.frame_ms)});
    } else {
      row({printable(candidate.name), share, "none"});
    }
  }
}

std::string attemptText(const RunAttempt& attempt) {
  std::string text = attempt.candidate_id + ", " + attempt.configuration + ", period " +
                     formatPeriod(attempt.period_frames) + ": error " + number(attempt.measured_error) +
                     ", speed-up " + number(attempt.measured_speedup) + interval(attempt.speedup_ci95) +
                     (attempt.accepted ? "; accepted" : "; not accepted");
  return attempt.reason.empty() ? text : text + ": " + attempt.reason;
}

template <class T>
void list(std::string& out, const std::string& title, const std::vector<T>& entries,
          const std::function<std::string(const T&)>& textOf) {
  if (entries.empty()) return;
  out += "\n" + title + "\n";
  for (const T& entry : entries) wrap(out, "  - ", textOf(entry));
}

std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : printable(text)) {
    if (c == '<')
      escaped += "&lt;";
    else if (c == '&')
      escaped += "&amp;";
    else if (std::string("|\\`*_[]").find(c) != std::string::npos)
      escaped += std::string("\\") + c;
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace

std::optional<std::string> leadingWarning(const RunResult& result) {
  if (result.warnings.empty() || !result.warnings.front().starts_with(std::string(kMotionSuspect) + ":")) return std::nullopt;
  return result.warnings.front();
}

std::string summaryText(const RunResult& result) {
  std::string out;
  const std::optional<std::string> leading = leadingWarning(result);
  if (leading) wrap(out, "", *leading), out += "\n";
  wrap(out, "", choiceSentence(result));
  if (result.choice.kind == ChoiceKind::kVariant && !result.choice.reason.empty())
    wrap(out, "", result.choice.reason);
  out += "\n";
  choiceFacts(out, result);
  out += "\n";
  machineFacts(out, result);
  metricTable(out, result);
  candidateTable(out, result);
  list<RunAttempt>(out, "Taken to validation, in this order", result.attempts, attemptText);
  const auto asIs = [](const std::string& text) { return text; };
  list<std::string>(out, "Warnings", {result.warnings.begin() + (leading ? 1 : 0), result.warnings.end()}, asIs);
  list<std::string>(out, "Not reached within the budget", result.not_reached, asIs);
  list<std::string>(out, "Strategies that this shader or its state refuses", result.strategies_refused, asIs);
  return out;
}

std::string summaryMarkdown(const RunResult& result) {
  const RunChoice& choice = result.choice;
  const std::optional<std::string> leading = leadingWarning(result);
  std::string out = (leading ? "**" + cell(*leading) + "**\n\n" : "") + cell(choiceSentence(result)) +
                    "\n\n| | original | choice | predicted | limit |\n|---|--:|--:|--:|--:|\n";
  const auto row = [&](const std::string& label, const std::vector<std::string>& cells) {
    out += "| " + label + " |";
    for (const std::string& text : cells) out += " " + text + " |";
    out += "\n";
  };
  row("frame time, ms", {number(result.original.frame_ms), number(choice.measured_frame_ms),
                         number(choice.predicted_frame_ms), number(result.limit.frame_ms)});
  row("speed-up", {"1", number(choice.measured_speedup) + interval(choice.speedup_ci95),
                   number(choice.predicted_speedup), ""});
  row("speed-up by wall time",
      {"1", number(choice.wall_speedup) + interval(choice.wall_speedup_ci95), "", ""});
  row("error, " + cell(result.threshold.metric),
      {"0", number(choice.measured_error) + " of " + formatGiven(result.threshold.value),
       number(choice.predicted_error), ""});
  for (const RunMetric& metric : result.metrics) row(cell(metric.metric), {"0", formatNumber(metric.worst_session), "", ""});
  row("hit rate", {"", number(choice.hit_rate), "", ""});
  row("cache, bytes per pixel", {"0", number(choice.cache_bytes_per_pixel), "", ""});
  out += "\n" + cell(result.device.name) + ", " + cell(result.device.driver);
  if (!result.device.host.empty()) out += ", " + cell(result.device.host);
  out += "; " + std::to_string(result.scenario.width) + "×" + std::to_string(result.scenario.height) +
         "; clock " + cell(result.clock) + "; Reprise " + cell(result.tool_version) + ".\n";
  return out;
}

}  // namespace reprise
