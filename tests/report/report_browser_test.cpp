// Opens reports in headless Chromium: no error on the console, every section drawn.
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

#include "cli/report/write_report.h"
#include "tests/report/browser.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

class ReportInBrowser : public BrowserTest {
 protected:
  OpenedPage open(const RunResult& run, const ReportImages& images, const std::string& then = "", const std::optional<ReportEvidence>& evidence = {}) {
    return openPage(reportHtml(run, images, evidence), then);
  }
};

TEST_F(ReportInBrowser, DrawsAChosenVariant) {
  const RunResult run = sample::variantRun();
  const OpenedPage page = open(run, sample::pictures());
  EXPECT_EQ(page.console, "");
  EXPECT_NE(page.dom.find("data-drawn=\"yes\""), std::string::npos);
  const std::string body = page.body();
  for (const RunCandidate& candidate : run.candidates)
    EXPECT_NE(body.find("<b>" + candidate.name + "</b>"), std::string::npos) << candidate.name;
  EXPECT_EQ(body.find("could not be drawn"), std::string::npos);
  EXPECT_NE(body.find("class=\"choice-ring\""), std::string::npos);
  EXPECT_NE(body.find("threshold 0.02"), std::string::npos);
  EXPECT_NE(body.find("limit: tail alone, payload free"), std::string::npos);
}

TEST_F(ReportInBrowser, BeginsWithTheSuspicionThatMotionIsMissing) {
  RunResult run = sample::variantRun();
  EXPECT_EQ(open(run, {}).body().find("motion.suspect"), std::string::npos);
  run.warnings.insert(run.warnings.begin(), "motion.suspect: no pixel moves");
  const OpenedPage page = open(run, {});
  EXPECT_EQ(page.console, "");
  const std::size_t words = page.dom.find("<pre>");
  ASSERT_NE(words, std::string::npos);
  EXPECT_EQ(page.dom.substr(words + 5, 14), "motion.suspect") << "without scripts";
  const std::string body = page.body();
  const std::size_t suspicion = body.find("motion.suspect: no pixel moves");
  ASSERT_NE(suspicion, std::string::npos);
  EXPECT_LT(suspicion, body.find("Caching albedo")) << "the headline stands before it";
  EXPECT_EQ(body.find("motion.suspect", suspicion + 1), std::string::npos) << "said twice";
}

TEST_F(ReportInBrowser, DrawsTheOriginalAndAnEmptyRun) {
  const OpenedPage original = open(sample::originalRun(), {});
  EXPECT_EQ(original.console, "");
  EXPECT_NE(original.body().find("The original shader is the best answer"), std::string::npos);
  const OpenedPage empty = open(sample::emptyRun(), {});
  EXPECT_EQ(empty.console, "");
  EXPECT_NE(empty.dom.find("data-drawn=\"yes\""), std::string::npos);
  EXPECT_EQ(empty.body().find("could not be drawn"), std::string::npos);
}

TEST_F(ReportInBrowser, ShowsHostileNamesAsText) {
  const OpenedPage page = open(sample::hostileRun(), sample::pictures());
  EXPECT_EQ(page.console, "");
  EXPECT_NE(page.dom.find("data-drawn=\"yes\""), std::string::npos);
  const std::string body = page.body();
  EXPECT_EQ(body.find("<script>alert"), std::string::npos);
  EXPECT_EQ(body.find("<img src=\"x\""), std::string::npos);
  EXPECT_NE(body.find("&lt;script&gt;alert(1)"), std::string::npos);
}

TEST_F(ReportInBrowser, GivesFiguresUnderThePointerAndUnfoldsCandidates) {
  const OpenedPage page = open(sample::variantRun(), sample::pictures(), R"js(
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
  const std::string body = page.body();
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

// The slider on the stop of the front's i-th point, by its threshold. It has steps, so the one that shows the point is looked for.
std::string slideTo(const std::string& name) {
  return "{ const s = document.getElementById('threshold'); for (let i = 0; i <= Number(s.max); ++i) { s.value = i;"
         " s.dispatchEvent(new Event('input')); if (document.querySelector('#pick b').textContent === '" + name + "') break; } }";
}

TEST_F(ReportInBrowser, ShowsWhatTheResultSaysAtEachStopOfTheThreshold) {
  const RunResult run = sample::manyCandidatesRun();
  const ReportEvidence evidence = sample::evidenceOf(run);
  const OpenedPage at_choice = open(run, {}, "", evidence);
  EXPECT_EQ(at_choice.console, "");
  EXPECT_DOUBLE_EQ(at_choice.tile("speedup"), *run.choice.measured_speedup);
  EXPECT_DOUBLE_EQ(at_choice.tile("error"), *run.choice.measured_error);
  EXPECT_DOUBLE_EQ(at_choice.tile("cache"), *run.choice.cache_bytes_per_pixel);
  const RunVariant& last = run.front.back();
  const RunPoint& point = pointOf(run, last);
  const OpenedPage page = open(run, {}, slideTo("value_39"), evidence);
  EXPECT_EQ(page.console, "");
  const std::string body = page.body();
  EXPECT_NE(body.find("from training, not validated"), std::string::npos);
  EXPECT_DOUBLE_EQ(page.tile("error"), point.measured_error.value_or(*point.predicted_error));
  EXPECT_DOUBLE_EQ(page.tile("frame_ms"), point.measured_frame_ms.value_or(*point.predicted_frame_ms));
  EXPECT_EQ(body.find("could not be drawn"), std::string::npos);
}

TEST_F(ReportInBrowser, HoldsACandidateFromTheMarginEverywhere) {
  const RunResult run = sample::manyCandidatesRun();
  const OpenedPage page = open(run, {}, R"js(
    document.querySelector('button.marker[data-id="many20"]').click();
    const pulled = document.getElementById('images-wipe');
    pulled.value = 250;
    pulled.dispatchEvent(new Event('input'));
    document.querySelector('.thumb[data-frame="16"]').click();
  )js", sample::evidenceOf(run));
  EXPECT_EQ(page.console, "");
  const std::string body = page.body();
  EXPECT_NE(body.find("curve other held"), std::string::npos);
  EXPECT_NE(body.find("class=\"marker held\" data-id=\"many20\""), std::string::npos);
  EXPECT_NE(body.find("Held: value_20"), std::string::npos);
  EXPECT_NE(body.find("class=\"cut-slice\""), std::string::npos);
  EXPECT_NE(body.find("// &lt;/script&gt;&lt;b&gt;"), std::string::npos);
  EXPECT_NE(body.find("thumb shown"), std::string::npos);
  EXPECT_LT(page.dom.size(), kMostPageBytes);
}

TEST_F(ReportInBrowser, HoldsTheCandidateOfAPlotPointThatIsClicked) {
  const RunResult run = sample::variantRun();
  // Of every coloured curve the last mark, where no other curve's mark is near, and what is held after a click on it.
  const OpenedPage page = open(run, {}, R"js(
    const found = [];
    const groups = () => [...document.querySelectorAll('#tradeoff-plot g.curve:not(.other)')].filter((group) => group.getAttribute('aria-label'));
    const middle = (mark) => { const box = mark.getBoundingClientRect(); return { x: box.left + box.width / 2, y: box.top + box.height / 2 }; };
    for (let i = 0; i < groups().length; ++i) {
      const group = groups()[i];
      const marks = group.querySelectorAll('.mark');
      const { x, y } = middle(marks[marks.length - 1]);
      const others = [...document.querySelectorAll('#tradeoff-plot g.curve .mark')].filter((mark) => !group.contains(mark)).map(middle);
      if (others.some((other) => Math.hypot(other.x - x, other.y - y) < 4)) continue;
      const at = { bubbles: true, clientX: x, clientY: y };
      const wanted = group.getAttribute('aria-label').split(':')[0];
      document.querySelector('#tradeoff-plot svg').dispatchEvent(new MouseEvent('click', at));
      const held = document.querySelector('#tradeoff-plot g.curve.held');
      found.push(`${wanted}=${held ? held.getAttribute('aria-label').split(':')[0] : 'none'}`);
      document.querySelector('#tradeoff-plot svg').dispatchEvent(new MouseEvent('click', at));
    }
    document.title = found.join(' ');
  )js", sample::evidenceOf(run));
  EXPECT_EQ(page.console, "");
  const std::size_t start = page.dom.find("<title>") + 7;
  std::istringstream words(page.dom.substr(start, page.dom.find("</title>") - start));
  std::size_t clicked = 0;
  for (std::string word; words >> word; ++clicked) EXPECT_EQ(word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
  EXPECT_GE(clicked, 2u);
}

TEST_F(ReportInBrowser, UnfoldsShortListsOnPaperAndLeavesLongOnesFolded) {
  RunResult run = sample::variantRun();
  RunCandidate dropped;
  dropped.status = CandidateStatus::kRefused;
  dropped.reason = {"candidate.state", "it decides what is drawn"};
  for (int i = 0; i < 2; ++i) dropped.id = dropped.name = "refused" + std::to_string(i), run.candidates.push_back(dropped);
  dropped.status = CandidateStatus::kPruned;
  for (int i = 0; i < 60; ++i) dropped.id = dropped.name = "pruned" + std::to_string(i), run.candidates.push_back(dropped);
  const OpenedPage page = open(run, {}, R"js(
    window.dispatchEvent(new Event('beforeprint'));
    const lists = [...document.querySelectorAll('#candidates-dropped details')];
    document.title = [true, false].map((open) => lists.filter((list) => list.open === open && (list.querySelectorAll('.dropped tr').length > 24) !== open).length).join(' ');
  )js");
  EXPECT_EQ(page.console, "");
  std::istringstream counts(page.dom.substr(page.dom.find("<title>") + 7));
  int unfolded = 0, folded = 0;
  counts >> unfolded >> folded;
  EXPECT_GE(unfolded, 1);
  EXPECT_EQ(folded, 1);
}

// Without this, a console that nobody hears would let every test above pass.
TEST_F(ReportInBrowser, WouldSeeAnErrorOnTheConsole) {
  EXPECT_NE(open(sample::variantRun(), {}, "console.error('planted');").console.find("planted"),
            std::string::npos);
  EXPECT_NE(open(sample::variantRun(), {}, "notDefined();").console.find("notDefined"), std::string::npos);
}

}  // namespace
}  // namespace reprise
