#include <array>

#include "fitting/models/constant.h"
#include "fitting/models/error_model.h"
#include "fitting/models/exponential.h"
#include "fitting/models/logarithm.h"
#include "fitting/models/power.h"

namespace reprise {

std::span<const ErrorModel> errorModels() {
  // The power law stands before Eq. 4: where points cannot decide, it promises less beyond the largest period.
  static const std::array<ErrorModel, 4> models = {constantErrorModel(), logarithmErrorModel(), powerErrorModel(),
                                                   exponentialErrorModel()};
  return models;
}

const ErrorModel* findErrorModel(const std::string& name) {
  for (const ErrorModel& model : errorModels()) {
    if (name == model.name) return &model;
  }
  return nullptr;
}

}  // namespace reprise
