// Motion that is not there: where reprojection follows nothing, hits show what was at the same pixel before, and the errors measured are
// those of a still image that changes. A vertex shader whose position reads nothing is refused; one whose position reads values that
// stay the same is told beside the result.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/subject.h"
#include "cli/trained.h"
#include "compiler/transforms/position_slice.h"

namespace reprise {

// Errors: motion.none (kRefused), where gl_Position reads no uniform, push constant, buffer or texture, unless the scenario says that
// there is no motion. A shader whose position cannot be sliced is left to the variants, which are refused for that.
Result<void> expectMotion(const Subject& subject);

// Whether what the position reads is the same in all frames of every session, for each object: then the displacement from the previous
// position is zero in every pixel. False where it reads what the scenario does not give (buffers, textures).
bool standsStill(const Scenario& scenario, const ShaderInterface& interface, const std::vector<PositionInput>& inputs);

// The least difference that an encoding keeps of a channel whose values lie in [low, high]; of integers 0, as each is kept.
double encodingStep(Encoding encoding, bool integer, float low, float high);

// The warning motion.suspect: the subject stands still while a payload changes by more than the step of the encoding that training
// begins with. The payload is that of `chosen`, a candidate's id; where that is empty, the first of the probed ones that changes.
std::optional<std::string> suspectMotion(const Subject& subject, const Training& training, const std::string& chosen);

}  // namespace reprise
