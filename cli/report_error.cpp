#include "cli/report_error.h"

#include <nlohmann/json.hpp>
#include <ostream>

namespace reprise {
namespace {

int statusOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage: return kUsageStatus;
    case ErrorKind::kMachine: return kMachineStatus;
    case ErrorKind::kInterrupted: return kInterruptedStatus;
    case ErrorKind::kInput:
    case ErrorKind::kRefused:
    case ErrorKind::kMeasurement: break;
  }
  return kInputStatus;
}

}  // namespace

int reportError(const Error& error, bool as_json, std::ostream& out) {
  for (const Error& one : eachOf(error)) {
    const nlohmann::json document = {{"code", one.code}, {"message", one.message}, {"file", one.place.file}, {"line", one.place.line}, {"column", one.place.column}};
    // Names of files need not be UTF-8.
    out << (as_json ? document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) : formatError(one)) << '\n';
  }
  return statusOf(error.kind);
}

}  // namespace reprise
