// What a refusal looks like: the right exit status, a message on standard error that names what is wrong, no
// crash.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/e2e/run_command.h"

namespace reprise {

inline constexpr int kExitDone = 0, kExitBadInput = 1, kExitBadCommandLine = 2, kExitMachineLacks = 3, kExitUndecided = 4, kExitInterrupted = 130;

// Fails the test unless the command ended with `status` and its standard error holds every one of `words`.
inline void expectRefusal(const CommandOutcome& outcome, int status, const std::vector<std::string>& words) {
  EXPECT_FALSE(outcome.timed_out);
  EXPECT_EQ(outcome.status, status) << outcome.all();
  for (const std::string& word : words) {
    EXPECT_NE(outcome.errors.find(word), std::string::npos) << "no \"" << word << "\" in: " << outcome.errors;
  }
}

}  // namespace reprise
