// Measurement rows: what one variant did in one frame. Errors and times are separate (times need a quiet machine).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace reprise {

// What identifies a measured series. Content hashes make the store's key: the same key is never measured twice.
struct SeriesKey {
  std::string variant_hash;   // of recipe and modules; of the original for the original
  std::string shader_hash;    // of the user's compiled modules
  std::string scenario_hash;
  std::string session;
  std::string device, driver;
  std::uint32_t width = 0, height = 0;
  std::uint32_t seed = 0;
  std::uint32_t period_frames = 1;  // 0: never
  std::string tool_version;
  auto operator<=>(const SeriesKey&) const = default;
};

struct ErrorRow {
  int frame = 0;
  std::uint64_t covered = 0, hits = 0, misses = 0;              // pixels, by the fragment that won
  std::uint64_t shaded_hits = 0, shaded_misses = 0;             // fragments, overdraw included
  std::uint64_t nonfinite = 0;                                  // pixels whose original or cached colour is NaN or infinite
  std::uint64_t spoiled = 0;                                    // of these, where the original's is finite
  std::map<std::string, double> errors;                         // by metric name
  std::map<std::string, std::vector<std::uint16_t>> tiles = {}; // of metrics of tiles, by name: each tile's value in units of 1/65535
  bool operator==(const ErrorRow&) const = default;
};

struct TimeRow {
  std::string run_id;   // rows pair only within one run
  int pair = 0;         // index of the alternation round
  int frame = 0;        // of the session
  double gpu_ms = 0;    // timestamps, all passes
  double wall_ms = 0;   // submit to fence
  double cpu_ms = 0;    // process CPU time over the same span
  bool operator==(const TimeRow&) const = default;
};

}  // namespace reprise
