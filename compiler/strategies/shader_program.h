// The user's pair of shaders, read and analysed: what every variant is made from.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "runtime/package/interface.h"

namespace reprise {

struct ShaderProgram {
  std::vector<std::uint32_t> vertex_words, fragment_words;  // as compiled: the original that is played
  Module vertex;                                            // calls inlined
  std::shared_ptr<const PreparedShader> fragment;           // shared, as the analysis points into it
  ShaderAnalysis analysis;                                  // of the fragment shader
  ShaderInterface interface;
  std::vector<SourceFile> sources;
  std::string hash;                                         // contentHash of both modules
};

// Errors: those of readModule, prepareForCaching and reflectInterface.
Result<ShaderProgram> readProgram(const CompiledShader& vertex, const CompiledShader& fragment, const ReflectOptions& options = {});

}  // namespace reprise
