// The report as CSV, and its pictures within the size of a page.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/report/embedded_picture.h"
#include "cli/report/text.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

std::vector<std::string> linesOf(const std::string& csv) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end; (end = csv.find("\r\n", at)) != std::string::npos; at = end + 2) lines.push_back(csv.substr(at, end - at));
  return lines;
}

TEST(PointsCsv, HasOneLineForEachPointAndMarksTheChoice) {
  const RunResult run = sample::variantRun();
  std::size_t points = 0;
  for (const RunCandidate& candidate : run.candidates)
    for (const RunConfiguration& one : candidate.configurations) points += one.points.size();
  const std::vector<std::string> lines = linesOf(pointsCsv(run));
  ASSERT_EQ(lines.size(), points + 1);
  const auto columns = std::count(lines[0].begin(), lines[0].end(), ',');
  std::size_t chosen = 0;
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    chosen += line.ends_with(",1");
  }
  EXPECT_EQ(chosen, 1u);
}

TEST(PointsCsv, LetsNoNameBecomeAFormulaOrAnotherCell) {
  RunResult run = sample::variantRun();
  run.candidates.front().name = "=cmd\",1\n2";
  const std::string csv = pointsCsv(run);
  EXPECT_NE(csv.find("\"'=cmd\"\",1 2\","), std::string::npos);
}

TEST(EmbeddedPicture, ShrinksAndCompressesWhatIsAPngOnly) {
  const std::vector<std::uint8_t> png = sample::pictures().original;
  const std::optional<std::string> whole = jpegDataUri(png, 10000, 90), small = jpegDataUri(png, 100, 90);
  ASSERT_TRUE(whole && small);
  EXPECT_TRUE(whole->starts_with("data:image/jpeg;base64,/9j/"));
  EXPECT_LT(whole->size(), png.size());
  EXPECT_LT(small->size(), whole->size());
  EXPECT_FALSE(jpegDataUri({1, 2, 3}, 100, 90));
}

TEST(ReportPictures, StayWithinThePageHoweverManyThereAre) {
  ReportEvidence evidence = sample::evidenceOf(sample::variantRun());
  const std::vector<std::uint8_t> picture = sample::pictures().original;
  for (int i = 0; i < 250; ++i) {
    const std::string name = "more_" + std::to_string(i) + ".png";
    evidence.files[name] = picture;
    evidence.evidence.pictures.push_back({{}, name, "", "", ""});
  }
  EXPECT_LT(reportHtml(sample::variantRun(), {}, evidence).size(), kMostPageBytes);
}

}  // namespace
}  // namespace reprise
