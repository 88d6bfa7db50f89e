#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/report/write_report.h"
#include "runtime/base/file.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

const std::string kDataStart = "<script type=\"application/json\" id=\"run-data\">";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++found;
  return found;
}

// What a browser would take for the JSON block: up to the first end of a script.
nlohmann::json embeddedData(const std::string& html) {
  const std::size_t start = html.find(kDataStart) + kDataStart.size();
  return nlohmann::json::parse(html.substr(start, html.find("</script", start) - start));
}

TEST(ReportHtml, EmbedsTheResultThatItIsGiven) {
  const RunResult run = sample::variantRun();
  const nlohmann::json block = embeddedData(reportHtml(run, sample::pictures()));
  const Result<RunResult> read = resultFromJson(block["result"].dump());
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->candidates,
            run.candidates);  // stages come back sorted: plain nlohmann::json keeps no order
  EXPECT_EQ(read->choice, run.choice);
  for (const char* image : {"original", "cached", "error", "hit_miss"}) {
    EXPECT_TRUE(block["images"][image].get<std::string>().starts_with("data:image/png;base64,iVBORw0KGgo"))
        << image;
  }
}

TEST(ReportHtml, EncodesImagesOfAnyLength) {
  ReportImages images;
  images.original = {'M', 'a', 'n'}, images.cached = {'M', 'a'}, images.error = {'M'};
  const nlohmann::json block = embeddedData(reportHtml(sample::variantRun(), images));
  EXPECT_EQ(block["images"]["original"], "data:image/png;base64,TWFu");
  EXPECT_EQ(block["images"]["cached"], "data:image/png;base64,TWE=");
  EXPECT_EQ(block["images"]["error"], "data:image/png;base64,TQ==");
  EXPECT_TRUE(block["images"]["hit_miss"].is_null());
}

TEST(ReportHtml, NamesNoAddressOutsideItself) {
  const std::string html = reportHtml(sample::variantRun(), sample::pictures());
  const std::string without_namespace =
      std::regex_replace(html, std::regex("http://www\\.w3\\.org/2000/svg"), "");
  EXPECT_EQ(without_namespace.find("http://"), std::string::npos);
  EXPECT_EQ(without_namespace.find("https://"), std::string::npos);
  EXPECT_EQ(without_namespace.find("@import"), std::string::npos);
  EXPECT_EQ(count(without_namespace, "url("), 0u);
}

TEST(ReportHtml, LetsNoNameBecomeMarkup) {
  const std::string html = reportHtml(sample::hostileRun(), sample::pictures());
  const std::string harmless = reportHtml(sample::variantRun(), sample::pictures());
  for (const char* tag : {"<script", "</script", "<img", "<!--", "</style", "</noscript", "</pre"}) {
    EXPECT_EQ(count(html, tag), count(harmless, tag)) << tag;
  }
  EXPECT_EQ(embeddedData(html)["result"]["candidates"].size(), sample::hostileRun().candidates.size());
}

TEST(ReportHtml, SaysTheOutcomeWithoutScriptsToo) {
  const std::string html = reportHtml(sample::variantRun(), {});
  const std::size_t start = html.find("<noscript>");
  const std::string plain = html.substr(start, html.find("</noscript>") - start);
  EXPECT_NE(plain.find("albedo (vec3) at shaders/marble/marble20.frag:71:10"), std::string::npos);
  EXPECT_NE(plain.find("3.12"), std::string::npos);
}

TEST(ReportHtml, IsWrittenWholeOrNotAtAll) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "reprise_report_html_test";
  std::filesystem::remove_all(folder);
  const RunResult run = sample::variantRun();
  const Result<void> written = writeReport(run, {}, {}, folder / "report.html");
  ASSERT_TRUE(written.ok()) << formatError(written.error());
  EXPECT_EQ(readFile(folder / "report.html").value(), reportHtml(run, {}));
  const Result<void> failed = writeReport(run, {}, {}, folder / "report.html" / "below_a_file.html");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().code, "file.unwritable");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace reprise
