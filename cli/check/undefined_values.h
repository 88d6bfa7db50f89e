// Whether a shader may show values that nothing defines: what a device makes of them is no result to compare with.
#pragma once

#include "compiler/ir/prepare.h"

namespace reprise {

// False only where the prepared module shows that every value is defined: no OpUndef that anything takes, no variable without initializer, and every
// output stored as a whole on every way through the shader, and not read before. It is asked to spare a look at the image
// where nothing differs.
bool mayShowUndefined(const PreparedShader& shader);

}  // namespace reprise
