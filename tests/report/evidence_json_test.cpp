#include <gtest/gtest.h>

#include "cli/report/evidence.h"
#include "runtime/package/recipe.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

TEST(EvidenceJson, ReadsBackWhatItWrote) {
  RunEvidence evidence = sample::evidenceOf(sample::manyCandidatesRun()).evidence;
  evidence.pictures.front().variant.period_frames = kNeverRefresh;
  const Result<RunEvidence> read = evidenceFromJson(evidenceToJson(evidence));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(*read, evidence);
  const Result<RunEvidence> empty = evidenceFromJson(evidenceToJson({}));
  ASSERT_TRUE(empty.ok());
  EXPECT_EQ(*empty, RunEvidence{});
}

TEST(EvidenceJson, RefusesWhatIsNotEvidence) {
  EXPECT_EQ(evidenceFromJson("{").error().code, "evidence.syntax");
  EXPECT_EQ(evidenceFromJson("{}").error().code, "evidence.invalid");
  std::string wrong_type = evidenceToJson({});
  wrong_type.replace(wrong_type.find("\"frame\":0"), 9, "\"frame\":[]");
  EXPECT_EQ(evidenceFromJson(wrong_type).error().code, "evidence.invalid");
}

}  // namespace
}  // namespace reprise
