#include "cli/evidence_pictures.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/describe_run.h"

namespace reprise {
namespace {

constexpr std::size_t kFrontPictures = 5;
constexpr int kStripFrames = 12;
constexpr int kLeastFrame = 8;

bool samePoint(const TradeoffPoint& a, const TradeoffPoint& b) {
  return a.configuration == b.configuration && a.period_frames == b.period_frames;
}

void addNew(std::vector<TradeoffPoint>& points, const TradeoffPoint& point) {
  if (points.size() < kMostPictures && std::none_of(points.begin(), points.end(), [&](const TradeoffPoint& one) { return samePoint(one, point); }))
    points.push_back(point);
}

int framesOf(const Scenario& scenario, const std::string& name) {
  for (const SessionSpec& session : scenario.sessions)
    if (session.name == name && session.frames > 0) return session.frames;
  return scenario.frames;
}

std::vector<int> stripFrames(int frames) {
  std::set<int> numbers;
  for (int i = 0; i < kStripFrames; ++i) numbers.insert(i * (frames - 1) / (kStripFrames - 1));
  return {numbers.begin(), numbers.end()};
}

std::string fileIfMade(const std::vector<std::string>& images, const std::string& name) {
  const auto made = std::find_if(images.begin(), images.end(), [&](const std::string& path) { return std::filesystem::path(path).stem() == name; });
  return made == images.end() ? "" : std::filesystem::path(*made).filename().string();
}

Result<StoredVariant> countingVariant(const PictureSubject& in, const TradeoffPoint& point) {
  const ErrorStudy& study = in.training.errors[in.training.costs[in.fitted.cost_study[point.configuration]].error_study];
  VariantOptions options = study.options;
  options.strategy = in.fitted.input.configurations[point.configuration].strategy;
  options.instrumented = true;
  return storeVariant(in.workspace, in.subject.program, in.subject.candidates[study.candidate], options, in.subject.limits);
}

}  // namespace

std::vector<TradeoffPoint> pointsToShow(const std::optional<TradeoffPoint>& choice, const Selection& selection,
                                        const FittedTraining& fitted, double max_error) {
  std::vector<TradeoffPoint> points;
  if (choice) addNew(points, *choice);
  const std::size_t front = selection.pareto.size(), shown = std::min(front, kFrontPictures);
  for (std::size_t i = 0; i < shown; ++i) addNew(points, selection.pareto[shown == 1 ? 0 : i * (front - 1) / (shown - 1)]);
  std::set<std::string> seen;
  const auto idOf = [&](const TradeoffPoint& point) { return fitted.input.configurations[point.configuration].candidate_id; };
  for (const TradeoffPoint& point : points) seen.insert(idOf(point));
  std::vector<TradeoffPoint> others = selection.points;
  std::stable_sort(others.begin(), others.end(), [](const auto& a, const auto& b) { return a.predicted_frame_ms < b.predicted_frame_ms; });
  for (const TradeoffPoint& point : others)
    if (point.predicted_error <= max_error && seen.insert(idOf(point)).second) addNew(points, point);
  return points;
}

Result<void> makePictures(const PictureSubject& in, const std::vector<TradeoffPoint>& points, const std::string& session, RunEvidence& evidence) {
  if (points.empty()) return {};
  const int frames = framesOf(in.subject.scenario, session);
  Job job;
  job.kind = JobKind::kImages;
  job.scenario_path = in.measuring.scenario_path;
  job.session = session;
  job.original_dir = in.measuring.original_dir;
  job.device = in.measuring.device;
  job.image_frame = std::min(frames - 1, std::max(firstSettledFrame(points.front().period_frames), kLeastFrame));
  if (in.subject.scenario.stereo) job.image_frame -= 1 - job.image_frame % 2;  // a right eye: left ones look like the original
  job.image_dir = in.workspace.imagesDir().string();
  job.strip_frames = stripFrames(frames);
  for (const TradeoffPoint& point : points) {
    REPRISE_ASSIGN(const StoredVariant variant, countingVariant(in, point));
    job.entries.push_back({variant.dir, point.period_frames});
  }
  REPRISE_ASSIGN(const JobResult made, superviseJob(job, in.measuring.supervisor, {}));
  evidence.session = session;
  evidence.frame = job.image_frame;
  evidence.original = fileIfMade(made.images, "original");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string suffix = points.size() == 1 ? "" : "_" + std::to_string(i);
    evidence.pictures.push_back({describeVariant(in.fitted.input.configurations[points[i].configuration], points[i].period_frames),
                                 fileIfMade(made.images, "cached" + suffix), fileIfMade(made.images, "error" + suffix),
                                 fileIfMade(made.images, "hit_miss" + suffix), fileIfMade(made.images, "payload" + suffix)});
  }
  for (const int frame : job.strip_frames) {
    const std::string strip = "strip_" + std::to_string(frame);
    evidence.strip.push_back({frame, fileIfMade(made.images, strip + "_original"), fileIfMade(made.images, strip + "_cached")});
  }
  return {};
}

}  // namespace reprise
