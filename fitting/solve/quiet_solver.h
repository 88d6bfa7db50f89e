// Ceres logs some of its failures through glog, whatever its own options say. Here they are verdicts; nothing is to be printed.
#pragma once

namespace reprise {

// Lets glog print fatal errors only. A setting of the whole process, because glog has no other.
void silenceSolverLog();

}  // namespace reprise
