#include "profiler/scenario/read_recording.h"

#include <algorithm>
#include <cmath>

#include "profiler/scenario/read_sections.h"
#include "profiler/scenario/recording_rows.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr double kLargestNumber = 1e9;
constexpr double kRoundingOfFloat = 1e-6;  // a length nearer to 1 is left as it is, so that what was read reads again the same

std::string textOf(double number) {
  std::string text = std::to_string(number);
  text.erase(std::min(text.size(), text.find_last_not_of('0') + 1));
  if (text.back() == '.') text.pop_back();
  return text;
}

std::vector<RecordingRow> rowsOfArray(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  std::vector<RecordingRow> rows;
  for (const TomlNode& element : node.elements) {
    if (rows.size() > kMaxCameraRows || diagnostics.full()) break;
    RecordingRow row{element.place, {}};
    const bool numbers = std::all_of(element.elements.begin(), element.elements.end(), [](const TomlNode& number) { return number.isNumber(); });
    const std::size_t size = element.elements.size();
    if (element.kind != NodeKind::kArray || !numbers || (size != kFewestColumns && size != std::size(kRecordingColumns))) {
      diagnostics.add("recording", "a row of " + what + " is " + describeNode(element) + ", expected the 8 numbers at_s, x, y, z, qx, qy, qz, qw, or 9 with fov_y_deg", element.place);
      continue;
    }
    for (const TomlNode& number : element.elements) row.numbers.push_back(number.real);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<RecordingRow> rowsOfFile(const TomlNode& node, const std::filesystem::path& directory, Diagnostics& diagnostics) {
  const std::filesystem::path path = resolvePath(node, directory, false, diagnostics);
  std::error_code unknown;
  if (diagnostics.full() || !std::filesystem::exists(path, unknown) || std::filesystem::is_directory(path, unknown)) return {};
  const std::string extension = path.extension().string();
  if (extension != ".csv" && extension != ".json") {
    diagnostics.add("recording", "'" + path.string() + "' ends in '" + extension + "', expected .csv or .json", node.place);
    return {};
  }
  const Result<std::string> text = readFile(path);
  if (!text) {
    diagnostics.errors.push_back({text.error().kind, text.error().code, text.error().message, node.place});
    return {};
  }
  return extension == ".csv" ? rowsOfCsv(*text, path.string(), diagnostics) : rowsOfJson(*text, path.string(), diagnostics);
}

// What is wrong with a row by itself, "" if nothing.
std::string faultOf(const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!(std::abs(numbers[i]) <= kLargestNumber)) return "'" + std::string(kRecordingColumns[i]) + "' is " + textOf(numbers[i]) + ", expected a finite number up to 1e9";
  const double length = std::hypot(std::hypot(numbers[4], numbers[5]), std::hypot(numbers[6], numbers[7]));
  if (std::abs(length - 1) > kQuaternionTolerance)
    return "the quaternion qx, qy, qz, qw has the length " + textOf(length) + ", expected 1 (within " + textOf(kQuaternionTolerance) + ")";
  if (numbers.size() > kFewestColumns && !(numbers[8] > 0 && numbers[8] <= 170)) return "'fov_y_deg' is " + textOf(numbers[8]) + ", expected a number above 0 and up to 170";
  return "";
}

CameraKey keyOf(const std::vector<double>& numbers, double start_s) {
  CameraKey key;
  key.at_s = static_cast<float>(numbers[0] - start_s);
  for (std::size_t i = 0; i < 3; ++i) key.position[i] = static_cast<float>(numbers[1 + i]);
  const double length = std::hypot(std::hypot(numbers[4], numbers[5]), std::hypot(numbers[6], numbers[7]));
  const double divisor = std::abs(length - 1) > kRoundingOfFloat ? length : 1;
  for (std::size_t i = 0; i < 4; ++i) key.rotation[i] = static_cast<float>(numbers[4 + i] / divisor);
  if (numbers.size() > kFewestColumns) key.fov_y_deg = static_cast<float>(numbers[8]);
  return key;
}

}  // namespace

RecordedPath readRecording(const TomlNode& node, const std::string& what, const std::filesystem::path& directory, Diagnostics& diagnostics) {
  RecordedPath path;
  const std::size_t errors_before = diagnostics.errors.size();
  std::vector<RecordingRow> rows;
  if (node.kind == NodeKind::kText) {
    rows = rowsOfFile(node, directory, diagnostics);
  } else if (node.kind == NodeKind::kArray) {
    rows = rowsOfArray(node, what, diagnostics);
  } else {
    diagnostics.add("type", what + " is " + describeNode(node) + ", expected the name of a .csv or .json file", node.place);
  }
  if (diagnostics.errors.size() != errors_before) return path;
  const auto refuse = [&](const std::string& message, const Place& place) { diagnostics.add("recording", message, place); };
  if (rows.empty()) refuse(what + " has no rows, expected at least one", node.place);
  if (rows.size() > kMaxCameraRows) refuse(what + " has more than " + std::to_string(kMaxCameraRows) + " rows, expected at most so many", rows[kMaxCameraRows].place);
  for (const RecordingRow& row : rows) {
    if (const std::string fault = faultOf(row.numbers); !fault.empty()) {
      refuse(fault, row.place);
      continue;
    }
    if (row.numbers.size() != rows.front().numbers.size()) refuse("'fov_y_deg' is given in some rows only, expected it in all or none", row.place);
    const CameraKey key = keyOf(row.numbers, rows.front().numbers[0]);
    // Times may also fall together by their rounding to float.
    if (!path.keys.empty() && !(key.at_s > path.keys.back().at_s))
      refuse("'at_s' is " + textOf(row.numbers[0]) + ", expected a time after that of the row before", row.place);
    path.keys.push_back(key);
  }
  return path;
}

}  // namespace reprise
