// What caching will smear, found in the shader and the scenario without any measurement: payloads that change with a uniform that
// varies over time (a hit shows the value of up to a period ago), and texture coordinates in a payload's slice that move with one
// (the texture scrolls; what is kept stands still until the next refresh). What follows the camera alone is not told: that is what
// reprojection and the error measurements are for.
#pragma once

#include <string>
#include <vector>

#include "cli/subject.h"

namespace reprise {

// One sentence each, of the candidates with these ids, in the order of the candidates. Empty where nothing moves but what is drawn and
// seen.
std::vector<std::string> smearWarnings(const Subject& subject, const std::vector<std::string>& candidate_ids);

}  // namespace reprise
