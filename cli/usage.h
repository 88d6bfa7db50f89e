// What is wrong with a command line.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace reprise {

// glslc's spelling: -std=450, -MD, -MF FILE. CLI11 wants two dashes before longer words. `words` in the order of the line.
std::vector<std::string> spelledForParser(const std::vector<std::string>& words);

// Help that spells options as they are typed.
std::shared_ptr<CLI::FormatterBase> helpFormatter();

// For options of numbers: what is wrong with a text, "" if nothing.
std::string expectPositive(const std::string& text);
std::string expectNotNegative(const std::string& text);

// True if errors are wanted as JSON. Looked up in the words, as a line that cannot be parsed may still say so.
bool wantsJsonErrors(const std::vector<std::string>& words);

// The mistakes of a line that `app` refused with `failure`, in the order of the line (kUsage): usage.command (an unknown one, with
// near names, or none), usage.option (an unknown one, with near names), usage.argument (one too many), usage.value (of an option;
// CLI11 tells the first one only).
Error usageError(const CLI::App& app, const CLI::ParseError& failure, const std::vector<std::string>& words);

}  // namespace reprise
