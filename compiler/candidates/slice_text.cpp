#include "compiler/candidates/slice_text.h"

#include <string_view>
#include <unordered_map>

namespace reprise {
namespace {

constexpr int kMostNesting = 5;       // of operations in one line
constexpr int kMostReadNesting = 64;
constexpr const char* kCutOff = "...";

class TextWriter {
 public:
  explicit TextWriter(const SliceTerms& terms) : terms_(terms), uses_(terms.size(), 0), label_(terms.size(), 0) {
    for (const SliceTerm& term : terms)
      for (const int part : term.parts) ++uses_[static_cast<std::size_t>(part)];
  }

  std::vector<std::string> lines(std::size_t most_bytes) {
    std::vector<std::string> lines = {"value = " + partText(0, 0)};
    std::size_t bytes = lines[0].size();
    for (std::size_t next = 0; next < named_.size(); ++next) {
      std::string line = "#" + std::to_string(next + 1) + " = " + bodyOf(named_[next], 0);
      bytes += line.size() + 1;
      if (bytes > most_bytes) {
        lines.push_back(kCutOff);
        break;
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  int nextLabel(int term) {
    named_.push_back(term);
    return static_cast<int>(named_.size());
  }

  std::string bodyOf(int term, int nesting) {
    const SliceTerm& whole = terms_[static_cast<std::size_t>(term)];
    std::string text = whole.head;
    for (std::size_t i = 0; i < whole.parts.size(); ++i) text += (i == 0 ? "(" : ", ") + partText(whole.parts[i], nesting + 1);
    return whole.parts.empty() ? text : text + ")";
  }

  std::string partText(int part, int nesting) {
    const std::size_t at = static_cast<std::size_t>(part);
    const SliceTerm& term = terms_[at];
    const int uses = uses_[at] + (part == 0);  // the first line is a use of the whole
    const bool inside = label_[at] == 0 && (term.parts.empty() || (uses == 1 && nesting < kMostNesting));
    if (inside) return bodyOf(part, nesting);
    if (label_[at] == 0) label_[at] = nextLabel(part);
    return "#" + std::to_string(label_[at]);
  }

  const SliceTerms& terms_;
  std::vector<int> uses_, label_;
  std::vector<int> named_;  // terms by label - 1
};

class TextReader {
 public:
  std::optional<SliceTerms> read(const std::vector<std::string>& lines) {
    if (lines.empty() || !lines[0].starts_with("value = ")) return std::nullopt;
    newTerm("");
    for (const std::string& line : lines) {
      if (line == kCutOff) break;
      const std::size_t equals = line.find(" = ");
      if (equals == std::string::npos) return std::nullopt;
      const std::string_view name = std::string_view(line).substr(0, equals);
      rest_ = std::string_view(line).substr(equals + 3);
      const int term = name == "value" ? 0 : labelled(name);
      if (!readInto(term, 0) || !rest_.empty()) return std::nullopt;
    }
    return std::move(terms_);
  }

 private:
  int newTerm(std::string head) {
    terms_.push_back({std::move(head)});
    return static_cast<int>(terms_.size()) - 1;
  }

  int labelled(std::string_view name) {
    const auto [known, is_new] = term_of_label_.try_emplace(std::string(name), static_cast<int>(terms_.size()));
    if (is_new) newTerm(kUnknownHead);
    return known->second;
  }

  std::string_view takeHead() {
    const std::size_t end = std::min(rest_.find_first_of("(),"), rest_.size());
    const std::string_view head = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return head;
  }

  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  bool readInto(int term, int nesting) {
    const std::string_view head = takeHead();
    if (head.empty() || nesting > kMostReadNesting) return false;
    if (head.starts_with('#')) {  // "value = #1": the whole meets itself again
      term_of_label_[std::string(head)] = term;
      terms_[static_cast<std::size_t>(term)].head = kUnknownHead;
      return true;
    }
    std::vector<int> parts;
    if (take("(")) {
      do {
        const int part = readPart(nesting + 1);
        if (part < 0) return false;
        parts.push_back(part);
      } while (take(", "));
      if (!take(")")) return false;
    }
    terms_[static_cast<std::size_t>(term)].head = head;
    terms_[static_cast<std::size_t>(term)].parts = std::move(parts);
    return true;
  }

  int readPart(int nesting) {
    if (rest_.starts_with('#')) return labelled(takeHead());
    const int part = newTerm("");
    return readInto(part, nesting) ? part : -1;
  }

  SliceTerms terms_;
  std::unordered_map<std::string, int> term_of_label_;
  std::string_view rest_;
};

void append(const SliceTerms& terms, int term, std::size_t most, std::string& text) {
  const SliceTerm& whole = terms[static_cast<std::size_t>(term)];
  text += whole.head;
  for (std::size_t i = 0; i < whole.parts.size() && text.size() <= most; ++i) {
    text += i == 0 ? "(" : ", ";
    append(terms, whole.parts[i], most, text);
  }
  if (!whole.parts.empty()) text += ")";
}

}  // namespace

std::vector<std::string> textOf(const SliceTerms& terms, std::size_t most_bytes) { return TextWriter(terms).lines(most_bytes); }

std::optional<SliceTerms> termsOfText(const std::vector<std::string>& lines) { return TextReader().read(lines); }

std::string shortTextOf(const SliceTerms& terms, int term, std::size_t most_characters) {
  std::string text;
  append(terms, term, most_characters, text);
  if (text.size() > most_characters) text = text.substr(0, most_characters) + "...";
  return text;
}

}  // namespace reprise
