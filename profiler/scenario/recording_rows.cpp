#include "profiler/scenario/recording_rows.h"

#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "profiler/scenario/near_names.h"
#include "profiler/scenario/names.h"

namespace reprise {
namespace {

using nlohmann::json;

std::string headerOf(std::size_t columns) {
  std::string header;
  for (std::size_t i = 0; i < columns; ++i) header += (i > 0 ? "," : "") + std::string(kRecordingColumns[i]);
  return header;
}

std::string withoutBlanks(const std::string& text) {
  const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t start = 0;
  for (std::size_t comma = line.find(','); comma != std::string::npos; comma = line.find(',', start)) {
    cells.push_back(withoutBlanks(line.substr(start, comma - start)));
    start = comma + 1;
  }
  cells.push_back(withoutBlanks(line.substr(start)));
  return cells;
}

// 0 where the line is no header.
std::size_t columnsOfHeader(const std::string& line) {
  std::string tight;
  for (const std::string& cell : cellsOf(line)) tight += (tight.empty() ? "" : ",") + cell;
  for (const std::size_t columns : {kFewestColumns, std::size(kRecordingColumns)})
    if (tight == headerOf(columns)) return columns;
  return 0;
}

void readCells(const std::vector<std::string>& cells, RecordingRow& row, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double number = 0;
    const char* end = cells[i].data() + cells[i].size();
    const auto [stopped, status] = std::from_chars(cells[i].data(), end, number);
    if (status == std::errc() && stopped == end) {
      row.numbers.push_back(number);
      continue;
    }
    diagnostics.add("recording", "'" + std::string(kRecordingColumns[i]) + "' is '" + cells[i] + "', expected a number", row.place);
    return;
  }
}

// Hands out the characters of a text and keeps account of the line, so that the parser's events have places.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, int* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_++ == '\n') ++*line_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  int* line_;
};

RecordingRow rowOfObject(const json& object, const Place& place, Diagnostics& diagnostics) {
  RecordingRow row{place, {}};
  const std::vector<std::string> known(std::begin(kRecordingColumns), std::end(kRecordingColumns));
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      diagnostics.add("recording", "there is no key '" + key + "'" + suggestNames(key, known), place);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto found = object.find(known[i]);
    if (found == object.end() && i >= kFewestColumns) break;
    if (found != object.end() && found->is_number()) {
      row.numbers.push_back(found->get<double>());
      continue;
    }
    diagnostics.add("recording", found == object.end() ? "the row has no '" + known[i] + "'" : "'" + known[i] + "' is " + found->dump() + ", expected a number", place);
    return row;
  }
  return row;
}

}  // namespace

std::vector<RecordingRow> rowsOfCsv(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  std::vector<RecordingRow> rows;
  std::istringstream lines(text);
  std::string line;
  std::size_t columns = 0;
  for (int number = 1; std::getline(lines, line) && rows.size() <= kMaxCameraRows && !diagnostics.full(); ++number) {
    line = withoutBlanks(line);
    if (line.empty() || line[0] == '#') continue;
    const Place place{file, number, 1};
    if (columns == 0) {
      columns = columnsOfHeader(line);
      if (columns > 0) continue;
      diagnostics.add("recording", "the header is '" + line.substr(0, 80) + "', expected '" + headerOf(kFewestColumns) + "', with ',fov_y_deg' at its end if wanted", place);
      return {};
    }
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != columns) {
      diagnostics.add("recording", "the row has " + std::to_string(cells.size()) + " numbers, expected " + std::to_string(columns) + " as in the header", place);
      continue;
    }
    rows.push_back({place, {}});
    readCells(cells, rows.back(), diagnostics);
  }
  return rows;
}

std::vector<RecordingRow> rowsOfJson(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  int line = 1;
  std::vector<int> starts;
  const auto note = [&](int depth, json::parse_event_t event, json&) {
    if (event == json::parse_event_t::object_start && depth == 1) starts.push_back(line);
    return true;
  };
  json document;
  try {
    document = json::parse(CountingIterator(text.data(), &line), CountingIterator(text.data() + text.size(), &line), note);
  } catch (const json::exception& failure) {
    diagnostics.add("recording", std::string("this is no JSON: ") + failure.what(), {file, line, 1});
    return {};
  }
  std::vector<RecordingRow> rows;
  if (!document.is_array() || starts.size() != document.size()) {
    diagnostics.add("recording", "expected a list of objects with the keys " + headerOf(kFewestColumns) + " and nothing else", {file, 1, 1});
    return rows;
  }
  for (std::size_t i = 0; i < document.size() && rows.size() <= kMaxCameraRows && !diagnostics.full(); ++i)
    rows.push_back(rowOfObject(document[i], {file, starts[i], 1}, diagnostics));
  return rows;
}

}  // namespace reprise
