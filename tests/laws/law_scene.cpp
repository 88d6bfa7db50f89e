#include "tests/laws/law_scene.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "compiler/ir/reproducible.h"
#include "compiler/strategies/build_package.h"
#include "profiler/session/read_kinds.h"

namespace reprise {

namespace {

bool allNamed(const Candidate& candidate) {
  return std::all_of(candidate.values.begin(), candidate.values.end(), [](const CandidateValue& value) { return !value.name.empty(); });
}

// GPU drivers fuse and reassociate an expression as its surroundings have it, which differ between a variant and the original. Laws
// hold bit for bit where neither may; regrouping needs sums that allow it, and has a tolerance for them.
void forbidContraction(Subject& subject) {
  CompiledShader vertex, fragment;
  vertex.stage = ShaderStage::kVertex;
  vertex.words = subject.program.vertex_words;
  fragment.sources = subject.program.sources;
  if (!fragment.sources.empty()) fragment.main_path = fragment.sources.front().path;
  fragment.words = writeModule(withoutContraction(readModule(subject.program.fragment_words).value()));
  subject.program = readProgram(vertex, fragment).value();
  subject.candidates = enumerateCandidates(*subject.program.fragment, subject.program.analysis, subject.program.sources, {});
}

}  // namespace

std::unique_ptr<LawScene> LawScene::open(const std::string& scenario_file, bool validation, std::uint32_t magnified) {
  auto scene = std::make_unique<LawScene>();
  scene->subject_ = readSubject(scenario_file).value();
  scene->subject_.scenario.width *= magnified;
  scene->subject_.scenario.height *= magnified;
  ContextOptions options;
  options.validation = validation;
  scene->context_ = std::make_unique<Context>(Context::create(options).value());
  if (!scene->context_->summary().is_cpu && scene->subject_.scenario.name != "regrouped") forbidContraction(scene->subject_);
  scene->commands_ = std::make_unique<Commands>(Commands::create(*scene->context_).value());
  scene->renderer_ = std::make_unique<SceneRenderer>(
      SceneRenderer::create(*scene->context_, *scene->commands_, scene->subject_.scenario, scene->subject_.program.interface).value());
  scene->readback_ = std::make_unique<Readback>(*scene->context_);
  scene->targets_ = scene->renderer_->createTargets(*scene->commands_).value();
  return scene;
}

const Candidate& LawScene::candidate() const {
  const std::string& scenario = subject_.scenario.name;
  for (const Candidate& candidate : subject_.candidates) {
    if (!candidate.kept() || candidate.share >= 0.97) continue;
    const bool several = candidate.values.size() > 1, regrouped = isRegrouped(candidate);
    const bool wanted = scenario == "several_values" ? several && candidate.channels > 4 && allNamed(candidate)
                        : scenario == "guarded"      ? candidate.conditional
                        : scenario == "regrouped"    ? regrouped
                        : scenario == "integer"      ? !several && candidate.name == "key"
                        : scenario == "loop_result"  ? candidate.name == "sum"
                                                     : !several && !regrouped && !candidate.conditional && candidate.share < 0.9;
    if (wanted) return candidate;
  }
  REPRISE_CHECK(!subject_.candidates.empty(), subject_.scenario.path);
  return subject_.candidates.front();
}

ValueRanges LawScene::ranges() const {
  ValueRanges ranges;
  ranges.depth_near = subject_.orthographic ? 0 : 0.5f;
  ranges.depth_far = subject_.orthographic ? 1 : 20.0f;
  ranges.payload_min.fill(-0.5f);
  ranges.payload_max.fill(2.0f);
  return ranges;
}

std::unique_ptr<Player> LawScene::player(const VariantOptions& options, const PlayerOptions& player_options) {
  const Package package = buildPackage(subject_.program, candidate(), options, subject_.limits).value();
  return std::make_unique<Player>(renderer_->createPlayer(package, player_options).value());
}

PlayedFrame LawScene::play(Player& player, int frame, std::uint32_t period, bool frozen) {
  const SessionSpec& session = subject_.scenario.sessions.front();
  renderer_->setFrame(session, evaluateFrame(subject_.scenario, session, frozen ? 0 : frame));
  REPRISE_CHECK(commands_->run([&](VkCommandBuffer buffer) { return renderer_->record(buffer, player, targets_, period, {}); }).ok(), frame);
  PlayedFrame played;
  for (std::size_t i = 0; i < targets_.colors.size(); ++i) {
    const VkFormat format = renderer_->colorFormat(i);
    const auto bytes = readback_->read(*commands_, {targets_.colors[i].image.get(), format, targets_.extent, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}).value();
    played.raw.emplace_back(bytes.begin(), bytes.end());
    played.colors.push_back(toFloats(bytes, format));
  }
  if (renderer_->depthFormat() == VK_FORMAT_D32_SFLOAT) {
    const auto bytes = readback_->read(*commands_, {targets_.depth.image.get(), VK_FORMAT_D32_SFLOAT, targets_.extent,
                                                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}).value();
    played.depth.resize(bytes.size() / 4);
    std::memcpy(played.depth.data(), bytes.data(), bytes.size());
  }
  PixelKinds told = readKinds(*readback_, *commands_, player).value();
  played.kind = std::move(told.kind);
  played.age = std::move(told.age);
  if (const auto counts = player.resource("counts")) {
    const auto fragments = toFloats(readback_->read(*commands_, {counts->image, counts->format, counts->extent, counts->layout}).value(), counts->format);
    for (std::size_t at = 0; at < fragments.size(); at += 4) played.shaded_hits += fragments[at], played.shaded_misses += fragments[at + 1];
  }
  return played;
}

std::vector<std::string> lawScenarios() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

VariantOptions lawOptions(const LawScene& scene, const std::string& strategy, PatternKind pattern, Filter filter, Encoding encoding) {
  VariantOptions options = baseOptions(scene.subject(), scene.ranges());
  options.strategy = strategy;
  options.pattern = pattern;
  options.block_pixels = 8;
  options.filter = filter;
  options.encoding = encoding;
  options.instrumented = true;
  return options;
}

}  // namespace reprise
