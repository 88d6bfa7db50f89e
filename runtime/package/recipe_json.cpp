// Recipe <-> JSON. Every key is required and checked: a manifest is written by tools, and a missing key is damage.
#include "runtime/package/json.h"
#include "runtime/package/json_values.h"
#include "runtime/package/package.h"

namespace reprise {
namespace {

using nlohmann::json;

const EnumNames<Lifetime> kLifetimes = {
    {Lifetime::kFrame, "frame"}, {Lifetime::kHistory, "history"}, {Lifetime::kPersistent, "persistent"}};
const EnumNames<LoadOp> kLoads = {{LoadOp::kClear, "clear"}, {LoadOp::kLoad, "load"}, {LoadOp::kDontCare, "dont_care"}};
const EnumNames<BlendKind> kBlends = {{BlendKind::kReplace, "replace"}, {BlendKind::kAdd, "add"}};
const EnumNames<PassKind> kPasses = {
    {PassKind::kDraw, "draw"}, {PassKind::kTiles, "tiles"}, {PassKind::kDispatch, "dispatch"}, {PassKind::kFullScreen, "full_screen"}};
const EnumNames<DepthUse> kDepths = {{DepthUse::kAsApp, "as_app"}, {DepthUse::kEqualNoWrite, "equal_no_write"},
                                    {DepthUse::kNone, "none"}};
const EnumNames<PassFrames> kFrames = {
    {PassFrames::kAll, "all"}, {PassFrames::kWhollyDue, "wholly_due"}, {PassFrames::kNotWhollyDue, "not_wholly_due"}};
const EnumNames<PassObjects> kObjects = {{PassObjects::kAll, "all"}, {PassObjects::kFlagged, "flagged"}};
const EnumNames<MissFlagging> kFlags = {
    {MissFlagging::kNone, "none"}, {MissFlagging::kTiles, "tiles"}, {MissFlagging::kDraws, "draws"}};
const EnumNames<StencilUse> kStencils = {{StencilUse::kNone, "none"}, {StencilUse::kMarkIfZero, "mark_if_zero"}};
const EnumNames<PreviousSource> kSources = {{PreviousSource::kUniformBlock, "uniform_block"},
                                            {PreviousSource::kPushConstants, "push_constants"}};

// For the enumerations whose names are public (names.cpp).
template <typename Enum>
Enum namedAt(const json& from, const char* key, std::optional<Enum> (*valueOf)(const std::string&)) {
  const std::string text = textAt(from, key);
  const std::optional<Enum> value = valueOf(text);
  if (!value) throw std::invalid_argument("'" + text + "' is no value of '" + key + "'");
  return *value;
}

json toJson(const Resource& resource) {
  return {{"name", resource.name}, {"format", nameOf(resource.format)}, {"scale", floatJson(resource.scale)},
          {"lifetime", enumText(kLifetimes, resource.lifetime)}, {"clear", floatsJson(resource.clear)}};
}

Resource resourceFrom(const json& from) {
  return {textAt(from, "name"), namedAt(from, "format", resourceFormatOf), floatFrom(from.at("scale"), "scale"),
          enumAt(from, "lifetime", kLifetimes), floatsAt(from, "clear")};
}

json toJson(const ColorAttachment& color) {
  return {{"app_target", color.app_target}, {"resource", color.resource}, {"load", enumText(kLoads, color.load)},
          {"blend", enumText(kBlends, color.blend)}, {"location", color.location}};
}

ColorAttachment colorFrom(const json& from) {
  return {integerAt<int>(from, "app_target"), textAt(from, "resource"), enumAt(from, "load", kLoads),
          enumAt(from, "blend", kBlends), integerAt<int>(from, "location")};
}

json toJson(const Read& read) {
  return {{"resource", read.resource}, {"binding", read.binding}, {"filter", nameOf(read.filter)}, {"current", read.current}};
}

Read readFrom(const json& from) {
  return {textAt(from, "resource"), integerAt<std::uint32_t>(from, "binding"), namedAt(from, "filter", filterOf),
          boolAt(from, "current")};
}

json toJson(const Pass& pass) {
  return {{"name", pass.name}, {"kind", enumText(kPasses, pass.kind)}, {"rendering", pass.rendering},
          {"vertex_module", pass.vertex_module}, {"fragment_module", pass.fragment_module},
          {"colors", listJson(pass.colors, [](const ColorAttachment& color) { return toJson(color); })},
          {"depth_clear", pass.depth_clear}, {"depth", enumText(kDepths, pass.depth)},
          {"stencil", enumText(kStencils, pass.stencil)}, {"frames", enumText(kFrames, pass.frames)}, {"objects", enumText(kObjects, pass.objects)},
          {"reads", listJson(pass.reads, [](const Read& read) { return toJson(read); })}};
}

Pass passFrom(const json& from) {
  Pass pass;
  pass.name = textAt(from, "name");
  pass.kind = enumAt(from, "kind", kPasses);
  pass.rendering = integerAt<int>(from, "rendering");
  pass.vertex_module = textAt(from, "vertex_module");
  pass.fragment_module = textAt(from, "fragment_module");
  pass.colors = listAt<ColorAttachment>(from, "colors", colorFrom);
  pass.depth_clear = boolAt(from, "depth_clear");
  pass.depth = enumAt(from, "depth", kDepths);
  pass.stencil = enumAt(from, "stencil", kStencils);
  pass.frames = enumAt(from, "frames", kFrames);
  pass.objects = enumAt(from, "objects", kObjects);
  pass.reads = listAt<Read>(from, "reads", readFrom);
  return pass;
}

json toJson(const PreviousInput& input) {
  return {{"source", enumText(kSources, input.source)}, {"name", input.name}, {"set", input.set}, {"binding", input.binding},
          {"size_bytes", input.size_bytes}, {"reprise_binding", input.reprise_binding}};
}

PreviousInput previousFrom(const json& from) {
  return {enumAt(from, "source", kSources), textAt(from, "name"), integerAt<std::uint32_t>(from, "set"),
          integerAt<std::uint32_t>(from, "binding"), integerAt<std::uint32_t>(from, "size_bytes"),
          integerAt<std::uint32_t>(from, "reprise_binding")};
}

json toJson(const PayloadValue& value) {
  return {{"name", value.name}, {"type", value.type}, {"file", value.file}, {"line", value.line}, {"column", value.column},
          {"channels", value.channels}, {"first_channel", value.first_channel}, {"guard_channel", value.guard_channel},
          {"range_min", floatsJson(value.range_min)},
          {"range_max", floatsJson(value.range_max)}, {"inputs", value.inputs}};
}

std::string textFrom(const json& from) {
  if (!from.is_string()) throw std::invalid_argument("a text was expected");
  return from.get<std::string>();
}

PayloadValue payloadFrom(const json& from) {
  return {textAt(from, "name"), textAt(from, "type"), textAt(from, "file"), integerAt<int>(from, "line"),
          integerAt<int>(from, "column"), integerAt<int>(from, "channels"), integerAt<int>(from, "first_channel"),
          integerAt<int>(from, "guard_channel"), floatsAt(from, "range_min"),
          floatsAt(from, "range_max"), listAt<std::string>(from, "inputs", textFrom)};
}

json toJson(const ModuleEntry& entry) { return {{"name", entry.name}, {"stage", entry.stage}, {"hash", entry.hash}}; }

ModuleEntry moduleFrom(const json& from) { return {textAt(from, "name"), textAt(from, "stage"), textAt(from, "hash")}; }

constexpr std::pair<const char*, float (CacheConstants::*)[4]> kConstants[] = {{"depth_range", &CacheConstants::depth_range},
                                                                              {"tolerance", &CacheConstants::tolerance},
                                                                              {"payload_range", &CacheConstants::payload_range}};
constexpr std::pair<const char*, ChannelFloats CacheConstants::*> kChannelConstants[] = {
    {"payload_scale", &CacheConstants::payload_scale},
    {"payload_offset", &CacheConstants::payload_offset},
    {"free_payload", &CacheConstants::free_payload}};

json toJson(const CacheConstants& constants) {
  json object = json::object();
  for (const auto& [key, member] : kConstants) object[key] = floatsJson(constants.*member);
  for (const auto& [key, member] : kChannelConstants) object[key] = floatsJson(constants.*member);
  return object;
}

CacheConstants constantsFrom(const json& from) {
  CacheConstants constants;
  for (const auto& [key, member] : kConstants) {
    const std::array<float, 4> values = floatsAt(from, key);
    std::copy(values.begin(), values.end(), constants.*member);
  }
  for (const auto& [key, member] : kChannelConstants) constants.*member = floatsAt<kMostPayloadChannels>(from, key);
  return constants;
}

json toJson(const Requirements& needs) {
  return {{"stencil", needs.stencil}, {"depth_less_or_greater", needs.depth_less_or_greater},
          {"independent_blend", needs.independent_blend}, {"linear_filter", needs.linear_filter},
          {"color_attachments", needs.color_attachments}, {"fragment_stores", needs.fragment_stores},
          {"shared_inputs", needs.shared_inputs}, {"conditional_rendering", needs.conditional_rendering},
          {"rejected_lanes_load", needs.rejected_lanes_load}};
}

Requirements requirementsFrom(const json& from) {
  return {boolAt(from, "stencil"), boolAt(from, "depth_less_or_greater"), boolAt(from, "independent_blend"),
          boolAt(from, "linear_filter"), integerAt<int>(from, "color_attachments"), boolAt(from, "fragment_stores"),
          boolAt(from, "shared_inputs"), boolAt(from, "conditional_rendering"), boolAt(from, "rejected_lanes_load")};
}

}  // namespace

json recipeJson(const Recipe& recipe) {
  return {{"format_version", recipe.format_version}, {"strategy", recipe.strategy}, {"pattern", nameOf(recipe.pattern)},
          {"block_pixels", recipe.block_pixels}, {"filter", nameOf(recipe.filter)}, {"encoding", nameOf(recipe.encoding)},
          {"period_frames", recipe.period_frames == kNeverRefresh ? json(nullptr) : json(recipe.period_frames)},
          {"previous", nameOf(recipe.previous)},
          {"payload", listJson(recipe.payload, [](const PayloadValue& value) { return toJson(value); })},
          {"requirements", toJson(recipe.requirements)}, {"reprise_set", recipe.reprise_set},
          {"uses_reprise_set", recipe.uses_reprise_set}, {"flags", enumText(kFlags, recipe.flags)}, {"orthographic", recipe.orthographic},
          {"constants", toJson(recipe.constants)},
          {"resources", listJson(recipe.resources, [](const Resource& resource) { return toJson(resource); })},
          {"passes", listJson(recipe.passes, [](const Pass& pass) { return toJson(pass); })},
          {"modules", listJson(recipe.modules, [](const ModuleEntry& entry) { return toJson(entry); })},
          {"previous_inputs", listJson(recipe.previous_inputs, [](const PreviousInput& input) { return toJson(input); })}};
}

Recipe recipeFrom(const json& from) {
  Recipe recipe;
  recipe.format_version = integerAt<int>(from, "format_version");
  recipe.strategy = textAt(from, "strategy");
  recipe.pattern = namedAt(from, "pattern", patternKindOf);
  recipe.block_pixels = integerAt<std::uint32_t>(from, "block_pixels");
  recipe.filter = namedAt(from, "filter", filterOf);
  recipe.encoding = namedAt(from, "encoding", encodingOf);
  recipe.period_frames = from.at("period_frames").is_null() ? kNeverRefresh : integerAt<std::uint32_t>(from, "period_frames");
  recipe.previous = namedAt(from, "previous", previousImageOf);
  recipe.payload = listAt<PayloadValue>(from, "payload", payloadFrom);
  recipe.requirements = requirementsFrom(from.at("requirements"));
  recipe.reprise_set = integerAt<std::uint32_t>(from, "reprise_set");
  recipe.uses_reprise_set = boolAt(from, "uses_reprise_set");
  recipe.flags = enumAt(from, "flags", kFlags);
  recipe.orthographic = boolAt(from, "orthographic");
  recipe.constants = constantsFrom(from.at("constants"));
  recipe.resources = listAt<Resource>(from, "resources", resourceFrom);
  recipe.passes = listAt<Pass>(from, "passes", passFrom);
  recipe.modules = listAt<ModuleEntry>(from, "modules", moduleFrom);
  recipe.previous_inputs = listAt<PreviousInput>(from, "previous_inputs", previousFrom);
  return recipe;
}

std::string recipeToJson(const Recipe& recipe) { return jsonText(recipeJson(recipe), 2); }

Result<Recipe> recipeFromJson(const std::string& text) {
  try {
    return recipeFrom(parseJson(text));
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "package.manifest", std::string("this is no recipe: ") + failure.what(), {}};
  }
}

}  // namespace reprise
