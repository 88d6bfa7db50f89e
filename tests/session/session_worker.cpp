// A measuring process and nothing else.
#include "profiler/session/job.h"

int main() { return reprise::runWorker(); }
