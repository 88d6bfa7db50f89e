// Findings made short: lines are taken out of a shader as long as it still shows what it was kept for.
#pragma once

#include <functional>
#include <string>

namespace reprise {

// `shows` holds for `text` and is asked for every attempt, valid or not. Lines are taken out one statement at a time: single lines, whole
// blocks in braces, and the braces alone. The result shows it, too, and no further step of these kinds does.
std::string reduceShader(const std::string& text, const std::function<bool(const std::string&)>& shows);

}  // namespace reprise
