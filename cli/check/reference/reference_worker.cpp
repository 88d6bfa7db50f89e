// The side of the reference that renders. Nothing here may touch compiler/ir or what stands on it.
#include <unistd.h>

#include <array>
#include <memory>
#include <optional>

#include "cli/check/reference/no_contraction.h"
#include "cli/check/reference/play_original.h"
#include "cli/check/reference/child_process.h"
#include "cli/check/reference/reference_messages.h"
#include "compiler/source/reflect.h"
#include "compiler/source/validate.h"

namespace reprise {
namespace {

struct Device {
  std::unique_ptr<const Context> context;
  Commands commands;
  ShaderInterface interface;
  std::array<std::optional<Player>, 2> players;  // of the module as given, and with NoContraction: made when first asked for
};

Result<Device> openDevice(const ReferenceModule& module) {
  ReflectOptions lenient;
  lenient.skip_unknown_members = lenient.any_arrays = lenient.any_bindings = true;
  REPRISE_ASSIGN(ShaderInterface interface, reflectInterface(module.vertex_words, module.fragment_words, lenient));
  ContextOptions options;
  options.device = module.device;
  REPRISE_ASSIGN(Context context, Context::create(options));
  auto kept = std::make_unique<const Context>(std::move(context));
  REPRISE_ASSIGN(Commands commands, Commands::create(*kept));
  return Device{std::move(kept), std::move(commands), std::move(interface), {}};
}

Result<Player> createPlayer(const Harness& harness, const ReferenceAsk& ask, const ReferenceModule& module, const Device& device) {
  std::vector<std::uint32_t> words = module.fragment_words;
  if (ask.no_contraction) {
    words = withNoContraction(words);
    REPRISE_TRY(validateModule(words));
  }
  return harness.createPlayer(originalPackage({device.interface, module.vertex_words, words}), true);
}

Result<std::vector<HarnessFrame>> answerTo(const ReferenceAsk& ask, const ReferenceModule& module, Device& device) {
  REPRISE_ASSIGN(Harness harness, Harness::create(*device.context, device.commands, device.interface, ask.inputs));
  std::optional<Player>& player = device.players[ask.no_contraction ? 1 : 0];
  if (!player) {
    REPRISE_ASSIGN(player, createPlayer(harness, ask, module, device));
  }
  player->restart();
  return playFrames(harness, *player, ask.frames);
}

}  // namespace

int runReferenceWorker() {
  belongToParent();
  // Drivers that print to standard output must not garble the answers.
  const int answers = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  const std::optional<PipeMessage> first = receiveMessage(STDIN_FILENO);
  if (!first) return 1;
  const ReferenceModule module = moduleFrom(*first);
  Result<Device> device = openDevice(module);
  while (const std::optional<PipeMessage> message = receiveMessage(STDIN_FILENO)) {
    const Result<std::vector<HarnessFrame>> answer =
        device.ok() ? answerTo(askFrom(*message), module, *device) : Result<std::vector<HarnessFrame>>(device.error());
    if (!sendMessage(answers, messageOf(answer))) return 1;
  }
  return 0;
}

}  // namespace reprise
