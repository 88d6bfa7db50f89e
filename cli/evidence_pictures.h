// Pictures for the report: one frame of several points of the front, and a strip through the validation session.
#pragma once

#include <optional>
#include <vector>

#include "cli/fit.h"
#include "cli/report/evidence.h"
#include "cli/subject.h"
#include "cli/trained.h"
#include "cli/workspace.h"
#include "profiler/training/measure.h"

namespace reprise {

struct PictureSubject {
  const Subject& subject;
  const Workspace& workspace;
  const Measuring& measuring;
  const Training& training;
  const FittedTraining& fitted;
};

// What is shown, the first one first: it has the strip. The choice, then points spread over the front, then the best point of
// candidates that have none yet; at most kMostPictures.
inline constexpr std::size_t kMostPictures = 8;
std::vector<TradeoffPoint> pointsToShow(const std::optional<TradeoffPoint>& choice, const Selection& selection,
                                        const FittedTraining& fitted, double max_error);

// Renders them in the given validation session and fills session, frame, original, pictures and strip. Nothing where no point is given.
// Errors: kInterrupted, kMachine; kMeasurement where a variant crashes or hangs.
Result<void> makePictures(const PictureSubject& in, const std::vector<TradeoffPoint>& points, const std::string& session,
                          RunEvidence& evidence);

}  // namespace reprise
