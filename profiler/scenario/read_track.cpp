#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/track_size.h"

namespace reprise {
namespace {

// Numbers of one time: a number or an array of them. Empty where the node is something else (which is
// reported).
std::vector<float> readValues(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  std::vector<float> values;
  if (node.kind != NodeKind::kArray) {
    float value = 0;
    if (numberOf(node, what, kAnyNumber, value, diagnostics)) values.push_back(value);
    return values;
  }
  if (node.elements.empty() || node.elements.size() > kMaxTrackValues) {
    diagnostics.add("value",
                    what + " is " + describeNode(node) + ", expected 1 to " +
                        std::to_string(kMaxTrackValues) + " numbers",
                    node.place);
    return values;
  }
  for (std::size_t i = 0; i < node.elements.size(); ++i) {
    float value = 0;
    numberOf(node.elements[i], "element " + std::to_string(i + 1) + " of " + what, kAnyNumber, value,
             diagnostics);
    values.push_back(value);
  }
  return values;
}

std::vector<float> readValuesAt(TableReader& reader, const std::string& key) {
  const TomlNode* node = reader.find(key, Need::kRequired);
  return node ? readValues(*node, "'" + key + "' of " + reader.what(), reader.diagnostics())
              : std::vector<float>();
}

void expectSameSize(const std::vector<float>& first, const std::vector<float>& second,
                    const std::string& message, TableReader& reader) {
  if (first.empty() || second.empty() || first.size() == second.size()) return;
  reader.diagnostics().add(
      "value", message + ": found " + std::to_string(first.size()) + " and " + std::to_string(second.size()),
      reader.table().place);
}

KeyFramesTrack readKeyFrames(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  KeyFramesTrack track;
  if (node.kind != NodeKind::kArray || node.elements.empty() || node.elements.size() > kMaxEntries) {
    diagnostics.add("type",
                    "'key_frames' of " + what + " is " + describeNode(node) + ", expected an array of 1 to " +
                        std::to_string(kMaxEntries) + " tables { at_s = seconds, value = ... }",
                    node.place);
    return track;
  }
  for (const TomlNode& element : node.elements) {
    TableReader reader(element, "key frame " + std::to_string(track.times_s.size() + 1) + " of " + what,
                       diagnostics);
    float at_s = 0;
    if (const TomlNode* at = reader.find("at_s", Need::kRequired)) {
      numberOf(*at, "'at_s' of " + reader.what(), kNotNegative, at_s, diagnostics);
    }
    std::vector<float> value = readValuesAt(reader, "value");
    if (!track.times_s.empty() && at_s <= track.times_s.back()) {
      diagnostics.add("value", "'at_s' of " + reader.what() + " is not after that of the key frame before it",
                      element.place);
    }
    if (!track.values.empty()) {
      expectSameSize(track.values.front(), value, reader.what() + " must have as many values as the first",
                     reader);
    }
    reader.finish();
    track.times_s.push_back(at_s);
    track.values.push_back(std::move(value));
  }
  return track;
}

OscillationTrack readOscillation(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  OscillationTrack track;
  TableReader reader(node, "'oscillate' of " + what, diagnostics);
  track.base = readValuesAt(reader, "base");
  track.amplitude = readValuesAt(reader, "amplitude");
  expectSameSize(track.base, track.amplitude,
                 "'base' and 'amplitude' of " + what + " must have as many values", reader);
  reader.readNumber("period_s", track.period_s, kPositive);
  reader.readNumber("phase_rad", track.phase_rad);
  reader.finish();
  return track;
}

RandomWalkTrack readRandomWalk(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  RandomWalkTrack track;
  TableReader reader(node, "'random_walk' of " + what, diagnostics);
  track.base = readValuesAt(reader, "base");
  track.extent = readValuesAt(reader, "extent");
  expectSameSize(track.base, track.extent, "'base' and 'extent' of " + what + " must have as many values",
                 reader);
  for (const float extent : track.extent) {
    if (extent < 0)
      diagnostics.add("value", "'extent' of " + what + " has a negative value, expected 0 or more",
                      node.place);
  }
  reader.readNumber("step_per_s", track.step_per_s, kNotNegative);
  reader.readUnsigned("seed", track.seed);
  reader.finish();
  return track;
}

FlickerTrack readFlicker(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  FlickerTrack track;
  TableReader reader(node, "'flicker' of " + what, diagnostics);
  track.base = readValuesAt(reader, "base");
  track.amplitude = readValuesAt(reader, "amplitude");
  expectSameSize(track.base, track.amplitude, "'base' and 'amplitude' of " + what + " must have as many values", reader);
  reader.readNumber("rate_hz", track.rate_hz, kPositive);
  reader.readUnsigned("seed", track.seed);
  reader.finish();
  return track;
}

std::optional<Track> readTrackTable(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  TableReader reader(node, what, diagnostics);
  std::optional<Track> track;
  int forms = 0;
  if (const TomlNode* value = reader.find("value")) {
    track = FixedTrack{readValues(*value, "'value' of " + what, diagnostics)};
    ++forms;
  }
  if (const TomlNode* keys = reader.find("key_frames")) {
    track = readKeyFrames(*keys, what, diagnostics);
    ++forms;
  }
  if (const TomlNode* oscillation = reader.find("oscillate")) {
    track = readOscillation(*oscillation, what, diagnostics);
    ++forms;
  }
  if (const TomlNode* walk = reader.find("random_walk")) {
    track = readRandomWalk(*walk, what, diagnostics);
    ++forms;
  }
  if (const TomlNode* flicker = reader.find("flicker")) {
    track = readFlicker(*flicker, what, diagnostics);
    ++forms;
  }
  reader.finish();
  if (forms != 1) {
    diagnostics.add(
        forms == 0 ? "missing_key" : "value",
        what + " has " + std::to_string(forms) +
            " of the keys 'value', 'key_frames', 'oscillate', 'random_walk', 'flicker', expected exactly one",
        node.place);
    return std::nullopt;
  }
  return track;
}

}  // namespace

std::optional<Track> readTrack(const TomlNode& node, const std::string& what, std::size_t components,
                               Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.errors.size();
  std::optional<Track> track;
  if (node.kind == NodeKind::kTable) {
    track = readTrackTable(node, what, diagnostics);
  } else if (node.isNumber() || node.kind == NodeKind::kArray) {
    track = FixedTrack{readValues(node, what, diagnostics)};
  } else {
    diagnostics.add(
        "type", what + " is " + describeNode(node) + ", expected a number, an array of numbers or a track",
        node.place);
  }
  if (diagnostics.errors.size() != errors_before) return std::nullopt;
  if (track && components != 0 && trackSize(*track) != components) {
    diagnostics.add("value",
                    what + " yields " + std::to_string(trackSize(*track)) + " numbers, expected " +
                        std::to_string(components),
                    node.place);
    return std::nullopt;
  }
  return track;
}

}  // namespace reprise
