// An instance, a device and a queue of our own, for tools and tests. Applications bring theirs.
#pragma once

#include <vulkan/vulkan_core.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/vulkan/device.h"

namespace reprise {

struct DeviceSummary {
  int index = 0;
  std::string name;         // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;       // "llvmpipe, Mesa 22.3.6 (LLVM 15.0.6)"
  std::string api_version;  // "1.3.230"
  bool is_cpu = false;
};

struct ContextOptions {
  std::string device;       // index, or a part of the name; empty: the first that is usable
  bool validation = false;  // the Khronos layer with synchronization validation; its messages are collected
};

class Context {
 public:
  // Errors (kMachine): device.none (no loader, driver or device), device.unknown (none matches; lists them),
  // device.feature (no dynamic rendering), device.validation (the layer is not installed).
  static Result<Context> create(const ContextOptions& options);
  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  const DeviceView& view() const;
  const DeviceSummary& summary() const;
  VkInstance instance() const;
  VkQueue queue() const;
  std::uint32_t queue_family() const;
  double timestamp_period_ns() const;
  bool has_timestamps() const;
  bool has_conditional_rendering() const;  // VK_EXT_conditional_rendering, enabled
  FunctionSource functions() const;
  // What the validation layer said so far: errors, warnings and hazards, one text each.
  const std::vector<std::string>& validation_messages() const;

 private:
  struct State;
  explicit Context(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// All devices that the loader finds. Error: device.none.
Result<std::vector<DeviceSummary>> listDevices();

}  // namespace reprise
