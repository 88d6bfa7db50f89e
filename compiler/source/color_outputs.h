// The colour outputs of a fragment module, one for each location that it writes.
#pragma once

#include <vector>

#include "runtime/base/result.h"
#include "runtime/package/interface.h"

namespace spirv_cross {
class Compiler;
struct ShaderResources;
}  // namespace spirv_cross

namespace reprise {

// By location. Variables that share a location by their components become one output, which bears the first one's name and
// reaches to the last component. Errors: source.unsupported (kInput), matrices and 64-bit numbers; shader.dual_source (kRefused).
Result<std::vector<FragmentOutput>> colorOutputs(const spirv_cross::Compiler& compiler, const spirv_cross::ShaderResources& resources);

}  // namespace reprise
