#include "cli/commands/emit.h"

#include <algorithm>
#include <filesystem>

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
  REPRISE_ASSIGN(const Package package, packageFor(subject, choice, arguments, notes));
  if (!arguments.output.empty()) REPRISE_TRY(writePackageIfChanged(package, arguments.output));
  if (!arguments.header.empty()) {
    REPRISE_ASSIGN(const std::string text, packageHeader(package, arguments.header_name));
    REPRISE_TRY(writeIfChanged(arguments.header, text));
  }
  if (!arguments.depfile.empty()) REPRISE_TRY(writeDepfile(arguments.depfile, targetOf(arguments), dependencies));
  return {};
}

}  // namespace reprise
