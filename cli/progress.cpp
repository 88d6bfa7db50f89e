#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "cli/report/wrap_text.h"

namespace reprise {
namespace {

constexpr int kBarCells = 24;
constexpr auto kRedraw = std::chrono::milliseconds(150);

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void putWrapped(const std::string& head, const std::string& text) {
  std::string lines;
  wrap(lines, head, text);
  std::fputs(lines.c_str(), stderr);
}

}  // namespace

Progress::~Progress() { clearBar(); }

double Progress::elapsedSeconds() const { return clock_ ? clock_() : secondsSince(started_); }

void Progress::clearBar() {
  if (bar_drawn_) std::fputs("\r\033[K", stderr);
  bar_drawn_ = false;
}

void Progress::begin(const std::string& step) {
  step_ = step;
  step_started_ = std::chrono::steady_clock::now();
  drawn_ = {};
  if (style_ == ProgressStyle::kLines) putWrapped(fmt::format("[{:6.1f} s] ", elapsedSeconds()), step);
}

void Progress::update(int done, int total) {
  if (style_ != ProgressStyle::kBar || total <= 0 || std::chrono::steady_clock::now() - drawn_ < kRedraw) return;
  drawn_ = std::chrono::steady_clock::now();
  const double share = std::clamp(static_cast<double>(done) / total, 0.0, 1.0);
  const int filled = static_cast<int>(share * kBarCells);
  const double left = share > 0 ? secondsSince(step_started_) * (1 - share) / share : 0;
  std::fputs(fmt::format("\r\033[K[{}{}] {:.34} {}", std::string(static_cast<std::size_t>(filled), '#'),
                         std::string(static_cast<std::size_t>(kBarCells - filled), '.'), step_,
                         share > 0 ? fmt::format("{:.0f} s left", left) : "").c_str(),
             stderr);
  std::fflush(stderr);
  bar_drawn_ = true;
}

void Progress::say(const std::string& line) {
  if (style_ != ProgressStyle::kQuiet) sayAlways(line);
}

void Progress::sayAlways(const std::string& line) {
  clearBar();
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  putWrapped(std::string(indent, ' '), line.substr(indent));
}

ProgressStyle progressStyle(bool quiet) {
  if (quiet) return ProgressStyle::kQuiet;
  return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::kBar : ProgressStyle::kLines;
}

}  // namespace reprise
