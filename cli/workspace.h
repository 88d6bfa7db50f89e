// The output directory of a run: its lock, its store, and the variants that were built for measuring.
//
//   DIR/package        what ships
//   DIR/scenario       copies of the inputs: scenario.toml, compiled shaders, textures
//   DIR/result.json    DIR/report.html, DIR/images
//   DIR/work           variants under measurement and measurements.sqlite: what a resumed run goes on from
#pragma once

#include <filesystem>
#include <string>

#include "compiler/strategies/build_recipe.h"
#include "runtime/base/result.h"

namespace reprise {

// Owns the directory's lock for as long as it lives.
class Workspace {
 public:
  // Makes the directory. Errors: output.not_a_directory (kUsage), output.busy (kInput; another run holds the lock, which a
  // dead process cannot), file.unwritable (kMachine).
  static Result<Workspace> open(const std::filesystem::path& directory);
  Workspace() = default;
  Workspace(Workspace&& other) noexcept;
  Workspace& operator=(Workspace&& other) noexcept;
  ~Workspace();

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path packageDir() const { return root_ / "package"; }
  std::filesystem::path scenarioFile() const { return root_ / "scenario" / "scenario.toml"; }
  std::filesystem::path storeFile() const { return root_ / "work" / "measurements.sqlite"; }
  std::filesystem::path imagesDir() const { return root_ / "images"; }

 private:
  std::filesystem::path root_;
  int lock_ = -1;
};

// A variant on disk, ready to be played by a worker.
struct StoredVariant {
  std::string dir;
  std::string hash;  // of recipe and modules, the period left out: it is a run-time parameter
  Recipe recipe;
};

// Builds a package among the variants of the workspace unless it is there already. Errors: those of buildPackage and writePackage.
Result<StoredVariant> storeVariant(const Workspace& workspace, const ShaderProgram& program, const Candidate& candidate,
                                   const VariantOptions& options, const StateLimits& limits);

}  // namespace reprise
