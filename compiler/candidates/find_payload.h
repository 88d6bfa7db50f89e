// A payload as something that can be written down and found again in a later version of the shader.
//
// What identifies it is the structure of its slice (value_hashes.h): edits of the tail, of comments, of names and lines do not
// matter, a changed constant does. Name and place are hints, by which a payload that has changed is recognised and told of. Of a
// part of a chain the kept terms count; the others may change, come and go.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/candidates/enumerate.h"

namespace reprise {

struct IdentifiedValue {
  std::string slice;                      // hash of its structure; of a part of a chain: of the kept terms
  std::string shape;                      // the same with all constants alike
  std::vector<std::string> text;          // what the hash is of, to tell what has changed (slice_text.h); none in old choices
  std::string name, operation, type;      // hints
  std::string file;                       // without folders
  int line = 0;
  std::map<std::string, int> operations;  // of the slice, by opcode's name
  std::vector<std::string> inputs;        // sorted: "uniform Frame.gain"
  std::string chain;                      // of a part of a chain: "sum", ...
  std::vector<std::string> terms;         // the kept ones: hashes, "-" before those that are subtracted
  bool operator==(const IdentifiedValue&) const = default;
};

std::vector<IdentifiedValue> identifyPayload(const PreparedShader& shader, const ShaderAnalysis& analysis, const Candidate& candidate);

// The payload in this shader. Errors (kInput): choice.stale (a value is gone or its slice has changed; says what was edited and where, and
// where there is no text what it has more or less of), choice.unsafe
// (it is there, but the rest of the shader has changed so that it cannot be kept any more).
Result<Candidate> findPayload(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources,
                              const std::vector<IdentifiedValue>& payload);

}  // namespace reprise
