#include "cli/commands/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <thread>

#include "cli/check/run_modules.h"
#include "compiler/strategies/strategy.h"
#include "profiler/scenario/near_names.h"
#include "runtime/vulkan/context.h"

namespace reprise {
namespace {

bool isShaderFile(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".frag" || extension == ".hlsl" || extension == ".spv" || extension == ".spvasm";
}

Result<std::vector<std::string>> filesOf(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    std::error_code status;
    if (std::filesystem::is_directory(name, status)) {
      std::vector<std::string> inside;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(name, status))
        if (entry.is_regular_file() && isShaderFile(entry.path())) inside.push_back(entry.path().string());
      if (inside.empty())
        return Error{ErrorKind::kInput, "file.missing", "the directory has no .frag, .hlsl, .spv or .spvasm files", {name, 0, 0}};
      std::sort(inside.begin(), inside.end());
      files.insert(files.end(), inside.begin(), inside.end());
    } else if (name == "-" || !std::filesystem::exists(name, status)) {
      return Error{ErrorKind::kInput, "file.missing", name == "-" ? "standard input cannot be checked; name a file" : "there is no such file", {name, 0, 0}};
    } else {
      files.push_back(name);
    }
  }
  return files;
}

Result<void> checkStrategy(const std::string& name) {
  const Strategy* strategy = name.empty() ? nullptr : findStrategy(name);
  if (name.empty() || (strategy != nullptr && strategy->selectable)) return {};
  std::vector<std::string> known;
  for (const Strategy& one : strategies())
    if (one.selectable) known.push_back(one.name);
  return Error{ErrorKind::kUsage, "strategy.unknown", "there is no strategy '" + name + "'" + suggestNames(name, known), {}};
}

std::string lineOf(const ModuleVerdict& verdict) {
  std::string line = fmt::format("{}: {}", verdict.path, verdict.verdict == Verdict::kFailed ? "FAILED" : nameOf(verdict.verdict));
  const bool unshown = verdict.verdict == Verdict::kUnshown;
  if (verdict.verdict == Verdict::kVerified || unshown) {
    line += fmt::format("{} ({} variants, {:.1f} s)", unshown ? " " + verdict.code : "", verdict.variants, verdict.seconds);
    for (const std::string& refused : verdict.refused_strategies) line += ", not " + refused;
    return verdict.reason.empty() ? line : line + ", " + verdict.reason;
  }
  return line + fmt::format(" {} {}", verdict.code, verdict.reason);
}

}  // namespace

Result<bool> checkShaders(const CheckArguments& arguments, std::ostream& out, std::ostream& progress) {
  REPRISE_TRY(checkStrategy(arguments.request.strategy));
  REPRISE_ASSIGN(const std::vector<std::string> files, filesOf(arguments.shaders));
  {
    // Without a device nothing can be checked: said once, not for every module.
    ContextOptions options;
    options.device = arguments.request.device;
    REPRISE_TRY(Context::create(options));
  }
  std::vector<CheckRequest> requests(files.size(), arguments.request);
  for (std::size_t i = 0; i < files.size(); ++i) requests[i].path = files[i];
  RunModulesOptions options;
  options.worker_path = arguments.worker_path;
  options.jobs = arguments.jobs > 0 ? arguments.jobs : static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  options.module_timeout_s = arguments.module_timeout_s;
  options.interrupted = arguments.interrupted;
  std::array<int, std::size(kVerdicts)> counts{};
  REPRISE_ASSIGN(const std::vector<ModuleVerdict> verdicts, runModules(requests, options, [&](const ModuleVerdict& verdict) {
                   ++counts[static_cast<std::size_t>(verdict.verdict)];
                   if (!arguments.json || !arguments.quiet) (arguments.json ? progress : out) << lineOf(verdict) << '\n' << std::flush;
                 }));
  if (arguments.json) {
    out << "{\"modules\": [\n";
    for (std::size_t i = 0; i < verdicts.size(); ++i) out << "  " << verdictToJson(verdicts[i]) << (i + 1 < verdicts.size() ? ",\n" : "\n");
    out << "], \"motion\": \"not judged\"}\n";
  } else if (files.size() > 1 && !arguments.quiet) {
    std::string summary = fmt::format("{} modules:", files.size());
    for (const Verdict verdict : kVerdicts)
      summary += fmt::format("{} {} {}", verdict == kVerdicts[0] ? "" : ",", counts[static_cast<std::size_t>(verdict)], nameOf(verdict));
    out << summary << '\n';
  }
  if (!arguments.json && !arguments.quiet)
    out << "motion was not judged: the vertex shaders and what moves are made up here; 'optimize' judges those of a scenario\n";
  return std::none_of(verdicts.begin(), verdicts.end(), [](const ModuleVerdict& verdict) { return isOurFault(verdict.verdict); });
}

}  // namespace reprise
