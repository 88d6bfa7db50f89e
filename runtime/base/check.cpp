#include "runtime/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace reprise {

void failCheck(const char* condition, const char* file, int line, const std::string& values) {
  std::fprintf(stderr, "%s:%d: bug in Reprise: check failed: %s [%s]\n", file, line, condition, values.c_str());
  std::fflush(nullptr);
#ifdef REPRISE_FUZZ
  std::abort();  // libFuzzer keeps the input of what crashes, not of what exits
#endif
  std::_Exit(70);
}

}  // namespace reprise
