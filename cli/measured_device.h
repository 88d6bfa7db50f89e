// The device that a run measures on, and what of it decides which variants there can be.
#pragma once

#include <string>

#include "cli/report/result.h"
#include "cli/subject.h"
#include "runtime/vulkan/context.h"
#include "runtime/vulkan/lane_probe.h"

namespace reprise {

struct MeasuredDevice {
  DeviceSummary summary;
  LaneLoads lanes;  // probed
};

// By index or a part of the name; empty: the first. Errors: those of Context::create and probeLanes.
Result<MeasuredDevice> openMeasuredDevice(const std::string& wanted);

// The processor of this machine and its cores: "AMD EPYC 7B13, 2 cores"; "" where it does not tell.
std::string processorName();

// As results tell it. host: processor and cores.
RunDevice describeDevice(const MeasuredDevice& device, const std::string& host);

// From here on the subject's variants are those that the device plays right.
void limitTo(const MeasuredDevice& device, Subject& subject);

}  // namespace reprise
