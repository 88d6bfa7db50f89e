// How many floats a track yields.
#pragma once

#include <cstddef>

#include "profiler/scenario/scenario.h"

namespace reprise {

std::size_t trackSize(const Track& track);

}  // namespace reprise
