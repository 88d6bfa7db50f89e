#include "cli/commands/devices.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/vulkan/context.h"

namespace reprise {
namespace {

const char* clockOf(const DeviceSummary& device) { return device.is_cpu ? "process CPU time" : "time stamps"; }

}  // namespace

Result<void> listDevicesCommand(bool json, std::ostream& out) {
  REPRISE_ASSIGN(const std::vector<DeviceSummary> devices, listDevices());
  nlohmann::json list = nlohmann::json::array();
  for (const DeviceSummary& device : devices) {
    if (json) {
      list.push_back({{"index", device.index}, {"name", device.name}, {"driver", device.driver},
                      {"api_version", device.api_version}, {"cpu", device.is_cpu}, {"clock", clockOf(device)}});
    } else {
      out << device.index << "  " << device.name << "\n   driver " << device.driver << ", Vulkan " << device.api_version
          << ", measured by " << clockOf(device) << "\n";
    }
  }
  if (json) out << list.dump(2) << "\n";
  return {};
}

}  // namespace reprise
