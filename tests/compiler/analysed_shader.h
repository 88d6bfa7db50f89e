// Shaders of these tests: GLSL text, or files of shaders/, brought as far through the compiler as a test needs.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/strategies/shader_program.h"

namespace reprise {

CompiledShader compiled(std::string_view text, const std::string& name = "test.frag");
Module moduleOf(std::string_view text, const std::string& name = "test.frag");

// Never moved: the analysis points into the prepared shader.
struct AnalysedShader {
  std::vector<SourceFile> sources;
  PreparedShader shader;
  ShaderAnalysis analysis;
  std::vector<Candidate> candidates;

  // The inputs of a candidate or of a dropped value by its name in the source, sorted: "varying p".
  std::vector<std::string> inputsOf(const std::string& name) const;
  // The value with this name; fails the program if there is none.
  const Candidate& named(const std::string& name) const;
};

std::unique_ptr<AnalysedShader> analysed(std::string_view text, const CandidateOptions& options = {});
// Keeps every value that there is a reason to keep, however cheap.
std::unique_ptr<AnalysedShader> analysedWhole(std::string_view text);

// All .vert and .frag files of shaders/, sorted.
std::vector<std::string> shippedShaders();
std::vector<std::string> shippedFragmentShaders();
// A fragment shader of shaders/ with the vertex shader of its scenario.
ShaderProgram shippedProgram(const std::string& fragment_file);

// "loop" of ".../laws/loop/loop.frag", for names of parametrized tests.
std::string stemOf(const std::string& file);

// Instructions of a function by opcode.
int countOf(const Function& function, spv::Op opcode);
// Calls of an extended instruction (GLSLstd450: 13 Sin, 27 Exp) in a function.
int countOfExtended(const Function& function, std::uint32_t number);

}  // namespace reprise
