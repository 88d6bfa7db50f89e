// Recipe <-> JSON. Every key is required and checked: a manifest is written by tools, and a missing key is damage.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "runtime/package/json.h"
#include "runtime/package/package.h"

namespace reprise {
namespace {

using nlohmann::json;

template <typename T>
T required(const std::optional<T>& value, const char* what, const std::string& found) {
  if (!value) throw std::invalid_argument("'" + found + "' is no " + what);
  return *value;
}

json toJson(const Resource& resource) {
  return {{"name", resource.name}, {"format", nameOf(resource.format)}, {"scale", resource.scale},
          {"lifetime", resource.lifetime == Lifetime::kFrame ? "frame" : resource.lifetime == Lifetime::kHistory ? "history" : "persistent"},
          {"clear", resource.clear}};
}

Resource resourceFrom(const json& from) {
  Resource resource;
  resource.name = from.at("name");
  resource.format = required(resourceFormatOf(from.at("format")), "image format", from.at("format"));
  resource.scale = from.at("scale");
  const std::string lifetime = from.at("lifetime");
  if (lifetime == "frame") resource.lifetime = Lifetime::kFrame;
  else if (lifetime == "history") resource.lifetime = Lifetime::kHistory;
  else if (lifetime == "persistent") resource.lifetime = Lifetime::kPersistent;
  else throw std::invalid_argument("'" + lifetime + "' is no lifetime");
  resource.clear = from.at("clear");
  return resource;
}

json toJson(const ColorAttachment& color) {
  return {{"app_target", color.app_target}, {"resource", color.resource},
          {"load", color.load == LoadOp::kClear ? "clear" : color.load == LoadOp::kLoad ? "load" : "dont_care"},
          {"blend", color.blend == BlendKind::kAdd ? "add" : "replace"}, {"location", color.location}};
}

ColorAttachment colorFrom(const json& from) {
  ColorAttachment color;
  color.app_target = from.at("app_target");
  color.resource = from.at("resource");
  const std::string load = from.at("load"), blend = from.at("blend");
  color.load = load == "clear" ? LoadOp::kClear : load == "load" ? LoadOp::kLoad : LoadOp::kDontCare;
  color.blend = blend == "add" ? BlendKind::kAdd : BlendKind::kReplace;
  color.location = from.at("location");
  return color;
}

json toJson(const Read& read) {
  return {{"resource", read.resource}, {"binding", read.binding}, {"filter", nameOf(read.filter)}, {"current", read.current}};
}

Read readFrom(const json& from) {
  return {from.at("resource"), from.at("binding"), required(filterOf(from.at("filter")), "filter", from.at("filter")),
          from.at("current")};
}

template <typename T, typename Function>
json listOf(const std::vector<T>& values, Function convert) {
  json list = json::array();
  for (const T& value : values) list.push_back(convert(value));
  return list;
}

template <typename T, typename Function>
std::vector<T> listFrom(const json& from, Function convert) {
  if (!from.is_array()) throw std::invalid_argument("a list was expected");
  std::vector<T> values;
  for (const json& entry : from) values.push_back(convert(entry));
  return values;
}

json toJson(const Pass& pass) {
  const char* kind = pass.kind == PassKind::kDraw ? "draw" : pass.kind == PassKind::kDispatch ? "dispatch" : "full_screen";
  return {{"name", pass.name}, {"kind", kind}, {"rendering", pass.rendering},
          {"vertex_module", pass.vertex_module}, {"fragment_module", pass.fragment_module},
          {"colors", listOf(pass.colors, [](const ColorAttachment& color) { return toJson(color); })},
          {"depth_clear", pass.depth_clear},
          {"depth", pass.depth == DepthUse::kAsApp ? "as_app" : "equal_no_write"},
          {"stencil", pass.stencil == StencilUse::kNone ? "none" : "mark_if_zero"},
          {"reads", listOf(pass.reads, [](const Read& read) { return toJson(read); })}};
}

Pass passFrom(const json& from) {
  Pass pass;
  pass.name = from.at("name");
  const std::string kind = from.at("kind"), depth = from.at("depth"), stencil = from.at("stencil");
  pass.kind = kind == "draw" ? PassKind::kDraw : kind == "dispatch" ? PassKind::kDispatch : PassKind::kFullScreen;
  pass.rendering = from.at("rendering");
  pass.vertex_module = from.at("vertex_module");
  pass.fragment_module = from.at("fragment_module");
  pass.colors = listFrom<ColorAttachment>(from.at("colors"), colorFrom);
  pass.depth_clear = from.at("depth_clear");
  pass.depth = depth == "as_app" ? DepthUse::kAsApp : DepthUse::kEqualNoWrite;
  pass.stencil = stencil == "none" ? StencilUse::kNone : StencilUse::kMarkIfZero;
  pass.reads = listFrom<Read>(from.at("reads"), readFrom);
  return pass;
}

json toJson(const PreviousInput& input) {
  return {{"source", input.source == PreviousSource::kUniformBlock ? "uniform_block" : "push_constants"},
          {"name", input.name}, {"set", input.set}, {"binding", input.binding}, {"size_bytes", input.size_bytes},
          {"reprise_binding", input.reprise_binding}};
}

PreviousInput previousFrom(const json& from) {
  const std::string source = from.at("source");
  return {source == "push_constants" ? PreviousSource::kPushConstants : PreviousSource::kUniformBlock,
          from.at("name"), from.at("set"), from.at("binding"), from.at("size_bytes"), from.at("reprise_binding")};
}

json toJson(const PayloadValue& value) {
  return {{"name", value.name}, {"type", value.type}, {"file", value.file}, {"line", value.line}, {"column", value.column},
          {"channels", value.channels}, {"range_min", value.range_min}, {"range_max", value.range_max}, {"inputs", value.inputs}};
}

PayloadValue payloadFrom(const json& from) {
  return {from.at("name"), from.at("type"), from.at("file"), from.at("line"), from.at("column"), from.at("channels"),
          from.at("range_min"), from.at("range_max"), from.at("inputs")};
}

json toJson(const FrameUniforms& constants) {
  return {{"depth_range", constants.depth_range}, {"tolerance", constants.tolerance},
          {"payload_scale", constants.payload_scale}, {"payload_offset", constants.payload_offset},
          {"payload_range", constants.payload_range}, {"free_payload", constants.free_payload}};
}

void readVector(const json& from, const char* key, float (&to)[4]) {
  const auto values = from.at(key).get<std::array<float, 4>>();
  std::copy(values.begin(), values.end(), to);
}

FrameUniforms constantsFrom(const json& from) {
  FrameUniforms constants;
  readVector(from, "depth_range", constants.depth_range);
  readVector(from, "tolerance", constants.tolerance);
  readVector(from, "payload_scale", constants.payload_scale);
  readVector(from, "payload_offset", constants.payload_offset);
  readVector(from, "payload_range", constants.payload_range);
  readVector(from, "free_payload", constants.free_payload);
  return constants;
}

json toJson(const Requirements& needs) {
  return {{"stencil", needs.stencil}, {"depth_less_or_greater", needs.depth_less_or_greater},
          {"independent_blend", needs.independent_blend}, {"linear_filter_float", needs.linear_filter_float},
          {"color_attachments", needs.color_attachments}};
}

}  // namespace

json recipeJson(const Recipe& recipe) {
  return {{"format_version", recipe.format_version}, {"strategy", recipe.strategy}, {"pattern", nameOf(recipe.pattern)},
          {"block_pixels", recipe.block_pixels}, {"filter", nameOf(recipe.filter)}, {"encoding", nameOf(recipe.encoding)},
          {"period_frames", recipe.period_frames == kNeverRefresh ? json(nullptr) : json(recipe.period_frames)},
          {"payload", listOf(recipe.payload, [](const PayloadValue& value) { return toJson(value); })},
          {"requirements", toJson(recipe.requirements)}, {"reprise_set", recipe.reprise_set},
          {"uses_reprise_set", recipe.uses_reprise_set}, {"orthographic", recipe.orthographic},
          {"constants", toJson(recipe.constants)},
          {"resources", listOf(recipe.resources, [](const Resource& resource) { return toJson(resource); })},
          {"passes", listOf(recipe.passes, [](const Pass& pass) { return toJson(pass); })},
          {"modules", listOf(recipe.modules, [](const ModuleEntry& entry) {
             return json{{"name", entry.name}, {"stage", entry.stage}, {"hash", entry.hash}};
           })},
          {"previous_inputs", listOf(recipe.previous_inputs, [](const PreviousInput& input) { return toJson(input); })}};
}

Recipe recipeFrom(const json& from) {
  Recipe recipe;
  recipe.format_version = from.at("format_version");
  recipe.strategy = from.at("strategy");
  recipe.pattern = required(patternKindOf(from.at("pattern")), "refresh pattern", from.at("pattern"));
  recipe.block_pixels = from.at("block_pixels");
  recipe.filter = required(filterOf(from.at("filter")), "filter", from.at("filter"));
  recipe.encoding = required(encodingOf(from.at("encoding")), "encoding", from.at("encoding"));
  recipe.period_frames = from.at("period_frames").is_null() ? kNeverRefresh : from.at("period_frames").get<std::uint32_t>();
  recipe.payload = listFrom<PayloadValue>(from.at("payload"), payloadFrom);
  const json& needs = from.at("requirements");
  recipe.requirements = {needs.at("stencil"), needs.at("depth_less_or_greater"), needs.at("independent_blend"),
                         needs.at("linear_filter_float"), needs.at("color_attachments")};
  recipe.reprise_set = from.at("reprise_set");
  recipe.uses_reprise_set = from.at("uses_reprise_set");
  recipe.orthographic = from.at("orthographic");
  recipe.constants = constantsFrom(from.at("constants"));
  recipe.resources = listFrom<Resource>(from.at("resources"), resourceFrom);
  recipe.passes = listFrom<Pass>(from.at("passes"), passFrom);
  recipe.modules = listFrom<ModuleEntry>(from.at("modules"), [](const json& entry) {
    return ModuleEntry{entry.at("name"), entry.at("stage"), entry.at("hash")};
  });
  recipe.previous_inputs = listFrom<PreviousInput>(from.at("previous_inputs"), previousFrom);
  return recipe;
}

std::string recipeToJson(const Recipe& recipe) { return recipeJson(recipe).dump(2); }

Result<Recipe> recipeFromJson(const std::string& text) {
  try {
    return recipeFrom(json::parse(text));
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "package.manifest", std::string("this is no recipe: ") + failure.what(), {}};
  }
}

}  // namespace reprise
