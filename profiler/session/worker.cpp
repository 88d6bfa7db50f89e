// The worker's side of the pipe. One JSON object a line on standard output: {"progress": [done, total]}, then {"result": ...} or
// {"error": ...}.
#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "profiler/session/job_json.h"

namespace reprise {
namespace {

class Answers {
 public:
  // Drivers and layers print to standard output, too: what they say goes to standard error, where it cannot garble answers.
  Answers() : descriptor_(::dup(STDOUT_FILENO)) { ::dup2(STDERR_FILENO, STDOUT_FILENO); }
  ~Answers() { ::close(descriptor_); }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  void say(const nlohmann::json& line) const {
    const std::string text = line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t written = ::write(descriptor_, text.data() + sent, text.size() - sent);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return;  // nobody listens any more
      sent += static_cast<std::size_t>(written);
    }
  }

 private:
  int descriptor_;
};

// A software rasterizer allocates every frame's bins anew. Where the C library gives that memory back to the system in between,
// whoever comes next pays for its pages: 20 ms instead of 13 for a cached frame that follows an original one, though not for one that
// follows its like, which is what an application plays. So the heap keeps what frames free.
void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kNeverTrim = 2'000'000'000, kLargestMmapThreshold = 32 << 20;
  ::mallopt(M_TRIM_THRESHOLD, kNeverTrim);
  ::mallopt(M_MMAP_THRESHOLD, kLargestMmapThreshold);
#endif
}

Result<JobResult> answer(const std::string& text, const Answers& answers) {
  REPRISE_ASSIGN(const Job job, jobFromJson(text));
  try {
    return runJob(job, [&](const JobProgress& state) { answers.say({{"progress", {state.done, state.total}}}); });
  } catch (const std::exception& failure) {  // memory, mostly
    return Error{ErrorKind::kMeasurement, "worker.exception", std::string("the measuring process gave up: ") + failure.what(), {}};
  }
}

}  // namespace

int runWorker() {
  keepFreedMemory();
  const Answers answers;
  const std::string text((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
  const Result<JobResult> result = answer(text, answers);
  if (result.ok()) {
    answers.say({{"result", resultJson(*result)}});
    return 0;
  }
  answers.say({{"error", errorJson(result.error())}});
  return 1;
}

}  // namespace reprise
