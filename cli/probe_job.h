// A job that looks at a scene before it is measured, at a quarter of the resolution, but at least 64 x 36 pixels.
#pragma once

#include "profiler/training/measure.h"

namespace reprise {

// Without entries and session. `frames` of each session.
Job probeJob(const Measuring& measuring, JobKind kind, int frames);

}  // namespace reprise
