// Opens reports in headless Chromium: no error on the console, every section drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "cli/report/write_report.h"
#include "runtime/base/file.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

constexpr const char* kBrowser = "/usr/bin/chromium";
constexpr const char* kBrowserOptions =
    " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking "
    "--disable-component-update"
    " --disable-sync --enable-logging=stderr --v=0 --window-size=1280,900 --virtual-time-budget=5000";

class ReportInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kBrowser)) {
      std::cerr << "NOT TESTED: " << kBrowser
                << " is missing, so no report was opened in a browser (apt-get install chromium)\n";
      GTEST_SKIP() << kBrowser << " is missing";
    }
    std::string pattern = (std::filesystem::temp_directory_path() / "reprise_browser_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  struct Page {
    std::string dom, console;
  };

  // The document after its scripts and `then` have run, and what they wrote to the console.
  Page open(const RunResult& run, const ReportImages& images, const std::string& then = "", const std::optional<ReportEvidence>& evidence = {}) {
    const std::filesystem::path page_file = folder_ / "report.html", dom_file = folder_ / "dom",
                                log_file = folder_ / "log";
    std::string html = reportHtml(run, images, evidence);
    const std::size_t end_of_script = html.rfind("</script>");
    EXPECT_NE(end_of_script, std::string::npos);
    html.insert(end_of_script, then + "\n");
    EXPECT_TRUE(writeFile(page_file, html).ok());
    const std::string command = std::string("timeout 120 ") + kBrowser + kBrowserOptions +
                                " --user-data-dir='" + (folder_ / "profile").string() +
                                "' --dump-dom 'file://" + page_file.string() + "' > '" + dom_file.string() +
                                "' 2> '" + log_file.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << readFile(log_file).value();
    Page page{readFile(dom_file).value(), ""};
    std::istringstream log(readFile(log_file).value());
    for (std::string line; std::getline(log, line);) {
      if (line.find("CONSOLE") != std::string::npos) page.console += line + "\n";
    }
    return page;
  }

  std::filesystem::path folder_;
};

std::string bodyOf(const std::string& dom) {
  // The drawn part only, without the data block and the scripts, which hold every name anyway.
  return dom.substr(0, dom.find("<script type=\"application/json\""));
}

TEST_F(ReportInBrowser, DrawsAChosenVariant) {
  const RunResult run = sample::variantRun();
  const Page page = open(run, sample::pictures());
  EXPECT_EQ(page.console, "");
  EXPECT_NE(page.dom.find("data-drawn=\"yes\""), std::string::npos);
  const std::string body = bodyOf(page.dom);
  for (const RunCandidate& candidate : run.candidates)
    EXPECT_NE(body.find("<b>" + candidate.name + "</b>"), std::string::npos) << candidate.name;
  EXPECT_EQ(body.find("could not be drawn"), std::string::npos);
  EXPECT_NE(body.find("class=\"choice-ring\""), std::string::npos);
  EXPECT_NE(body.find("threshold 0.02"), std::string::npos);
  EXPECT_NE(body.find("limit: tail alone, payload free"), std::string::npos);
}

TEST_F(ReportInBrowser, DrawsTheOriginalAndAnEmptyRun) {
  const Page original = open(sample::originalRun(), {});
  EXPECT_EQ(original.console, "");
  EXPECT_NE(bodyOf(original.dom).find("The original shader is the best answer"), std::string::npos);
  const Page empty = open(sample::emptyRun(), {});
  EXPECT_EQ(empty.console, "");
  EXPECT_NE(empty.dom.find("data-drawn=\"yes\""), std::string::npos);
  EXPECT_EQ(bodyOf(empty.dom).find("could not be drawn"), std::string::npos);
}

TEST_F(ReportInBrowser, ShowsHostileNamesAsText) {
  const Page page = open(sample::hostileRun(), sample::pictures());
  EXPECT_EQ(page.console, "");
  EXPECT_NE(page.dom.find("data-drawn=\"yes\""), std::string::npos);
  const std::string body = bodyOf(page.dom);
  EXPECT_EQ(body.find("<script>alert"), std::string::npos);
  EXPECT_EQ(body.find("<img src=\"x\""), std::string::npos);
  EXPECT_NE(body.find("&lt;script&gt;alert(1)"), std::string::npos);
}

TEST_F(ReportInBrowser, GivesFiguresUnderThePointerAndUnfoldsCandidates) {
  const Page page = open(sample::variantRun(), sample::pictures(), R"js(
    const ring = document.querySelector('#tradeoff-plot .choice-ring').getBoundingClientRect();
    document.querySelector('#tradeoff-plot svg').dispatchEvent(new PointerEvent('pointermove',
      { bubbles: true, clientX: ring.left + ring.width / 2, clientY: ring.top + ring.height / 2 }));
    document.title = document.getElementById('tooltip').textContent;
    for (const button of document.querySelectorAll('button.unfold')) button.click();
    const strategy = document.getElementById('tradeoff-strategy');
    strategy.value = 'branch';
    strategy.dispatchEvent(new Event('change'));
    const view = document.querySelector('.view');
    view.click();
  )js");
  EXPECT_EQ(page.console, "");
  EXPECT_NE(page.dom.find("<title>albedo, period 32two_pass, tiled 16×16, bilinear, rgba8"),
            std::string::npos);
  const std::string body = bodyOf(page.dom);
  EXPECT_NE(body.find("0.00340 (95%: 0.00323 to 0.00360)"), std::string::npos);
  EXPECT_NE(body.find("three_pass, interleaved 8×8, bilinear, rgba32f"), std::string::npos);
  EXPECT_EQ(body.find("class=\"choice-ring\" cx=\"11\""),
            body.rfind("class=\"choice-ring\""));  // in the legend only
  EXPECT_NE(body.find("scale(4)"), std::string::npos);
}

const RunPoint& pointOf(const RunResult& run, const RunVariant& variant) {
  for (const RunCandidate& candidate : run.candidates)
    if (candidate.id == variant.candidate_id)
      for (const RunPoint& point : candidate.configurations.front().points)
        if (point.period_frames == variant.period_frames) return point;
  throw std::logic_error("no such point: " + variant.candidate_id);
}

// The figure of a tile as the page holds it: data-name="..." data-value="...".
double tileOf(const std::string& body, const std::string& name) {
  const std::string start = "data-name=\"" + name + "\" data-value=\"";
  const std::size_t at = body.find(start);
  return at == std::string::npos ? std::nan("") : std::stod(body.substr(at + start.size()));
}

// The slider on the stop of the front's i-th point, by its threshold. It has steps, so the one that shows the point is looked for.
std::string slideTo(const std::string& name) {
  return "{ const s = document.getElementById('threshold'); for (let i = 0; i <= Number(s.max); ++i) { s.value = i;"
         " s.dispatchEvent(new Event('input')); if (document.querySelector('#pick b').textContent === '" + name + "') break; } }";
}

TEST_F(ReportInBrowser, ShowsWhatTheResultSaysAtEachStopOfTheThreshold) {
  const RunResult run = sample::manyCandidatesRun();
  const ReportEvidence evidence = sample::evidenceOf(run);
  const Page at_choice = open(run, {}, "", evidence);
  EXPECT_EQ(at_choice.console, "");
  EXPECT_DOUBLE_EQ(tileOf(bodyOf(at_choice.dom), "speedup"), *run.choice.measured_speedup);
  EXPECT_DOUBLE_EQ(tileOf(bodyOf(at_choice.dom), "error"), *run.choice.measured_error);
  EXPECT_DOUBLE_EQ(tileOf(bodyOf(at_choice.dom), "cache"), *run.choice.cache_bytes_per_pixel);
  const RunVariant& last = run.front.back();
  const RunPoint& point = pointOf(run, last);
  const Page page = open(run, {}, slideTo("value_39"), evidence);
  EXPECT_EQ(page.console, "");
  const std::string body = bodyOf(page.dom);
  EXPECT_NE(body.find("from training, not validated"), std::string::npos);
  EXPECT_DOUBLE_EQ(tileOf(body, "error"), point.measured_error.value_or(*point.predicted_error));
  EXPECT_DOUBLE_EQ(tileOf(body, "frame_ms"), point.measured_frame_ms.value_or(*point.predicted_frame_ms));
  EXPECT_EQ(body.find("could not be drawn"), std::string::npos);
}

TEST_F(ReportInBrowser, HoldsACandidateFromTheMarginEverywhere) {
  const RunResult run = sample::manyCandidatesRun();
  const Page page = open(run, {}, R"js(
    document.querySelector('button.marker[data-id="many20"]').click();
    const pulled = document.getElementById('images-wipe');
    pulled.value = 250;
    pulled.dispatchEvent(new Event('input'));
    document.querySelector('.thumb[data-frame="16"]').click();
  )js", sample::evidenceOf(run));
  EXPECT_EQ(page.console, "");
  const std::string body = bodyOf(page.dom);
  EXPECT_NE(body.find("curve other held"), std::string::npos);
  EXPECT_NE(body.find("class=\"marker held\" data-id=\"many20\""), std::string::npos);
  EXPECT_NE(body.find("Held: value_20"), std::string::npos);
  EXPECT_NE(body.find("class=\"cut-slice\""), std::string::npos);
  EXPECT_NE(body.find("// &lt;/script&gt;&lt;b&gt;"), std::string::npos);
  EXPECT_NE(body.find("thumb shown"), std::string::npos);
  EXPECT_LT(page.dom.size(), kMostPageBytes);
}

// Without this, a console that nobody hears would let every test above pass.
TEST_F(ReportInBrowser, WouldSeeAnErrorOnTheConsole) {
  EXPECT_NE(open(sample::variantRun(), {}, "console.error('planted');").console.find("planted"),
            std::string::npos);
  EXPECT_NE(open(sample::variantRun(), {}, "notDefined();").console.find("notDefined"), std::string::npos);
}

}  // namespace
}  // namespace reprise
