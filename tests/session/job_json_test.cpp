// Law 6 for jobs: what the supervisor writes is what the worker reads.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "profiler/session/job_json.h"

namespace reprise {
namespace {

Job unlikeTheDefault() {
  Job job;
  job.kind = JobKind::kTimes;
  job.scenario_path = "a \"quoted\" päth/scene.toml";
  job.session = "orbit";
  job.original_dir = "original";
  job.entries = {{"first", 1}, {"second", 0, 0.25}};
  job.metrics = {"flip", "ssim"};
  job.frames = 7;
  job.rounds = 31;
  job.warmup_frames = 3;
  job.width = 1280;
  job.height = 721;
  job.device = "llvmpipe";
  job.image_frame = 9;
  job.image_dir = "images";
  job.reference_dir = "reference";
  job.fence_timeout_s = 0.1;
  job.run_id = "run";
  return job;
}

TEST(JobJson, ReadsBackEveryField) {
  const Job job = unlikeTheDefault();
  const Result<Job> read = jobFromJson(jobToJson(job));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(*read, job);
  EXPECT_NE(*read, Job{});
}

TEST(JobJson, ReadsBackEveryKind) {
  for (const JobKind kind : {JobKind::kErrors, JobKind::kTimes, JobKind::kProbe, JobKind::kObjects, JobKind::kImages, JobKind::kReference,
                             JobKind::kLaws}) {
    Job job;
    job.kind = kind;
    EXPECT_EQ(jobFromJson(jobToJson(job)).value().kind, kind);
  }
}

TEST(JobJson, RefusesWhatIsNoJob) {
  for (const std::string text : {"", "{", "[]", "{\"kind\": \"errors\"}", "null"}) {
    const Result<Job> read = jobFromJson(text);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, "job.syntax") << text;
  }
}

TEST(JobResultJson, ReadsBackRowsAndKeepsNumbersExactly) {
  JobResult result;
  result.device = "device";
  result.driver = "driver";
  result.cpu_device = true;
  ErrorRow row{3, 10, 4, 6, 5, 7, 1, 1, {{"rms", 0.1}, {"mean", 1.0 / 3}}};
  result.errors = {{row}, {}};
  result.times = {{{"run", 1, 5, 0.1, 2.5, 1e-7}}};
  ProbeResult probe;
  probe.entry = 1;
  probe.payload_min[2] = -0.3f;
  probe.payload_max[3] = 1e30f;
  probe.payload_change[1] = 0.125f;
  probe.depth_min = 0.7f;
  probe.depth_max = 9.1f;
  probe.nonfinite_payload = 5;
  probe.nonfinite_color = 6;
  probe.covered = 1ull << 40;
  result.probes = {probe};
  result.images = {"a.png", "b.png"};
  result.objects = {{7, 3}, {1ull << 40, 0}};
  const JobResult read = resultFrom(nlohmann::json::parse(resultJson(result).dump()));
  EXPECT_EQ(read.device, result.device);
  EXPECT_EQ(read.driver, result.driver);
  EXPECT_EQ(read.cpu_device, result.cpu_device);
  EXPECT_EQ(read.errors, result.errors);
  EXPECT_EQ(read.times, result.times);
  EXPECT_EQ(read.images, result.images);
  EXPECT_EQ(read.objects, result.objects);
  ASSERT_EQ(read.probes.size(), 1u);
  EXPECT_EQ(read.probes[0].entry, 1);
  EXPECT_EQ(read.probes[0].payload_min[2], -0.3f);
  EXPECT_EQ(read.probes[0].payload_max[3], 1e30f);
  EXPECT_EQ(read.probes[0].payload_change[1], 0.125f);
  EXPECT_EQ(read.probes[0].depth_min, 0.7f);
  EXPECT_EQ(read.probes[0].depth_max, 9.1f);
  EXPECT_EQ(read.probes[0].nonfinite_payload, 5u);
  EXPECT_EQ(read.probes[0].nonfinite_color, 6u);
  EXPECT_EQ(read.probes[0].covered, 1ull << 40);
}

TEST(JobResultJson, KeepsAnErrorThatIsNotANumber) {
  JobResult result;
  result.errors = {{ErrorRow{0, 0, 0, 0, 0, 0, 0, 0, {{"rms", std::numeric_limits<double>::quiet_NaN()}}}}};
  const JobResult read = resultFrom(nlohmann::json::parse(resultJson(result).dump()));
  EXPECT_TRUE(std::isnan(read.errors.at(0).at(0).errors.at("rms")));
}

}  // namespace
}  // namespace reprise
