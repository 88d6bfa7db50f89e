#include "cli/measured_device.h"

#include <fmt/format.h>

#include <fstream>

namespace reprise {

Result<MeasuredDevice> openMeasuredDevice(const std::string& wanted) {
  ContextOptions options;
  options.device = wanted;
  REPRISE_ASSIGN(const Context context, Context::create(options));
  REPRISE_ASSIGN(const LaneLoads lanes, probeLanes(context));
  return MeasuredDevice{context.summary(), lanes};
}

RunDevice describeDevice(const MeasuredDevice& device, const std::string& host) {
  return {device.summary.name, device.summary.driver, device.summary.is_cpu, host,
          RunLanes{device.lanes.helper, device.lanes.rejected, device.lanes.discarded}};
}

void limitTo(const MeasuredDevice& device, Subject& subject) {
  subject.limits.rejected_lanes_load = device.lanes.rejected;
  subject.limits.device = device.summary.name;
}

std::string processorName() {
  std::ifstream stream("/proc/cpuinfo");
  std::string line, name;
  int cores = 0;
  while (std::getline(stream, line)) {
    if (line.rfind("processor", 0) == 0) ++cores;
    if (line.rfind("model name", 0) == 0 && name.empty()) name = line.substr(line.find(':') + 2);
  }
  return name.empty() ? "" : fmt::format("{}, {} cores", name, cores);
}

}  // namespace reprise
