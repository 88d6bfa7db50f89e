// A frame shader (Reprise's own GLSL: lookup, refresh, store) joined with the bodies made from the user's shader.
//
// The frame declares empty functions and private variables by name; linking makes its calls reach the bodies and the bodies'
// payload variables the frame's. The result has one entry point, the frame's main, with the execution modes of both.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "compiler/ir/module.h"

namespace reprise {

struct FrameBindings {
  std::map<std::string, std::uint32_t> functions;  // function of the frame, by name -> function id of the host
  std::map<std::string, std::uint32_t> variables;  // private variable of the frame, by name -> global variable id of the host
  std::map<std::string, std::uint32_t> shared;     // variable of the frame, by name -> the host's of its type, which it becomes
};

// host: the user's module with its bodies as entry points. frame: compiled by the front end, one entry point. Names in
// `bindings` that the frame lacks are a bug of ours (checked). Built-in inputs that both use become one variable, but for those of the host
// that become a private variable of the frame.
Module linkFrame(const Module& host, const Module& frame, const FrameBindings& bindings);

}  // namespace reprise
