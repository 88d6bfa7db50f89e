// The differential test of the rewrites on one module: the module as given against every variant, frame by frame, on made-up inputs.
//
// The reference is the module as it was compiled or read, played in a process in which none of our passes ran (reference.h). First
// the prepared module, uncached, is held to it: a difference that is no rounding is `failed` `prepare`. Then the best candidate is
// taken in every strategy with nearest fetches, interleaved 4x4 blocks and the 32-bit float encoding. Each variant must equal the
// reference in all pixels at period 1, in the pixels that miss under motion at period 4, and everywhere in a world that stands still.
//
// What is rounding is said in judgement.h. A module whose image changes when undefined values become zero is untestable. `verified`
// needs inputs under which this says something: the original covers a tenth of the image, is finite and not constant, hits and misses
// occur, and a poisoned cache changes the image; other seeds and candidates are tried before giving up. Where nothing of the
// cache shows all laws are held all the same, and the verdict is `unshown`.
#pragma once

#include <functional>

#include "cli/check/reference/reference.h"
#include "cli/check/verdict.h"

namespace reprise {

// Whose fault it is if the process ends: glslang's or the file's, ours, the module's, ours.
enum class CheckStage { kCompile, kPrepare, kOriginal, kVariants };

struct CheckHooks {
  std::function<void(CheckStage)> enters;
  StartReference start_reference;
};

ModuleVerdict checkModule(const CheckRequest& request, const CheckHooks& hooks);

}  // namespace reprise
