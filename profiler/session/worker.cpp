// The worker's side of the pipe. One JSON object a line on standard output: {"progress": [done, total]}, then {"result": ...} or
// {"error": {kind, code, message}}.
#include <cstdio>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "profiler/session/job_json.h"

namespace reprise {
namespace {

void say(const nlohmann::json& line) {
  const std::string text = line.dump() + "\n";
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

int runWorker() {
  const std::string text((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
  const Result<Job> job = jobFromJson(text);
  Result<JobResult> result = job.ok() ? runJob(*job, [](const JobProgress& state) { say({{"progress", {state.done, state.total}}}); })
                                      : Result<JobResult>(job.error());
  if (result.ok()) {
    say({{"result", resultJson(*result)}});
    return 0;
  }
  const Error& error = result.error();
  say({{"error", {{"kind", static_cast<int>(error.kind)}, {"code", error.code}, {"message", error.message},
                  {"file", error.place.file}, {"line", error.place.line}}}});
  return 1;
}

}  // namespace reprise
