// What measuring needs before its first job: the device, the store, the package of the original.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/measurements/store.h"
#include "profiler/training/measure.h"
#include "runtime/vulkan/context.h"

namespace reprise {

struct BenchOptions {
  std::string device;       // as ContextOptions::device
  std::string worker_path;  // this executable
  std::vector<std::string> metrics;  // that training needs besides the cheap ones
  std::function<bool()> interrupted;
};

struct Bench {
  Store store;
  Measuring measuring;      // without its store: set it once the bench lies where it stays
};

// Errors: those of Context::create.
Result<DeviceSummary> chosenDevice(const std::string& wanted);

// Errors: those of Store::open and storeVariant.
Result<Bench> openBench(const Subject& subject, const Workspace& workspace, const BenchOptions& options, const DeviceSummary& device);

}  // namespace reprise
