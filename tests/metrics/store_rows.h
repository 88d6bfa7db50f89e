// Keys and rows for the tests of the store, and their rapidcheck generators.
#pragma once

#include <rapidcheck.h>

#include <limits>
#include <string>
#include <vector>

#include "profiler/measurements/store.h"

namespace reprise {

inline SeriesKey keyOf(int index) {
  SeriesKey key;
  key.variant_hash = "variant" + std::to_string(index);
  key.shader_hash = "shader";
  key.scenario_hash = "scenario";
  key.session = "orbit";
  key.device = "llvmpipe";
  key.driver = "22.3.6";
  key.width = 640;
  key.height = 360;
  key.seed = 1;
  key.period_frames = 8;
  key.tool_version = "0.1.0";
  return key;
}

// Rows that differ from series to series.
inline std::vector<ErrorRow> errorRowsOf(int index, int frames) {
  std::vector<ErrorRow> rows;
  for (int frame = 0; frame < frames; ++frame) {
    const auto n = static_cast<std::uint64_t>(1000 * index + frame);
    rows.push_back({frame, n + 5, n + 2, 3, n + 4, 6, 0, 0, {{"rms", 0.001 * index}, {"flip", 0.5 / (frame + 1)}}});
  }
  return rows;
}

inline rc::Gen<double> finiteNumber() {
  return rc::gen::suchThat(rc::gen::arbitrary<double>(), [](double value) { return std::isfinite(value); });
}

inline rc::Gen<ErrorRow> anyErrorRow() {
  const auto count = rc::gen::arbitrary<std::uint64_t>();
  return rc::gen::build<ErrorRow>(
      rc::gen::set(&ErrorRow::frame), rc::gen::set(&ErrorRow::covered, count), rc::gen::set(&ErrorRow::hits, count),
      rc::gen::set(&ErrorRow::misses, count), rc::gen::set(&ErrorRow::shaded_hits, count),
      rc::gen::set(&ErrorRow::shaded_misses, count), rc::gen::set(&ErrorRow::nonfinite, count),
      rc::gen::set(&ErrorRow::spoiled, count),
      rc::gen::set(&ErrorRow::errors,
                   rc::gen::container<std::map<std::string, double>>(rc::gen::arbitrary<std::string>(), finiteNumber())));
}

inline rc::Gen<TimeRow> anyTimeRow(const std::string& run_id) {
  return rc::gen::build<TimeRow>(rc::gen::set(&TimeRow::run_id, rc::gen::just(run_id)), rc::gen::set(&TimeRow::pair),
                                 rc::gen::set(&TimeRow::frame), rc::gen::set(&TimeRow::gpu_ms, finiteNumber()),
                                 rc::gen::set(&TimeRow::wall_ms, finiteNumber()),
                                 rc::gen::set(&TimeRow::cpu_ms, finiteNumber()));
}

inline rc::Gen<SeriesKey> anyKey() {
  return rc::gen::build<SeriesKey>(
      rc::gen::set(&SeriesKey::variant_hash), rc::gen::set(&SeriesKey::shader_hash),
      rc::gen::set(&SeriesKey::scenario_hash), rc::gen::set(&SeriesKey::session), rc::gen::set(&SeriesKey::device),
      rc::gen::set(&SeriesKey::driver), rc::gen::set(&SeriesKey::width), rc::gen::set(&SeriesKey::height),
      rc::gen::set(&SeriesKey::seed), rc::gen::set(&SeriesKey::period_frames), rc::gen::set(&SeriesKey::tool_version));
}

}  // namespace reprise

template <>
struct rc::Arbitrary<reprise::SeriesKey> {
  static Gen<reprise::SeriesKey> arbitrary() { return reprise::anyKey(); }
};

template <>
struct rc::Arbitrary<reprise::ErrorRow> {
  static Gen<reprise::ErrorRow> arbitrary() { return reprise::anyErrorRow(); }
};
