// A marble that is really optimized, and its page in a real browser: what the slider shows at every stop is what result.json says.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "cli/report/result.h"
#include "cli/report/write_report.h"
#include "profiler/scenario/read_scenario.h"
#include "runtime/base/file.h"
#include "tests/e2e/run_command.h"
#include "tests/report/browser.h"

namespace reprise {
namespace {

// Slides over all steps; the title becomes the figures of each pick in turn, as JSON.
constexpr const char* kReadEveryStop = R"js(
  const slider = document.getElementById('threshold'), seen = new Map();
  for (let step = 0; step <= Number(slider.max); ++step) {
    slider.value = step;
    slider.dispatchEvent(new Event('input'));
    const figures = { pick: document.querySelector('#pick b').textContent };
    for (const tile of document.querySelectorAll('#tiles .tile')) figures[tile.dataset.name] = Number(tile.dataset.value);
    const validated = document.querySelector('#pick .tag.good') !== null;
    if (!validated && figures.pick !== 'the original') seen.set(`${figures.pick} ${figures.error} ${figures.frame_ms}`, figures);
  }
  document.getElementById('threshold-back').click();
  document.title = JSON.stringify([...seen.values()]);
)js";

// Small and short, with octaves enough for a variant to pay.
Result<std::filesystem::path> smallMarble(const std::filesystem::path& folder) {
  REPRISE_ASSIGN(Scenario scenario, readScenario(REPRISE_SOURCE_DIR "/shaders/marble/marble.toml"));
  scenario.defines = {{"OCTAVES", "20"}};
  scenario.width = 320;
  scenario.height = 180;
  scenario.frames = 24;
  scenario.periods = {1, 2, 4, 8};
  const std::filesystem::path file = folder / "marble.toml";
  REPRISE_TRY(writeFile(file, writeScenario(scenario, folder)));
  return file;
}

double figureOf(const std::optional<double>& measured, const std::optional<double>& predicted) { return measured ? *measured : predicted.value_or(std::nan("")); }

bool isFrontPoint(const RunResult& run, const RunVariant& variant, const nlohmann::json& figures) {
  for (const RunCandidate& candidate : run.candidates) {
    if (candidate.id != variant.candidate_id || figures.value("pick", "") != (candidate.name.empty() ? candidate.id : candidate.name)) continue;
    for (const RunConfiguration& one : candidate.configurations) {
      if (std::tie(one.strategy, one.pattern, one.filter, one.encoding, one.block_pixels) !=
          std::tie(variant.strategy, variant.pattern, variant.filter, variant.encoding, variant.block_pixels))
        continue;
      for (const RunPoint& point : one.points)
        if (point.period_frames == variant.period_frames && figures.value("error", -1.0) == figureOf(point.measured_error, point.predicted_error) &&
            figures.value("frame_ms", -1.0) == figureOf(point.measured_frame_ms, point.predicted_frame_ms) &&
            figures.value("cache", -1.0) == one.cache_bytes_per_pixel)
          return true;
    }
  }
  return false;
}

std::string titleOf(const OpenedPage& page) {
  const std::size_t start = page.dom.find("<title>") + 7;
  std::string title = page.dom.substr(start, page.dom.find("</title>") - start);
  for (std::size_t at; (at = title.find("&amp;")) != std::string::npos;) title.replace(at, 5, "&");
  return title;
}

class MarblePage : public BrowserTest {};

TEST_F(MarblePage, ShowsWhatTheResultSaysAtEveryStop) {
  const Result<std::filesystem::path> scenario = smallMarble(folder());
  ASSERT_TRUE(scenario.ok()) << formatError(scenario.error());
  const std::filesystem::path output = folder() / "out";
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "optimize", *scenario, "--max-error", "0.02", "--budget", "300", "-o", output});
  ASSERT_EQ(outcome.status, 0) << outcome.all();
  const Result<RunResult> run = resultFromJson(readFile(output / "result.json").value());
  ASSERT_TRUE(run.ok()) << formatError(run.error());
  ASSERT_TRUE(run->original.frame_ms && !run->front.empty()) << "nothing was measured, so there is no slider to read:\n" << outcome.all();
  const std::string html = readFile(output / "report.html").value();
  EXPECT_LT(html.size(), kMostPageBytes);

  const OpenedPage page = openPage(html, kReadEveryStop);
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.body().find("could not be drawn"), std::string::npos);
  EXPECT_NE(page.body().find("class=\"thumb"), std::string::npos);
  if (run->choice.kind == ChoiceKind::kVariant) {
    EXPECT_DOUBLE_EQ(page.tile("speedup"), *run->choice.measured_speedup);
    EXPECT_DOUBLE_EQ(page.tile("error"), *run->choice.measured_error);
    EXPECT_DOUBLE_EQ(page.tile("frame_ms"), *run->choice.measured_frame_ms);
  } else {
    EXPECT_DOUBLE_EQ(page.tile("frame_ms"), std::min(*run->original.frame_ms, run->original.with_prepass_ms.value_or(*run->original.frame_ms)));
  }
  const nlohmann::json stops = nlohmann::json::parse(titleOf(page), nullptr, false);
  ASSERT_TRUE(stops.is_array()) << titleOf(page);
  EXPECT_FALSE(stops.empty());
  for (const nlohmann::json& figures : stops)
    EXPECT_TRUE(std::any_of(run->front.begin(), run->front.end(), [&](const RunVariant& variant) { return isFrontPoint(*run, variant, figures); }))
        << figures.dump();
}

}  // namespace
}  // namespace reprise
