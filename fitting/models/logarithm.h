// The logarithm model of the error family (error_model.h).
#pragma once

#include "fitting/models/error_model.h"

namespace reprise {

const ErrorModel& logarithmErrorModel();

}  // namespace reprise
