#include "compiler/source/glslang_log.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>
#include <vector>

namespace reprise {
namespace {

struct LoggedError {
  Place place;
  std::string token;
  std::string text;
};

// glslang's grammar names of punctuation; keywords are named by their own spelling in capitals.
constexpr std::array<std::pair<std::string_view, std::string_view>, 24> kPunctuation = {{
    {"LEFT_PAREN", "("}, {"RIGHT_PAREN", ")"}, {"LEFT_BRACKET", "["}, {"RIGHT_BRACKET", "]"},
    {"LEFT_BRACE", "{"}, {"RIGHT_BRACE", "}"}, {"COMMA", ","},        {"SEMICOLON", ";"},
    {"COLON", ":"},      {"EQUAL", "="},       {"BANG", "!"},         {"DASH", "-"},
    {"TILDE", "~"},      {"PLUS", "+"},        {"STAR", "*"},         {"SLASH", "/"},
    {"PERCENT", "%"},    {"LEFT_ANGLE", "<"},  {"RIGHT_ANGLE", ">"},  {"VERTICAL_BAR", "|"},
    {"CARET", "^"},      {"AMPERSAND", "&"},   {"QUESTION", "?"},     {"DOT", "."},
}};

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return std::string(text);
}

std::string_view lineOf(std::string_view text, int line) {
  for (int current = 1; current < line; ++current) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

// Column of `token` as a word of its own, from 1; 0 if it is not in the line.
int columnOf(std::string_view line, std::string_view token) {
  if (token.empty()) return 0;
  for (std::size_t at = line.find(token); at != std::string_view::npos; at = line.find(token, at + 1)) {
    const std::size_t end = at + token.size();
    const bool joined_before = at > 0 && isWordCharacter(token.front()) && isWordCharacter(line[at - 1]);
    const bool joined_after =
        end < line.size() && isWordCharacter(token.back()) && isWordCharacter(line[end]);
    if (!joined_before && !joined_after) return static_cast<int>(at) + 1;
  }
  return 0;
}

// What the source says for the grammar name in "syntax error, unexpected NAME, expecting ...".
std::string unexpectedToken(std::string_view text) {
  constexpr std::string_view kMarker = "unexpected ";
  const std::size_t at = text.find(kMarker);
  if (at == std::string_view::npos) return {};
  std::string_view name = text.substr(at + kMarker.size());
  const auto end = std::find_if_not(name.begin(), name.end(), isWordCharacter);
  name = name.substr(0, static_cast<std::size_t>(end - name.begin()));
  for (const auto& [grammar_name, spelling] : kPunctuation) {
    if (grammar_name == name) return std::string(spelling);
  }
  if (name == "IDENTIFIER") return {};
  std::string keyword(name);
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return keyword;
}

// "FILE:LINE: rest"; names of known files are taken first, since a name may hold colons itself.
std::optional<Place> takePlace(std::string_view& text, std::span<const SourceFile> sources) {
  std::size_t colon = std::string_view::npos;
  for (const SourceFile& source : sources) {
    if (text.starts_with(source.path + ":")) colon = source.path.size();
  }
  if (colon == std::string_view::npos) colon = text.find(':');
  while (colon != std::string_view::npos) {
    std::size_t end = colon + 1;
    int line = 0;
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) && line < 100'000'000) {
      line = line * 10 + (text[end++] - '0');
    }
    if (end > colon + 1 && text.substr(end).starts_with(": ")) {
      Place place{std::string(text.substr(0, colon)), line, 0};
      text.remove_prefix(end + 2);
      return place;
    }
    colon = text.find(':', colon + 1);
  }
  return std::nullopt;
}

LoggedError readError(std::string_view text, std::span<const SourceFile> sources) {
  LoggedError logged;
  const std::optional<Place> place = takePlace(text, sources);
  if (!place) {
    logged.text = trimmed(text);
    return logged;
  }
  logged.place = *place;
  const std::size_t separator = text.starts_with("'") ? text.find("' : ") : std::string_view::npos;
  if (separator != std::string_view::npos) {
    logged.token = std::string(text.substr(1, separator - 1));
    text.remove_prefix(separator + 4);
  }
  logged.text = trimmed(text);
  if (!logged.token.empty()) {
    logged.text = "'" + logged.token + "': " + logged.text;
  } else {
    logged.token = unexpectedToken(logged.text);
  }
  const auto source = std::find_if(sources.begin(), sources.end(),
                                   [&](const SourceFile& file) { return file.path == logged.place.file; });
  if (source != sources.end()) {
    logged.place.column = columnOf(lineOf(source->text, logged.place.line), logged.token);
  }
  return logged;
}

}  // namespace

Error errorOfLog(std::string_view log, const std::string& main_path, std::span<const SourceFile> sources) {
  constexpr std::string_view kPrefix = "ERROR: ";
  std::vector<LoggedError> errors;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string_view line = log.substr(0, end);
    log.remove_prefix(std::min(end + 1, log.size()));
    // The closing "N compilation errors" and "compilation terminated" repeat what is known.
    if (!line.starts_with(kPrefix) ||
        line.find(" compilation errors.  No code generated.") != std::string_view::npos ||
        line.find("compilation terminated") != std::string_view::npos) {
      continue;
    }
    errors.push_back(readError(line.substr(kPrefix.size()), sources));
  }
  Error error{
      ErrorKind::kInput, "source.syntax", "glslang rejects the shader without saying why", {main_path, 0, 0}};
  if (errors.empty()) return error;
  const auto placed = std::find_if(errors.begin(), errors.end(),
                                   [](const LoggedError& logged) { return logged.place.line > 0; });
  if (placed != errors.end()) std::rotate(errors.begin(), placed, placed + 1);
  std::vector<Error> found;
  for (const LoggedError& logged : errors)
    found.push_back({error.kind, error.code, logged.text, logged.place.line > 0 ? logged.place : error.place});
  return mergeErrors(std::move(found));
}

}  // namespace reprise
