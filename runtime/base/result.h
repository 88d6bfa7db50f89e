// A value or the error that stood in its way.
//
// Every stage of Reprise returns Result<T>. An Error is something that a user or a machine got wrong: it says what was
// found, what was expected and what to do, has a stable code for scripts and, where there is one, a place in a source
// file. Faults of Reprise itself are no Errors: they stop the program through REPRISE_CHECK (check.h).
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/base/check.h"

namespace reprise {

// Who has to act on the error; the command line derives its exit status from it.
enum class ErrorKind {
  kInput,        // a file or value that the user gave is bad: exit status 1
  kUsage,        // the command line is wrong: exit status 2
  kMachine,      // the machine lacks something (device, feature, disk space): exit status 3
  kRefused,      // valid input that cannot be cached safely; a recorded reason, not a failure of the run
  kMeasurement,  // a variant crashed, hung or gave no usable measurement; recorded with the variant
  kInterrupted,  // the user stopped the run; it can be resumed
};

// line and column count from 1; 0 means unknown. file is empty where the error has no place.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const Place&) const = default;
};

struct Error {
  ErrorKind kind = ErrorKind::kInput;
  std::string code;     // stable, dotted, for scripts: "scenario.unknown_key", "source.syntax", "package.tampered"
  std::string message;  // one sentence or two: found, expected, what to do
  Place place;
  std::vector<Error> others = {};  // found together with this one, each whole and without others of its own
};

// "file:line:column: error: message [code]", leaving out what is unknown. The form of glslc and GCC. The others follow, a line each.
std::string formatError(const Error& error);

// The error itself, without its others, and then those.
std::vector<Error> eachOf(const Error& error);

// The first of them with the rest as its others. There must be one.
Error mergeErrors(std::vector<Error> errors);

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}    // NOLINT: implicit by design
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit by design

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  const T& value() const& { REPRISE_CHECK(ok(), formatError(std::get<1>(state_))); return std::get<0>(state_); }
  T& value() & { REPRISE_CHECK(ok(), formatError(std::get<1>(state_))); return std::get<0>(state_); }
  T&& value() && { REPRISE_CHECK(ok(), formatError(std::get<1>(state_))); return std::get<0>(std::move(state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }
  const Error& error() const { REPRISE_CHECK(!ok(), "error() of a Result that holds a value"); return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

// The result of a step that yields nothing: Result<void> r = step(); on success it is default-constructed.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}  // NOLINT: implicit by design
  bool ok() const { return !failed_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const { REPRISE_CHECK(failed_, "error() of a Result that succeeded"); return error_; }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace reprise

#define REPRISE_CONCAT_INNER(a, b) a##b
#define REPRISE_CONCAT(a, b) REPRISE_CONCAT_INNER(a, b)

// REPRISE_ASSIGN(auto module, readModule(words)); returns the error from the calling function if there is one.
#define REPRISE_ASSIGN(declaration, expression) \
  REPRISE_ASSIGN_INNER(REPRISE_CONCAT(reprise_result_, __LINE__), declaration, expression)
#define REPRISE_ASSIGN_INNER(result, declaration, expression) \
  auto result = (expression);                                 \
  if (!result.ok()) return result.error();                    \
  declaration = std::move(result).value()

// REPRISE_TRY(step()); for Result<void>, or where the value is not wanted.
#define REPRISE_TRY(expression)                                  \
  do {                                                           \
    auto reprise_step = (expression);                            \
    if (!reprise_step.ok()) return reprise_step.error();         \
  } while (false)
