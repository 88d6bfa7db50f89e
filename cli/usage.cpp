#include "cli/usage.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>

#include "profiler/scenario/near_names.h"

namespace reprise {
namespace {

// NaN where it is none.
double numberOf(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::numeric_limits<double>::quiet_NaN() : number;
}

bool isGlslcWord(const std::string& name) {
  return name == "std" || name == "M" || name == "MD" || name == "MF" || name == "MT";
}

// "--MD" and "--std" as they are typed.
std::string asTyped(const std::string& option) {
  return option.starts_with("--") && isGlslcWord(option.substr(2)) ? option.substr(1) : option;
}

std::string withoutDashes(const std::string& word) { return word.substr(std::min(word.find_first_not_of('-'), word.size())); }

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    return is_positional ? name : asTyped(name);
  }
};

Error mistake(const std::string& kind, const std::string& message) { return {ErrorKind::kUsage, "usage." + kind, message, {}}; }

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) names.push_back(command->get_name());
  return names;
}

// Without their dashes, which are no part of what may be misspelt.
std::vector<std::string> optionNames(const CLI::App& app, const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : {&command, &app})
    for (const CLI::Option* option : one->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back(name);
      for (const std::string& name : option->get_snames()) names.push_back(name);
    }
  return names;
}

std::string dashed(const std::string& name) { return (name.size() == 1 || isGlslcWord(name) ? "-" : "--") + name; }

Error unknownOption(const std::string& word, const std::string& call, const std::vector<std::string>& known) {
  const std::string option = word.substr(0, word.find('='));
  std::string message = "unknown option '" + option + "'";
  std::string near;
  for (const std::string& name : nearNames(withoutDashes(option), known)) near += (near.empty() ? "" : " or ") + ("'" + dashed(name) + "'");
  return mistake("option", message + (near.empty() ? "; '" + call + " --help' lists those that there are" : "; did you mean " + near + "?"));
}

// What nobody took, in the order of the line.
std::vector<std::string> leftWords(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> left = app.remaining(true), ordered;
  for (const std::string& word : words) {
    const std::string spelled = spelledForParser({word}).front();
    const auto found = std::find(left.begin(), left.end(), spelled);
    if (found == left.end()) continue;
    ordered.push_back(word);
    left.erase(found);
  }
  ordered.insert(ordered.end(), left.begin(), left.end());  // short options that were typed together
  return ordered;
}

bool isOption(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

// "Could not convert: --jobs = many" as a sentence that begins small.
std::string sentenceOf(const CLI::ParseError& failure) {
  std::string text = failure.what();
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

std::vector<std::string> spelledForParser(const std::vector<std::string>& words) {
  std::vector<std::string> spelled;
  for (const std::string& word : words) {
    const bool glslc = word.starts_with("-std=") || (word.starts_with("-M") && isGlslcWord(word.substr(1)));
    spelled.push_back(glslc ? "-" + word : word);
  }
  return spelled;
}

std::shared_ptr<CLI::FormatterBase> helpFormatter() { return std::make_shared<HelpFormatter>(); }

std::string expectPositive(const std::string& text) {
  return numberOf(text) > 0 ? "" : "'" + text + "' is not a number above 0";
}

std::string expectNotNegative(const std::string& text) {
  return numberOf(text) >= 0 ? "" : "'" + text + "' is not a number of at least 0";
}

bool wantsJsonErrors(const std::vector<std::string>& words) {
  bool json = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].starts_with("--error-format=")) json = words[i].ends_with("=json");
    if (words[i] == "--error-format" && i + 1 < words.size()) json = words[i + 1] == "json";
  }
  return json;
}

Error usageError(const CLI::App& app, const CLI::ParseError& failure, const std::vector<std::string>& words) {
  const std::vector<CLI::App*> commands = const_cast<CLI::App&>(app).get_subcommands();
  const std::vector<std::string> left = leftWords(app, words);
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const std::string call = "reprise" + (commands.empty() ? std::string() : " " + command.get_name());
  std::vector<Error> errors;
  const auto first_argument = std::find_if_not(left.begin(), left.end(), isOption);
  if (commands.empty() && first_argument != left.end()) {
    // What follows belongs to a command that nobody knows.
    return mistake("command", "unknown command '" + *first_argument + "'" + suggestNames(*first_argument, commandNames(app)));
  }
  const std::vector<std::string> known = optionNames(app, command);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (isOption(left[i])) {
      errors.push_back(unknownOption(left[i], call, known));
    } else if (i == 0 || !isOption(left[i - 1])) {  // behind an unknown option stands its value
      errors.push_back(mistake("argument", "unexpected argument '" + left[i] + "'; '" + call + " --help' tells what is expected"));
    }
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&failure) == nullptr) {
    if (!commands.empty()) {
      errors.push_back(mistake("value", sentenceOf(failure)));
    } else if (errors.empty()) {
      errors.push_back(dynamic_cast<const CLI::RequiredError*>(&failure) != nullptr
                           ? mistake("command", "no command is named" + suggestNames("", commandNames(app)))
                           : mistake("value", sentenceOf(failure)));
    }
  }
  if (errors.empty()) errors.push_back(mistake("value", sentenceOf(failure)));
  return mergeErrors(std::move(errors));
}

}  // namespace reprise
