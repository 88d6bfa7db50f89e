// Loops that are counted and left.
#include "compiler/ir/limit_loops.h"

#include <gtest/gtest.h>

#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

std::string shaderOf(const std::string& body) {
  return "#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\nvoid main() {\nfloat sum = 0.0;\n" + body +
         "\ncolor = vec4(sum);\n}\n";
}

TEST(LimitLoops, EveryFormOfLoopStaysValid) {
  for (const char* body : {"for (int i = 0; i < int(p.x); ++i) sum += sin(p.y);", "while (sum < p.x) sum += p.y;",
                           "do { sum += p.y; } while (sum < p.x);", "for (;;) { sum += p.y; if (sum > p.x) break; }",
                           "for (int i = 0; i < int(p.x); ++i) { for (int j = 0; j < i; ++j) sum += p.y; if (sum > 9.0) return; }"}) {
    const Module module = moduleOf(shaderOf(body));
    const Module limited = limitLoops(module, 100);
    const Result<void> valid = validateModule(writeModule(limited));
    EXPECT_TRUE(valid.ok()) << body << ": " << valid.error().message;
    EXPECT_GE(countOf(limited.functions.front(), spv::Op::OpKill), 1) << body;
  }
}

TEST(LimitLoops, AnExitOnTrueIsTakenOrTheCountIsTooHigh) {
  const Module limited = limitLoops(moduleOf(shaderOf("while (sum < p.x) sum += p.y;")), 100);
  EXPECT_EQ(countOf(limited.functions.front(), spv::Op::OpLogicalAnd) + countOf(limited.functions.front(), spv::Op::OpLogicalOr), 1);
}

}  // namespace
}  // namespace reprise
