#include "fitting/solve/ceres_version.h"

#include <ceres/version.h>

namespace reprise {

// The first word of "2.1.0-eigen-(3.4.0)-...": what it was built with follows.
std::string ceresVersion() {
  const std::string text = CERES_VERSION_STRING;
  return text.substr(0, text.find('-'));
}

}  // namespace reprise
