// `reprise analyze`: every value of a shader as a candidate or with the reason why it is none.
#pragma once

#include <ostream>
#include <string>

#include "compiler/candidates/enumerate.h"
#include "compiler/source/compile.h"
#include "runtime/base/result.h"

namespace reprise {

struct AnalyzeArguments {
  std::string shader;        // path, "-" for standard input
  CompileOptions compile;    // stage is set to fragment
  bool json = false;
  bool all = false;          // list the values that are no candidates one by one, not only counted by reason
  bool annotate = false;     // the source with costs and candidates in the margin instead of the lists
  std::string depfile;       // -MF, "" for none
};

// Prints to `out`; the error of a bad shader is returned.
Result<void> analyzeShader(const AnalyzeArguments& arguments, std::ostream& out);

}  // namespace reprise
