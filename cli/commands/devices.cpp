#include "cli/commands/devices.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/vulkan/context.h"
#include "runtime/vulkan/lane_probe.h"

namespace reprise {
namespace {

const char* clockOf(const DeviceSummary& device) { return device.is_cpu ? "process CPU time" : "time stamps"; }

Result<LaneLoads> lanesOf(const DeviceSummary& device) {
  ContextOptions options;
  options.device = std::to_string(device.index);
  REPRISE_ASSIGN(const Context context, Context::create(options));
  return probeLanes(context);
}

nlohmann::json toJson(const DeviceSummary& device, const Result<LaneLoads>& lanes) {
  nlohmann::json json = {{"index", device.index}, {"name", device.name}, {"driver", device.driver}, {"api_version", device.api_version},
                         {"cpu", device.is_cpu}, {"clock", clockOf(device)}, {"lanes", nullptr}};
  if (lanes.ok()) json["lanes"] = {{"helper", lanes->helper}, {"rejected", lanes->rejected}, {"discarded", lanes->discarded}};
  return json;
}

}  // namespace

Result<void> listDevicesCommand(bool json, std::ostream& out) {
  REPRISE_ASSIGN(const std::vector<DeviceSummary> devices, listDevices());
  nlohmann::json list = nlohmann::json::array();
  for (const DeviceSummary& device : devices) {
    const Result<LaneLoads> lanes = lanesOf(device);
    if (json) {
      list.push_back(toJson(device, lanes));
    } else {
      out << device.index << "  " << device.name << "\n   driver " << device.driver << ", Vulkan " << device.api_version
          << ", measured by " << clockOf(device) << "\n   pixels that are not drawn read storage buffers for their neighbours' derivatives: "
          << (lanes.ok() ? describeLanes(*lanes) : "not known; " + lanes.error().message) << "\n";
    }
  }
  if (json) out << list.dump(2) << "\n";
  return {};
}

}  // namespace reprise
