// The time that a run may take from the moment that it holds the device, report and validation included. Each stage may go on until its share
// of the whole is over: what is left of an earlier one falls to the later ones. It is looked at by frame, within jobs.
#pragma once

#include "cli/progress.h"

namespace reprise {

// kFirstTimesShare: of training as long as no variant has been timed, without which there is nothing to validate.
inline constexpr double kTrainingShare = 0.55, kFirstTimesShare = 0.75, kValidationShare = 0.9, kPicturesShare = 1;

class Budget {
 public:
  // seconds: 0 for none. Begins now.
  Budget(double seconds, const Progress& progress) : seconds_(seconds), progress_(progress), begun_s_(progress.elapsedSeconds()) {}

  bool isSpent(double share) const { return seconds_ > 0 && progress_.elapsedSeconds() - begun_s_ >= share * seconds_; }

 private:
  double seconds_;
  const Progress& progress_;
  double begun_s_;
};

}  // namespace reprise
