// The outcome of a run in words, for a terminal, a pull request and the head of the HTML report.
//
// Names that come from files are shown without control characters, so that no file can move the cursor of a
// terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/report/result.h"

namespace reprise {

// One or two sentences: what was chosen, how fast, how wrong; for the original, why. No line feed.
std::string choiceSentence(const RunResult& result);

// The warning that stands before all else: that of kMotionSuspect. None in most runs.
std::optional<std::string> leadingWarning(const RunResult& result);

// The choice, the machine, times, the candidates that were trained, attempts and warnings. Lines of at most
// 80 columns (code points), a line feed after each. A word that is longer than a line is broken.
std::string summaryText(const RunResult& result);

// The same outcome as a GitHub-flavoured Markdown table, with the sentence above and the machine below it.
std::string summaryMarkdown(const RunResult& result);

// Every point of every configuration as a spreadsheet: RFC 4180 with a line of headers, empty cells for what was not measured.
std::string pointsCsv(const RunResult& result);

// Nine significant digits; empty if not finite.
std::string formatPrecise(double value);
// "2.71", "0.0142", "13.1": three significant digits, no exponent from 1e-4 to 1e7; "n/a" if not finite.
std::string formatNumber(double value);
// A number that the user gave, with the digits that it has: "0.02".
std::string formatGiven(double value);
// An error in the run's unit: "0.0134 rms", or "83% of what is allowed" where several thresholds bind.
std::string errorText(const RunResult& result, double error);
// What binds: "rms 0.02", "quality good (tile_flip 0.05, blocks 0.01)".
std::string thresholdsText(const RunResult& result);
// "refreshed every 16 frames", or "never refreshed".
std::string refreshText(std::uint32_t period_frames);
// "16", or "never" for kNeverRefresh.
std::string formatPeriod(std::uint32_t period_frames);
// The text with every control character (C0, C1, DEL) and every byte that is not UTF-8 replaced by '?', and
// every line feed and tab by a space.
std::string printable(const std::string& text);

}  // namespace reprise
