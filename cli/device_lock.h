// One run at a time measures on a device: times taken side by side are worth nothing. The lock is a file in the folder for temporary
// files, held by the kernel for a living process, so that a dead one holds nothing; what it says of its holder is only told.
#pragma once

#include <functional>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

class DeviceLock {
 public:
  DeviceLock() = default;
  DeviceLock(DeviceLock&& other) noexcept;
  DeviceLock& operator=(DeviceLock&& other) noexcept;
  ~DeviceLock();

  struct Waiting {
    std::function<void(const std::string& holder)> told;  // once, before waiting: "process 4711: reprise optimize marble.toml"
    std::function<bool()> interrupted;
  };

  // Waits until it is free. `command` tells others who holds it. Without a folder that can be written to there is no lock, and no error.
  // Errors: kInterrupted run.interrupted.
  static Result<DeviceLock> take(const std::string& device, const std::string& command, const Waiting& waiting);

 private:
  int descriptor_ = -1;
};

// The file that stands for a device.
std::string deviceLockFile(const std::string& device);

}  // namespace reprise
