// One module under check, played in this process: its prepared form and its variants, beside what the reference shows.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "cli/check/divergent_quads.h"
#include "cli/check/hold_laws.h"
#include "cli/check/reference/reference.h"
#include "compiler/strategies/build_package.h"

namespace reprise {

class ModulePlayer {
 public:
  // context and commands must outlive it. limits: what the harness and the device allow.
  ModulePlayer(const Context& context, Commands& commands, ShaderProgram program, Reference reference, const StateLimits& limits = {true, true, true});

  const ShaderProgram& program() const { return program_; }

  // What is played from here on, and which pixels are left out of comparisons with it. Errors: those of Harness and divergentQuads.
  Result<void> setInputs(const HarnessOptions& inputs);

  // Errors: those of Reference and Harness.
  Result<Originals> originals(bool no_contraction);
  // Another module in the original's place: the same vertex shader and inputs.
  Result<std::vector<HarnessFrame>> playWords(const std::vector<std::uint32_t>& fragment_words);
  // Errors: those of buildPackage; device.requirement (kRefused).
  Result<VariantFrames> variant(const Candidate& candidate, const std::string& strategy, bool no_contraction);
  // Whether wrong payloads on purpose change what the variant showed under motion.
  Result<bool> poisonShows(const Candidate& candidate, const std::string& strategy, const std::vector<HarnessFrame>& moving);

  // By frame and pixel, of the inputs that are set.
  const std::vector<std::vector<bool>>& leftOut() const { return left_out_; }

  // Of a candidate in a strategy; of the module itself without one.
  LawTerms terms(const Candidate* candidate, const std::string& strategy) const;

 private:
  const ShaderProgram& programOf(bool no_contraction);
  // What `make` makes, once for all inputs: pipelines cost far more than frames. Ready for frame 0.
  Result<Player*> playerFor(const std::string& key, const std::function<Result<Player>()>& make);
  Result<Player*> variantPlayer(const Candidate& candidate, const VariantOptions& options, bool no_contraction);

  const Context& context_;
  Commands& commands_;
  ShaderProgram program_;
  std::unique_ptr<const ShaderProgram> strict_;  // with NoContraction on every operation
  Reference reference_;
  StateLimits limits_;
  HarnessOptions inputs_;
  std::unique_ptr<Harness> harness_;  // of the inputs
  std::map<std::string, Player> players_;
  std::optional<DivergentQuads> divergent_quads_;
  std::vector<std::vector<bool>> left_out_;
};

// The module that everything is made from, as it would ship uncached.
std::vector<std::uint32_t> preparedWords(const ShaderProgram& program);

}  // namespace reprise
