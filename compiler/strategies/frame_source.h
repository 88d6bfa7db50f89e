// Reprise's own GLSL (compiler/strategies/glsl), embedded at build time, with its includes expanded and macros set.
#pragma once

#include <map>
#include <string>

#include "compiler/ir/module.h"
#include "compiler/source/compile.h"

namespace reprise {

// The frame `name` ("branch.frag") compiled with the macros of glsl/*.glsl. Our own source: a compile error is a bug.
Module compileFrame(const std::string& name, ShaderStage stage, const std::map<std::string, std::string>& macros);

}  // namespace reprise
