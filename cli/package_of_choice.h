// From a choice to the package that ships. `optimize` and `emit` both come through here, so that they write the same bytes.
#pragma once

#include <string>
#include <vector>

#include "cli/choice.h"
#include "cli/report/result.h"
#include "cli/subject.h"
#include "runtime/package/package.h"

namespace reprise {

struct ChosenVariant {
  Candidate candidate;
  VariantOptions options;
};

// The choice of a run as a file: `variant` is null where the original was chosen. `result` tells what was measured.
Choice describeChoice(const Subject& subject, const ChosenVariant* variant, const RunResult& result);

// The chosen payload in the subject's shader as it is now. Errors: choice.stale, choice.unsafe (find_payload.h), motion.none
// (motion.h).
Result<ChosenVariant> variantOf(const Subject& subject, const Choice& choice);

// `variant` null: of the original alone. Places are relative to the scenario's folder, so that no machine's paths are in it. Errors: of
// buildPackage.
Result<Package> shippedPackage(const Subject& subject, const ChosenVariant* variant);

// Every file that the package depends on, each once: scenario, shaders, what they include, textures, models.
std::vector<std::string> dependenciesOf(const Subject& subject);

}  // namespace reprise
