#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "cli/report/result.h"

namespace reprise {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kChoiceNames = {"variant", "original", "undecided"};
constexpr std::array kStatusNames = {"trained", "pruned", "not_reached", "failed", "refused"};

// Each struct lists its keys once, in fields(); Writer and Reader go through the same list, so that the two
// cannot differ. `a(key, member)` is the plain form; the named forms are for members whose JSON is not that
// of their type.

template <class A>
void fields(A& a, RunLanes& l) {
  a("helper", l.helper), a("rejected", l.rejected), a("discarded", l.discarded);
}
template <class A>
void fields(A& a, RunDevice& d) {
  a("name", d.name), a("driver", d.driver), a("cpu", d.cpu), a("host", d.host);
  a.later("lanes", d.lanes);
}
template <class A>
void fields(A& a, RunShader& s) {
  a("fragment", s.fragment), a("vertex", s.vertex), a("hash", s.hash);
}
template <class A>
void fields(A& a, RunScenario& s) {
  a("path", s.path), a("name", s.name), a("hash", s.hash);
  a("width", s.width), a("height", s.height), a("seed", s.seed), a("frames", s.frames);
  a("eye_distance", s.eye_distance);
}
template <class A>
void fields(A& a, RunThreshold& t) {
  a("metric", t.metric), a("value", t.value), a.later("margin", t.margin);
}
template <class A>
void fields(A& a, RunMetric& m) {
  a("metric", m.metric), a("all_sessions", m.all_sessions), a("worst_session", m.worst_session), a("worst_frame", m.worst_frame);
}
template <class A>
void fields(A& a, RunPayloadValue& v) {
  a("name", v.name), a("type", v.type), a("file", v.file), a("line", v.line), a("column", v.column);
}
template <class A>
void fields(A& a, RunChoice& c) {
  a.name("kind", c.kind, kChoiceNames);
  a("reason", c.reason);
  a.textOrNull("candidate_id", c.candidate_id);
  a("payload", c.payload);
  a.textOrNull("strategy", c.strategy), a.textOrNull("pattern", c.pattern);
  a("block_pixels", c.block_pixels);
  a.textOrNull("filter", c.filter), a.textOrNull("encoding", c.encoding);
  a.period("period_frames", c.period_frames);
  a("predicted_error", c.predicted_error), a("measured_error", c.measured_error);
  a("worst_frame_error", c.worst_frame_error);
  a("predicted_speedup", c.predicted_speedup), a("measured_speedup", c.measured_speedup);
  a("speedup_ci95", c.speedup_ci95);
  a("wall_speedup", c.wall_speedup), a("wall_speedup_ci95", c.wall_speedup_ci95);
  a("predicted_frame_ms", c.predicted_frame_ms), a("measured_frame_ms", c.measured_frame_ms);
  a("p95_ms", c.p95_ms), a("worst_ms", c.worst_ms), a("pace", c.pace);
  a("hit_rate", c.hit_rate), a("cache_bytes_per_pixel", c.cache_bytes_per_pixel);
}
template <class A>
void fields(A& a, RunOriginal& o) {
  a("frame_ms", o.frame_ms), a("wall_ms", o.wall_ms), a("with_prepass_ms", o.with_prepass_ms);
}
template <class A>
void fields(A& a, RunLimit& l) {
  a("frame_ms", l.frame_ms), a.textOrNull("candidate_id", l.candidate_id);
}
template <class A>
void fields(A& a, RunReason& r) {
  a("code", r.code), a("message", r.message);
}
template <class A>
void fields(A& a, RunParameter& p) {
  a("name", p.name), a("value", p.value), a("ci95", p.ci95);
}
template <class A>
void fields(A& a, RunErrorModel& m) {
  a("family", m.family), a("parameters", m.parameters), a("r_squared", m.r_squared), a("verdict", m.verdict);
}
template <class A>
void fields(A& a, RunPoint& p) {
  a.period("period_frames", p.period_frames);
  a("predicted_error", p.predicted_error), a("measured_error", p.measured_error);
  a("predicted_frame_ms", p.predicted_frame_ms), a("measured_frame_ms", p.measured_frame_ms);
  a.later("predicted_error_ci95", p.predicted_error_ci95), a.later("measured_error_frames", p.measured_error_frames);
  a.later("measured_frame_ms_ci95", p.measured_frame_ms_ci95), a.later("predicted_hit_rate", p.predicted_hit_rate);
  a.later("measured_speedup", p.measured_speedup), a.later("speedup_ci95", p.speedup_ci95);
}
template <class A>
void fields(A& a, RunConfiguration& c) {
  a("strategy", c.strategy), a("pattern", c.pattern), a("block_pixels", c.block_pixels);
  a("filter", c.filter), a("encoding", c.encoding);
  a("hit_ns", c.hit_ns), a("miss_ns", c.miss_ns), a("overhead_ms", c.overhead_ms);
  a("cost_r_squared", c.cost_r_squared), a("cost_verdict", c.cost_verdict), a("points", c.points);
  a.later("cache_bytes_per_pixel", c.cache_bytes_per_pixel);
}
template <class A>
void fields(A& a, RunCandidate& c) {
  a("id", c.id), a("name", c.name), a("type", c.type);
  a("file", c.file), a("line", c.line), a("column", c.column);
  a("cost", c.cost), a("cost_share", c.cost_share), a("inputs", c.inputs);
  a.name("status", c.status, kStatusNames);
  a("reason", c.reason), a("error_model", c.error_model), a("hit_rate_mu", c.hit_rate_mu);
  a("configurations", c.configurations);
  a.later("limit_frame_ms", c.limit_frame_ms);
}
template <class A>
void fields(A& a, RunVariant& v) {
  a("candidate_id", v.candidate_id), a("strategy", v.strategy), a("pattern", v.pattern), a("block_pixels", v.block_pixels);
  a("filter", v.filter), a("encoding", v.encoding);
  a.period("period_frames", v.period_frames);
}
template <class A>
void fields(A& a, RunAttempt& t) {
  a("candidate_id", t.candidate_id), a("configuration", t.configuration);
  a.period("period_frames", t.period_frames);
  a("measured_error", t.measured_error), a("measured_speedup", t.measured_speedup);
  a("speedup_ci95", t.speedup_ci95), a("accepted", t.accepted), a("reason", t.reason);
}
template <class A>
void fields(A& a, RunFrame& f) {
  a("frame", f.frame), a("error", f.error), a("frame_ms", f.frame_ms), a("original_ms", f.original_ms);
  a("hit_rate", f.hit_rate);
}
template <class A>
void fields(A& a, RunSession& s) {
  a("name", s.name), a("frames", s.frames);
}
template <class A>
void fields(A& a, RunImages& i) {
  a.textOrNull("original", i.original), a.textOrNull("cached", i.cached);
  a.textOrNull("error", i.error), a.textOrNull("hit_miss", i.hit_miss);
  a.textOrNull("session", i.session), a("frame", i.frame), a("error_gain", i.error_gain);
  a.textOrNull("hit_color", i.hit_color), a.textOrNull("miss_color", i.miss_color);
}
template <class A>
void fields(A& a, RunResult& r) {
  a("tool_version", r.tool_version), a.textOrNull("finished_at", r.finished_at);
  a("device", r.device), a("clock", r.clock), a("shader", r.shader), a("scenario", r.scenario);
  a.later("quality", r.quality), a.later("thresholds", r.thresholds), a.later("least_gain", r.least_gain);
  a("threshold", r.threshold), a("choice", r.choice), a("original", r.original), a("limit", r.limit);
  a("candidates", r.candidates), a.later("front", r.front), a("attempts", r.attempts), a("validation", r.validation);
  a.later("metrics", r.metrics);
  a("warnings", r.warnings), a("not_reached", r.not_reached), a.later("strategies_refused", r.strategies_refused), a.stages("seconds", r.seconds);
  a("images", r.images), a("command", r.command);
}

class Writer {
 public:
  template <class T>
  void operator()(const char* key, T& member) {
    json_[key] = write(member);
  }
  template <class T>
  void later(const char* key, T& member) {
    (*this)(key, member);
  }
  template <class E, class Names>
  void name(const char* key, E value, const Names& names) {
    json_[key] = names[static_cast<std::size_t>(value)];
  }
  void textOrNull(const char* key, const std::string& text) {
    json_[key] = text.empty() ? Json(nullptr) : Json(text);
  }
  void period(const char* key, std::uint32_t frames) {
    json_[key] = frames == 0 ? Json(nullptr) : Json(frames);
  }
  void stages(const char* key, const std::vector<RunStage>& stages) {
    Json& object = json_[key] = Json::object();
    for (const RunStage& stage : stages) object[stage.name] = write(stage.seconds);
  }
  Json take() { return std::move(json_); }

 private:
  static Json write(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
  static Json write(RunInterval& ci) { return Json::array({write(ci.lo), write(ci.hi)}); }
  static Json write(RunReason& reason) {
    if (reason.code.empty() && reason.message.empty()) return nullptr;
    return writeObject(reason);
  }
  template <class T>
  static Json write(std::optional<T>& member) {
    return member ? write(*member) : Json(nullptr);
  }
  template <class T>
  static Json write(std::vector<T>& members) {
    Json array = Json::array();
    for (T& member : members) array.push_back(write(member));
    return array;
  }
  template <class T>
  static Json write(T& member) {
    if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
      return writeObject(member);
    } else {
      return member;
    }
  }
  template <class T>
  static Json writeObject(T& object) {
    Writer writer;
    fields(writer, object);
    return writer.take();
  }

  Json json_ = Json::object();
};

// Reads what Writer wrote; the first thing that does not fit is kept as the error and the rest is read for
// nothing.
class Reader {
 public:
  Reader(const Json& json, std::string path, std::string& problem)
      : json_(json), path_(std::move(path)), problem_(problem) {}

  template <class T>
  void operator()(const char* key, T& member) {
    if (const Json* value = find(key)) read(*value, at(key), member);
  }
  // A key that files of older versions lack.
  template <class T>
  void later(const char* key, T& member) {
    if (json_.contains(key)) (*this)(key, member);
  }
  template <class E, class Names>
  void name(const char* key, E& member, const Names& names) {
    const Json* value = find(key);
    if (!value) return;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (value->is_string() && value->template get_ref<const std::string&>() == names[i]) {
        member = static_cast<E>(i);
        return;
      }
    }
    fail(at(key), *value, "one of the names in docs/result.md");
  }
  void textOrNull(const char* key, std::string& member) {
    const Json* value = find(key);
    if (value && !value->is_null()) read(*value, at(key), member);
  }
  void period(const char* key, std::uint32_t& member) {
    const Json* value = find(key);
    if (!value) return;
    member = 0;
    if (!value->is_null()) read(*value, at(key), member);
  }
  void stages(const char* key, std::vector<RunStage>& member) {
    const Json* value = find(key);
    if (!value) return;
    if (!value->is_object()) return fail(at(key), *value, "an object of seconds by stage");
    for (const auto& [stage, seconds] : value->items()) {
      read(seconds, at(key) + "." + stage, member.emplace_back(RunStage{stage, 0}).seconds);
    }
  }

 private:
  std::string at(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
  void fail(const std::string& path, const Json& found, const std::string& expected) {
    if (problem_.empty()) problem_ = path + " is " + found.type_name() + ", expected " + expected;
  }
  const Json* find(const char* key) {
    const auto it = json_.find(key);
    if (it != json_.end()) return &*it;
    if (problem_.empty()) problem_ = at(key) + " is missing";
    return nullptr;
  }

  void read(const Json& value, const std::string& path, double& member) {
    if (value.is_null()) {
      member = std::numeric_limits<double>::quiet_NaN();
    } else if (value.is_number()) {
      member = value.get<double>();
    } else {
      fail(path, value, "a number or null");
    }
  }
  void read(const Json& value, const std::string& path, bool& member) {
    if (!value.is_boolean()) return fail(path, value, "true or false");
    member = value.get<bool>();
  }
  void read(const Json& value, const std::string& path, std::string& member) {
    if (!value.is_string()) return fail(path, value, "a string");
    member = value.get<std::string>();
  }
  void read(const Json& value, const std::string& path, int& member) { readInteger(value, path, member); }
  void read(const Json& value, const std::string& path, std::uint32_t& member) {
    readInteger(value, path, member);
  }
  template <class T>
  void readInteger(const Json& value, const std::string& path, T& member) {
    const bool fits = value.is_number_unsigned()
                          ? value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<T>::max()}
                          : value.is_number_integer() && std::is_signed_v<T> &&
                                value.get<std::int64_t>() >= std::numeric_limits<T>::min();
    if (!fits) return fail(path, value, "a whole number of 32 bits");
    member = value.get<T>();
  }
  void read(const Json& value, const std::string& path, RunInterval& member) {
    if (!value.is_array() || value.size() != 2) return fail(path, value, "an interval [low, high]");
    read(value[0], path + "[0]", member.lo);
    read(value[1], path + "[1]", member.hi);
  }
  void read(const Json& value, const std::string& path, RunReason& member) {
    if (!value.is_null()) readObject(value, path, member);
  }
  template <class T>
  void read(const Json& value, const std::string& path, std::optional<T>& member) {
    if (!value.is_null()) read(value, path, member.emplace());
  }
  template <class T>
  void read(const Json& value, const std::string& path, std::vector<T>& members) {
    if (!value.is_array()) return fail(path, value, "an array");
    members.reserve(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      read(value[i], path + "[" + std::to_string(i) + "]", members.emplace_back());
    }
  }
  template <class T>
  void read(const Json& value, const std::string& path, T& member) {
    readObject(value, path, member);
  }
  template <class T>
  void readObject(const Json& value, const std::string& path, T& member) {
    if (!value.is_object()) return fail(path, value, "an object");
    Reader reader(value, path, problem_);
    fields(reader, member);
  }

  const Json& json_;
  std::string path_;
  std::string& problem_;
};

Error badResult(const char* code, std::string message) {
  return {ErrorKind::kInput, code, std::move(message) + "; run `reprise optimize` again", {}};
}

}  // namespace

const char* nameOf(ChoiceKind kind) {
  return kChoiceNames[static_cast<std::size_t>(kind)];
}
const char* nameOf(CandidateStatus status) {
  return kStatusNames[static_cast<std::size_t>(status)];
}

std::string resultToJson(const RunResult& result) {
  Writer writer;
  int version = kResultFormatVersion;
  writer("format_version", version);
  RunResult copy = result;  // fields() takes mutable members, for Reader's sake
  fields(writer, copy);
  return writer.take().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<RunResult> resultFromJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded())
    return badResult("result.syntax", "result.json is not valid JSON (cut short or edited?)");
  if (!json.is_object()) return badResult("result.invalid", "result.json holds no object at its top");
  const auto version = json.find("format_version");
  if (version == json.end() || !version->is_number_integer()) {
    return badResult("result.invalid", "result.json: format_version is missing or no whole number");
  }
  if (version->get<std::int64_t>() != kResultFormatVersion) {
    return badResult("result.version", "result.json has format version " + version->dump() +
                                           ", this Reprise reads version " +
                                           std::to_string(kResultFormatVersion));
  }
  RunResult result;
  std::string problem;
  Reader reader(json, "", problem);
  fields(reader, result);
  if (!problem.empty()) return badResult("result.invalid", "result.json: " + problem);
  return result;
}

}  // namespace reprise
