#include "runtime/base/result.h"

#include <iterator>

namespace reprise {
namespace {

std::string lineOf(const Error& error) {
  std::string text;
  if (!error.place.file.empty()) {
    text += error.place.file + ":";
    if (error.place.line > 0) text += std::to_string(error.place.line) + ":";
    if (error.place.line > 0 && error.place.column > 0) text += std::to_string(error.place.column) + ":";
    text += " ";
  }
  text += "error: " + error.message;
  if (!error.code.empty()) text += " [" + error.code + "]";
  return text;
}

}  // namespace

std::string formatError(const Error& error) {
  std::string text = lineOf(error);
  for (const Error& other : error.others) text += "\n" + lineOf(other);
  return text;
}

std::vector<Error> eachOf(const Error& error) {
  std::vector<Error> errors = {{error.kind, error.code, error.message, error.place}};
  errors.insert(errors.end(), error.others.begin(), error.others.end());
  return errors;
}

Error mergeErrors(std::vector<Error> errors) {
  REPRISE_CHECK(!errors.empty(), "there is no error to report");
  Error first = std::move(errors.front());
  first.others.insert(first.others.end(), std::make_move_iterator(errors.begin() + 1), std::make_move_iterator(errors.end()));
  return first;
}

}  // namespace reprise
