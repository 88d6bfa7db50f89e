// What the report shows beside result.json: the shader's source with its costs, the frames that the cost model was fitted to, and
// pictures of several variants. DIR/evidence.json holds it; evidenceFromJson(evidenceToJson(e)) equals e.
//
// Lines count from 1. Costs of lines are shares of the whole shader's cost, 0 to 1. Hits and misses are shaded fragments of a
// frame, times milliseconds of the binding clock. Names of pictures are those of PNG files in DIR/images; an empty one is missing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/report/result.h"
#include "runtime/base/result.h"

namespace reprise {

struct EvidenceSource {
  std::string path, text;
  std::vector<double> line_shares;  // of line i + 1; shorter than the text where the rest costs nothing
  bool operator==(const EvidenceSource&) const = default;
};

struct EvidenceLine {
  std::size_t source = 0;  // index into RunEvidence::sources
  int line = 0;
  auto operator<=>(const EvidenceLine&) const = default;
};

// The shader cut at a payload: lines that only the payload needs, those that only the output needs once it is given, and those
// that both need.
struct EvidenceSlice {
  std::string candidate_id;
  std::vector<EvidenceLine> slice, tail, both;
  bool operator==(const EvidenceSlice&) const = default;
};

struct EvidenceSample {
  std::uint32_t period_frames = 1;
  double hits = 0, misses = 0, frame_ms = 0;
  bool operator==(const EvidenceSample&) const = default;
};

struct EvidenceCost {
  RunVariant variant;  // its period is not used
  std::vector<EvidenceSample> samples;
  bool operator==(const EvidenceCost&) const = default;
};

// All at the frame of EvidenceFrame.
struct EvidencePictures {
  RunVariant variant;
  std::string cached, error, hit_miss, payload;
  bool operator==(const EvidencePictures&) const = default;
};

// One frame of the strip through the validation session, with the choice.
struct EvidenceFrame {
  int frame = 0;
  std::string original, cached;
  bool operator==(const EvidenceFrame&) const = default;
};

struct RunEvidence {
  std::vector<EvidenceSource> sources;
  std::vector<EvidenceSlice> slices;
  std::vector<EvidenceCost> costs;
  std::string session;   // of the pictures
  int frame = 0;         // of the pictures
  std::string original;  // the original in that frame
  std::vector<EvidencePictures> pictures;
  std::vector<EvidenceFrame> strip;
  bool operator==(const RunEvidence&) const = default;
};

// One line per list entry would be long to read and is not meant to be: no indent.
std::string evidenceToJson(const RunEvidence& evidence);

// Errors (kInput): evidence.syntax, evidence.invalid.
Result<RunEvidence> evidenceFromJson(const std::string& text);

}  // namespace reprise
