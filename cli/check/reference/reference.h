// Frames of a module as it was given, rendered where none of our passes ran (the design's law 0).
//
// The reference is a process of its own: it gets the words as they were compiled or read, reflects their interface and plays them in
// the harness. It reads no module into our IR and runs no pass on one; NoContraction is the only edit that it knows.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "profiler/harness/harness.h"
#include "runtime/base/result.h"

namespace reprise {

struct ReferenceModule {
  std::string path;  // for messages
  std::string device;
  std::vector<std::uint32_t> vertex_words, fragment_words;
};

struct ReferenceAsk {
  HarnessOptions inputs;
  int frames = 1;
  bool no_contraction = false;
};

// Errors: what the harness says of the module; original.crashed, original.hung (kMachine): the module alone takes its process down,
// or gives no answer in time.
using Reference = std::function<Result<std::vector<HarnessFrame>>(const ReferenceAsk&)>;
using StartReference = std::function<Result<Reference>(const ReferenceModule&)>;

// Starts `executable` with the word "check-reference"; the process ends with the last copy of the function. timeout_s: for an answer,
// as time_limit.h has it. Errors: check.process (kMachine).
Result<Reference> startReferenceProcess(const std::string& executable, const ReferenceModule& module, double timeout_s);

// The other side, on standard input and output. The exit status.
int runReferenceWorker();

}  // namespace reprise
