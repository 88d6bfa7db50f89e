// JSON of jobs' answers, for the .cpp files of this folder. The reader throws std::exception on damage.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "profiler/session/job.h"

namespace reprise {

nlohmann::json resultJson(const JobResult& result);
JobResult resultFrom(const nlohmann::json& from);

nlohmann::json errorJson(const Error& error);
Error errorFrom(const nlohmann::json& from);

}  // namespace reprise
