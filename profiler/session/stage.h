// What every kind of job needs: device, scenario, session, scene on the device, packages.
#pragma once

#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "profiler/session/job.h"
#include "profiler/session/scene_renderer.h"
#include "runtime/package/package.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/readback.h"

namespace reprise {

using JobListener = std::function<void(const JobProgress&)>;

// Members in order of construction: later ones refer to earlier ones, so a Stage stays where it is made.
struct Stage {
  Scenario scenario;                // with the color formats that are rendered to
  std::vector<std::string> given_formats;  // the scenario's own: one per output
  const SessionSpec* session = nullptr;
  Package original;
  std::vector<Package> passes;      // by pass of the scenario; of G-buffer passes
  std::deque<Package> packages;     // by entry
  std::unique_ptr<Context> context;
  std::unique_ptr<Commands> commands;
  std::unique_ptr<SceneRenderer> renderer;
  RenderTargets targets;
};

// Probes and comparisons with the original render to RGBA32F targets, so that no value is hidden by a format. Errors: those of readScenario, readPackage,
// checkBindings, Context and SceneRenderer; session.unknown, job.interface (kInput; a package made from other shaders).
Result<std::unique_ptr<Stage>> setStage(const Job& job);

// Evaluates a frame of the session, fills the uniforms and renders the passes before the shader in a submission of their own: once for
// all players, outside of every time that is measured. Errors: those of Commands::run.
Result<void> beginFrame(Stage& stage, int frame, double timeout_s = 20);

// The player of a package's variant, or of all entries; one whose requirements are missing here is an error (kMeasurement): player.requirement.
Result<Player> createPlayer(const Stage& stage, const Package& package);
Result<std::deque<Player>> createPlayers(const Stage& stage);
Result<Player> createOriginalPlayer(const Stage& stage);

// One byte per pixel: 1 where the frame that was rendered last drew something (its depth is not the clear value), else 0.
Result<std::vector<std::uint8_t>> coveredPixels(const Stage& stage, Readback& readback);

// What a payload's image holds, by value: signed integers lie in UINT images by their bits.
std::vector<float> payloadFloats(std::span<const std::byte> bytes, VkFormat format, const PayloadValue& payload);

// A result that says on which device it was made, and nothing else yet.
JobResult emptyResult(const Stage& stage);

// The number of frames that the job asks for.
int frameCount(const Job& job, const Stage& stage);

Result<JobResult> runErrors(const Job& job, const JobListener& progress);
Result<JobResult> runTimes(const Job& job, const JobListener& progress);
Result<JobResult> runProbe(const Job& job, const JobListener& progress);
Result<JobResult> runObjects(const Job& job, const JobListener& progress);
Result<JobResult> runImages(const Job& job, const JobListener& progress);
Result<JobResult> runReference(const Job& job, const JobListener& progress);
Result<JobResult> runLaws(const Job& job, const JobListener& progress);

}  // namespace reprise
