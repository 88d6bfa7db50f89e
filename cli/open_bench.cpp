#include "cli/open_bench.h"

#include "cli/train.h"
#include "cli/version.h"

namespace reprise {

Result<DeviceSummary> chosenDevice(const std::string& wanted) {
  ContextOptions options;
  options.device = wanted;
  REPRISE_ASSIGN(const Context context, Context::create(options));
  return context.summary();
}

Result<Bench> openBench(const Subject& subject, const Workspace& workspace, const BenchOptions& options, const DeviceSummary& device) {
  REPRISE_ASSIGN(Store store, Store::open(workspace.storeFile()));
  VariantOptions original = baseOptions(subject, {});
  original.strategy = "original";
  REPRISE_ASSIGN(const StoredVariant stored,
                 storeVariant(workspace, subject.program, subject.candidates.empty() ? Candidate{} : subject.candidates[0], original, subject.limits));
  Bench bench{std::move(store), {}};
  Measuring& measuring = bench.measuring;
  measuring.base.shader_hash = subject.program.hash;
  measuring.base.scenario_hash = subject.scenario.hash;
  measuring.base.device = device.name;
  measuring.base.driver = device.driver;
  measuring.base.width = subject.scenario.width;
  measuring.base.height = subject.scenario.height;
  measuring.base.seed = subject.scenario.seed;
  measuring.base.tool_version = kToolVersion;
  measuring.scenario_path = workspace.scenarioFile().string();
  measuring.original_dir = stored.dir;
  measuring.device = options.device;
  measuring.metrics = options.metrics;
  measuring.supervisor.worker_path = options.worker_path;
  measuring.supervisor.interrupted = options.interrupted;
  return bench;
}

}  // namespace reprise
