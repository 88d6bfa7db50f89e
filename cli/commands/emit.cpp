#include "cli/commands/emit.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "cli/choice_threshold.h"
#include "cli/hold_laws.h"
#include "cli/open_bench.h"
#include "cli/package_header.h"
#include "cli/package_of_choice.h"
#include "cli/version.h"
#include "cli/write_changed.h"
#include "compiler/source/depfile.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

Result<void> checkArguments(const EmitArguments& arguments) {
  if (arguments.output.empty() && arguments.header.empty() && !arguments.list_dependencies)
    return Error{ErrorKind::kUsage, "emit.output", "say where the package goes, with -o DIRECTORY or --header FILE", {}};
  if (!isHeaderName(arguments.header_name))
    return Error{ErrorKind::kUsage, "emit.name", "--name is '" + arguments.header_name + "'; it must be a C++ identifier", {}};
  return {};
}

// The package of the choice; of the original where the choice says so, or where it is stale and that is allowed.
Result<Package> packageFor(const Subject& subject, const Choice& choice, const EmitArguments& arguments, std::ostream& notes) {
  if (choice.is_original) return shippedPackage(subject, nullptr);
  const auto made = [&]() -> Result<Package> {
    REPRISE_ASSIGN(const ChosenVariant variant, variantOf(subject, choice));
    return shippedPackage(subject, &variant);
  };
  Result<Package> package = made();
  if (package.ok() || arguments.on_stale == OnStale::kFail) return package;
  Error reason = package.error();
  notes << "note: the original is shipped: " << formatError(reason) << '\n';
  return shippedPackage(subject, nullptr);
}

// A workspace for as long as the package is verified.
class ScratchFolder {
 public:
  ScratchFolder() : path_(fs::temp_directory_path() / ("reprise-emit-" + std::to_string(::getpid()))) {}
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Plays the package, as it is about to be written, beside the original.
Result<void> verify(Subject subject, const Choice& choice, const Package& package, const EmitArguments& arguments) {
  REPRISE_ASSIGN(const ChosenVariant variant, variantOf(subject, choice));
  subject.candidates = {variant.candidate};
  REPRISE_ASSIGN(const DeviceSummary device, chosenDevice(arguments.device));
  const ScratchFolder folder;
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(folder.path()));
  REPRISE_TRY(copyInputs(subject, workspace.scenarioFile()));
  REPRISE_TRY(writePackageFiles(package, workspace.packageDir()));
  REPRISE_ASSIGN(Bench bench, openBench(subject, workspace, {arguments.device, arguments.worker_path, choice.limits.metrics(), arguments.interrupted}, device));
  bench.measuring.store = &bench.store;
  Progress progress(ProgressStyle::kQuiet);
  REPRISE_ASSIGN(const std::vector<LawVerdict> verdicts,
                 holdLaws(subject, workspace, bench.measuring, {{variant.candidate, variant.options, {workspace.packageDir().string()}}}, progress));
  if (!verdicts[0].conviction) return {};
  return Error{ErrorKind::kInput, verdicts[0].conviction->code, "nothing was written: " + verdicts[0].conviction->message, {}};
}

std::string targetOf(const EmitArguments& arguments) {
  if (!arguments.depfile_target.empty()) return arguments.depfile_target;
  return arguments.output.empty() ? arguments.header : (fs::path(arguments.output) / "manifest.json").string();
}

}  // namespace

Result<void> emitChoice(const EmitArguments& arguments, std::ostream& out, std::ostream& notes) {
  REPRISE_TRY(checkArguments(arguments));
  REPRISE_ASSIGN(const Subject subject, readSubjectUnranked(arguments.scenario));
  std::vector<std::string> dependencies = dependenciesOf(subject);
  dependencies.push_back(fs::absolute(arguments.choice).lexically_normal().string());
  if (arguments.list_dependencies) {
    REPRISE_ASSIGN(const std::string rule, depfileText(targetOf(arguments), dependencies));
    out << rule;
    return {};
  }
  REPRISE_ASSIGN(const Choice choice, readChoice(arguments.choice));
  if (choice.tool_version != kToolVersion)
    notes << "note: " << arguments.choice << " was made by reprise " << choice.tool_version << ", this is " << kToolVersion
          << "; 'reprise validate --choice' tells whether it still holds\n";
  REPRISE_TRY(holdThresholds(choice, arguments.asked, arguments.scenario));
  REPRISE_ASSIGN(const Package package, packageFor(subject, choice, arguments, notes));
  const bool ships_variant = !choice.is_original && package.variant.strategy != package.original.strategy;
  if (arguments.verify && ships_variant) REPRISE_TRY(verify(subject, choice, package, arguments));
  if (!arguments.output.empty()) REPRISE_TRY(writePackageIfChanged(package, arguments.output));
  if (!arguments.header.empty()) {
    REPRISE_ASSIGN(const std::string text, packageHeader(package, arguments.header_name));
    REPRISE_TRY(writeIfChanged(arguments.header, text));
  }
  if (!arguments.depfile.empty()) REPRISE_TRY(writeDepfile(arguments.depfile, targetOf(arguments), dependencies));
  return {};
}

}  // namespace reprise
