#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/report/result.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

using Json = nlohmann::json;

// The error of reading `run` after `change` was applied to its JSON.
template <class Change>
Error errorAfter(Change change) {
  Json json = Json::parse(resultToJson(sample::variantRun()));
  change(json);
  const Result<RunResult> read = resultFromJson(json.dump());
  return read.ok() ? Error{ErrorKind::kInput, "none", "was read", {}} : read.error();
}

TEST(ResultJson, RoundTripsEveryKindOfRun) {
  for (const RunResult& run :
       {sample::variantRun(), sample::originalRun(), sample::emptyRun(), RunResult{}}) {
    const Result<RunResult> read = resultFromJson(resultToJson(run));
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    EXPECT_TRUE(*read == run) << run.scenario.name;
    EXPECT_EQ(resultToJson(*read), resultToJson(run));
  }
}

TEST(ResultJson, HasTheKeysThatTheCommandLinePromises) {
  const Json json = Json::parse(resultToJson(sample::variantRun()));
  for (const char* key : {"tool_version", "device", "shader", "threshold", "choice", "clock", "original",
                          "limit", "candidates", "seconds"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key :
       {"kind", "payload", "strategy", "pattern", "filter", "encoding", "period_frames", "predicted_error",
        "measured_error", "predicted_speedup", "measured_speedup", "speedup_ci95", "cache_bytes_per_pixel"}) {
    EXPECT_TRUE(json["choice"].contains(key)) << key;
  }
  EXPECT_EQ(json["choice"]["kind"], "variant");
  EXPECT_EQ(json["choice"]["speedup_ci95"], Json::array({3.04, 3.21}));
  EXPECT_EQ(json["choice"]["payload"][0]["line"], 71);
  EXPECT_EQ(json["seconds"]["validate"], 62.5);
}

TEST(ResultJson, WritesNullForNeverAndForWhatDoesNotApply) {
  RunResult run = sample::variantRun();
  run.choice.period_frames = 0;
  EXPECT_TRUE(Json::parse(resultToJson(run))["choice"]["period_frames"].is_null());
  const Json original = Json::parse(resultToJson(sample::originalRun()));
  EXPECT_EQ(original["choice"]["kind"], "original");
  EXPECT_TRUE(original["choice"]["strategy"].is_null());
  EXPECT_TRUE(original["choice"]["measured_speedup"].is_null());
  EXPECT_TRUE(original["limit"]["frame_ms"].is_null());
}

TEST(ResultJson, ReadsNumbersThatAreNotFiniteBackAsNaN) {
  RunResult run = sample::variantRun();
  run.validation[0].frames[3].error = std::numeric_limits<double>::infinity();
  const Result<RunResult> read = resultFromJson(resultToJson(run));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_TRUE(std::isnan(read->validation[0].frames[3].error));
}

TEST(ResultJson, ReplacesBytesThatAreNotUtf8) {
  RunResult run = sample::variantRun();
  run.candidates[0].name = "a\xff";
  const Result<RunResult> read = resultFromJson(resultToJson(run));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->candidates[0].name, "a\xef\xbf\xbd");
}

TEST(ResultJson, KeepsTheStagesInTheOrderRun) {
  RunResult run;
  run.seconds = {{"validate", 1}, {"compile", 2}, {"train", 3}};
  const Result<RunResult> read = resultFromJson(resultToJson(run));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->seconds, run.seconds);
}

TEST(ResultJson, NamesThePlaceOfWhatIsWrong) {
  EXPECT_NE(errorAfter([](Json& json) {
              json["choice"].erase("strategy");
            }).message.find("choice.strategy is missing"),
            std::string::npos);
  const Error wrong_type = errorAfter(
      [](Json& json) { json["candidates"][2]["configurations"][1]["points"][0]["period_frames"] = "two"; });
  EXPECT_EQ(wrong_type.code, "result.invalid");
  EXPECT_NE(wrong_type.message.find("candidates[2].configurations[1].points[0].period_frames is string"),
            std::string::npos)
      << wrong_type.message;
  EXPECT_NE(errorAfter([](Json& json) {
              json["candidates"][0]["status"] = "maybe";
            }).message.find("candidates[0].status"),
            std::string::npos);
  EXPECT_NE(errorAfter([](Json& json) { json["scenario"]["width"] = -1; }).message.find("scenario.width"),
            std::string::npos);
  EXPECT_NE(
      errorAfter([](Json& json) { json["scenario"]["seed"] = 4294967296; }).message.find("scenario.seed"),
      std::string::npos);
  EXPECT_NE(errorAfter([](Json& json) {
              json["choice"]["speedup_ci95"] = {1};
            }).message.find("choice.speedup_ci95"),
            std::string::npos);
  EXPECT_NE(errorAfter([](Json& json) { json["seconds"] = 3; }).message.find("seconds"), std::string::npos);
}

TEST(ResultJson, RefusesWhatIsNoResult) {
  EXPECT_EQ(resultFromJson("").error().code, "result.syntax");
  const std::string whole = resultToJson(sample::variantRun());
  EXPECT_EQ(resultFromJson(whole.substr(0, whole.size() / 2)).error().code, "result.syntax");
  EXPECT_EQ(resultFromJson("[]").error().code, "result.invalid");
  EXPECT_EQ(resultFromJson("{}").error().code, "result.invalid");
  EXPECT_EQ(errorAfter([](Json& json) { json["format_version"] = kResultFormatVersion + 1; }).code,
            "result.version");
}

TEST(ResultJson, PassesOverUnknownKeys) {
  EXPECT_EQ(errorAfter([](Json& json) { json["choice"]["new_in_0_2"] = 1; }).code, "none");
}

}  // namespace
}  // namespace reprise
