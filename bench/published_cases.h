// The cases for which the literature states a number, and what is asked of ours. Each is a folder of shaders/ with a scenario and a README.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/report/result.h"

namespace reprise {

struct PublishedCase {
  std::string name;
  std::string scenario;             // within shaders/
  std::string published;            // the figure and where it stands
  std::optional<double> asked;      // least speed-up; none: the answer may be "original"
  // The payload that the literature names, told among the candidates; empty where it names none.
  std::string named_payload;
  bool (*is_named)(const RunCandidate& candidate) = nullptr;
};

const std::vector<PublishedCase>& publishedCases();

// Place of the named payload among the candidates by rank, from 1; nullopt where it is not among them.
std::optional<std::size_t> rankOfNamed(const PublishedCase& one, const std::vector<RunCandidate>& candidates);

}  // namespace reprise
