#include "profiler/training/compare_with_original.h"

#include <filesystem>

namespace reprise {
namespace {

namespace fs = std::filesystem;

bool isRecorded(const Error& error) { return error.kind == ErrorKind::kMeasurement || error.kind == ErrorKind::kRefused; }

class Scratch {
 public:
  static Result<Scratch> make(const fs::path& directory) {
    std::error_code status;
    fs::remove_all(directory, status);  // of a run that was killed
    fs::create_directories(directory, status);
    if (status) return Error{ErrorKind::kMachine, "file.unwritable", "cannot make '" + directory.string() + "': " + status.message(), {}};
    return Scratch(directory);
  }
  Scratch(Scratch&& other) noexcept : directory_(std::move(other.directory_)) { other.directory_.clear(); }
  Scratch& operator=(Scratch&&) = delete;
  ~Scratch() {
    std::error_code ignored;
    if (!directory_.empty()) fs::remove_all(directory_, ignored);
  }
  std::string path() const { return directory_.string(); }

 private:
  explicit Scratch(fs::path directory) : directory_(std::move(directory)) {}
  fs::path directory_;
};

Job jobOf(const Measuring& measuring, JobKind kind, const std::string& session, const std::string& reference_dir) {
  Job job;
  job.kind = kind;
  job.scenario_path = measuring.scenario_path;
  job.session = session;
  job.original_dir = measuring.original_dir;
  job.width = measuring.base.width;
  job.height = measuring.base.height;
  job.device = measuring.device;
  job.reference_dir = reference_dir;
  return job;
}

Result<void> playOriginal(const Measuring& measuring, const std::string& session, const std::string& reference_dir) {
  const Result<JobResult> played =
      superviseJob(jobOf(measuring, JobKind::kReference, session, reference_dir), measuring.supervisor, measuring.progress);
  if (played.ok()) return {};
  if (!isRecorded(played.error())) return played.error();
  return Error{ErrorKind::kInput, "original.unplayable", "the original shader cannot be played in session '" + session + "': " + played.error().message, {}};
}

// The places of those that are still to be looked at.
std::vector<std::size_t> undecided(const std::vector<LawFinding>& findings) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (!findings[i].failure && !findings[i].outcome.difference) places.push_back(i);
  return places;
}

void merge(const std::string& session, const LawOutcome& outcome, LawFinding& finding) {
  finding.outcome.frozen_hits += outcome.frozen_hits;
  const std::optional<LawDifference>& seen = finding.outcome.rounding;
  if (outcome.rounding && (!seen || (outcome.rounding->visible && !seen->visible))) {
    finding.outcome.rounding = outcome.rounding;
    finding.session = session;
  }
  if (!outcome.difference) return;
  finding.outcome.difference = outcome.difference;
  finding.session = session;
}

// Together; if that fails, one by one, so that one bad package costs nobody else.
Result<void> playPackages(const Measuring& measuring, const Job& session, const std::vector<LawRequest>& requests,
                          const std::vector<std::size_t>& places, std::vector<LawFinding>& findings) {
  Job job = session;
  for (const std::size_t place : places) job.entries.push_back({requests[place].package_dir, requests[place].period_frames, requests[place].tolerance});
  const Result<JobResult> result = superviseJob(job, measuring.supervisor, measuring.progress);
  if (result.ok()) {
    for (std::size_t i = 0; i < places.size(); ++i) merge(job.session, result->laws.at(i), findings[places[i]]);
    return {};
  }
  if (!isRecorded(result.error())) return result.error();
  if (places.size() == 1) {
    findings[places[0]].failure = FailureRow{result.error().code, result.error().message};
    return {};
  }
  for (const std::size_t place : places) REPRISE_TRY(playPackages(measuring, session, requests, {place}, findings));
  return {};
}

}  // namespace

Result<std::vector<LawFinding>> compareWithOriginal(const Measuring& measuring, const std::vector<std::string>& sessions,
                                                    const std::vector<LawRequest>& requests, const std::string& scratch) {
  std::vector<LawFinding> findings(requests.size());
  for (const std::string& session : sessions) {
    const std::vector<std::size_t> places = undecided(findings);
    if (places.empty()) break;
    REPRISE_ASSIGN(const Scratch reference, Scratch::make(scratch));
    REPRISE_TRY(playOriginal(measuring, session, reference.path()));
    REPRISE_TRY(playPackages(measuring, jobOf(measuring, JobKind::kLaws, session, reference.path()), requests, places, findings));
  }
  return findings;
}

}  // namespace reprise
