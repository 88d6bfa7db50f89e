// What a run says while it works: a line with a bar and the time left on a terminal, plain lines elsewhere, nothing if quiet.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>

namespace reprise {

enum class ProgressStyle { kQuiet, kLines, kBar };

class Progress {
 public:
  // `clock` gives the seconds since the run began; empty: those since here.
  explicit Progress(ProgressStyle style, std::function<double()> clock = {})
      : style_(style), clock_(std::move(clock)), started_(std::chrono::steady_clock::now()) {}
  ~Progress();

  // A new step; its share of the run is not known beforehand, so time left is estimated within the step.
  void begin(const std::string& step);
  void update(int done, int total);
  // A line that stays, wrapped at 80 columns like all lines; what it begins with spaces goes on with as many.
  void say(const std::string& line);
  // The same where the run is quiet, too: of what holds it up.
  void sayAlways(const std::string& line);
  double elapsedSeconds() const;

 private:
  void clearBar();

  ProgressStyle style_;
  std::function<double()> clock_;
  std::chrono::steady_clock::time_point started_, step_started_, drawn_;
  std::string step_;
  bool bar_drawn_ = false;
};

// kBar if standard error is a terminal, else kLines; kQuiet where asked for.
ProgressStyle progressStyle(bool quiet);

}  // namespace reprise
