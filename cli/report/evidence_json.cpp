#include <nlohmann/json.hpp>

#include "cli/report/evidence.h"

namespace reprise {

using Json = nlohmann::ordered_json;

namespace {

// Periods and numbers as in result.json: never is null, what is not finite is null.
Json periodJson(std::uint32_t period) { return period == 0 ? Json(nullptr) : Json(period); }
std::uint32_t periodFrom(const Json& json) { return json.is_null() ? 0 : json.get<std::uint32_t>(); }

Json lines(const std::vector<EvidenceLine>& from) {
  Json json = Json::array();
  for (const EvidenceLine& line : from) json.push_back({line.source, line.line});
  return json;
}

std::vector<EvidenceLine> linesFrom(const Json& json) {
  std::vector<EvidenceLine> to;
  for (const Json& line : json) to.push_back({line.at(0).get<std::size_t>(), line.at(1).get<int>()});
  return to;
}

Json variantJson(const RunVariant& v) {
  return {{"candidate_id", v.candidate_id}, {"strategy", v.strategy}, {"pattern", v.pattern}, {"block_pixels", v.block_pixels},
          {"filter", v.filter}, {"encoding", v.encoding}, {"period_frames", periodJson(v.period_frames)}};
}

RunVariant variantFrom(const Json& json) {
  RunVariant v;
  json.at("candidate_id").get_to(v.candidate_id);
  json.at("strategy").get_to(v.strategy);
  json.at("pattern").get_to(v.pattern);
  json.at("block_pixels").get_to(v.block_pixels);
  json.at("filter").get_to(v.filter);
  json.at("encoding").get_to(v.encoding);
  v.period_frames = periodFrom(json.at("period_frames"));
  return v;
}

Json samplesJson(const std::vector<EvidenceSample>& samples) {
  Json json = Json::array();
  for (const EvidenceSample& s : samples) json.push_back({periodJson(s.period_frames), s.hits, s.misses, s.frame_ms});
  return json;
}

Json toJson(const RunEvidence& evidence) {
  Json json = {{"sources", Json::array()}, {"slices", Json::array()}, {"costs", Json::array()}, {"session", evidence.session},
               {"frame", evidence.frame}, {"original", evidence.original}, {"pictures", Json::array()}, {"strip", Json::array()}};
  for (const EvidenceSource& s : evidence.sources)
    json["sources"].push_back({{"path", s.path}, {"text", s.text}, {"line_shares", s.line_shares}});
  for (const EvidenceSlice& s : evidence.slices)
    json["slices"].push_back({{"candidate_id", s.candidate_id}, {"slice", lines(s.slice)}, {"tail", lines(s.tail)}, {"both", lines(s.both)}});
  for (const EvidenceCost& c : evidence.costs)
    json["costs"].push_back({{"variant", variantJson(c.variant)}, {"samples", samplesJson(c.samples)}});
  for (const EvidencePictures& p : evidence.pictures)
    json["pictures"].push_back({{"variant", variantJson(p.variant)}, {"cached", p.cached}, {"error", p.error}, {"hit_miss", p.hit_miss},
                                {"payload", p.payload}});
  for (const EvidenceFrame& f : evidence.strip)
    json["strip"].push_back({{"frame", f.frame}, {"original", f.original}, {"cached", f.cached}});
  return json;
}

RunEvidence fromJson(const Json& json) {
  RunEvidence evidence;
  for (const Json& s : json.at("sources"))
    evidence.sources.push_back({s.at("path"), s.at("text"), s.at("line_shares").get<std::vector<double>>()});
  for (const Json& s : json.at("slices"))
    evidence.slices.push_back({s.at("candidate_id"), linesFrom(s.at("slice")), linesFrom(s.at("tail")), linesFrom(s.at("both"))});
  for (const Json& c : json.at("costs")) {
    EvidenceCost cost{variantFrom(c.at("variant")), {}};
    for (const Json& s : c.at("samples")) cost.samples.push_back({periodFrom(s.at(0)), s.at(1), s.at(2), s.at(3)});
    evidence.costs.push_back(std::move(cost));
  }
  json.at("session").get_to(evidence.session);
  json.at("frame").get_to(evidence.frame);
  json.at("original").get_to(evidence.original);
  for (const Json& p : json.at("pictures"))
    evidence.pictures.push_back({variantFrom(p.at("variant")), p.at("cached"), p.at("error"), p.at("hit_miss"), p.at("payload")});
  for (const Json& f : json.at("strip")) evidence.strip.push_back({f.at("frame"), f.at("original"), f.at("cached")});
  return evidence;
}

}  // namespace

std::string evidenceToJson(const RunEvidence& evidence) {
  return toJson(evidence).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<RunEvidence> evidenceFromJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{ErrorKind::kInput, "evidence.syntax", "evidence.json is not JSON", {}};
  try {
    return fromJson(json);
  } catch (const Json::exception& problem) {
    return Error{ErrorKind::kInput, "evidence.invalid", std::string("evidence.json: ") + problem.what(), {}};
  }
}

}  // namespace reprise
