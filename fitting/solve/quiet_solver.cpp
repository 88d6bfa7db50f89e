#include "fitting/solve/quiet_solver.h"

#include <glog/logging.h>

namespace reprise {

void silenceSolverLog() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

}  // namespace reprise
