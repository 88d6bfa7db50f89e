// Starts this program again with one word, with pipes to and from it.
#pragma once

#include <sys/types.h>

#include <string>

#include "runtime/base/result.h"

namespace reprise {

struct ChildProcess {
  pid_t process = -1;
  int input = -1, output = -1;  // to its standard input; from its standard output
};

// Standard error goes nowhere: drivers and assertions of crashing shaders would drown the verdicts. Errors: check.process (kMachine).
Result<ChildProcess> startChild(const std::string& executable, const std::string& verb);

// In the child, first: it ends with its parent, and leaves to it what an interrupt means.
void belongToParent();

// "ended by signal 11 (Segmentation fault)", "ended with status 1"; status as waitpid gives it.
std::string howItEnded(int status);

}  // namespace reprise
