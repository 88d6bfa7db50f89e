#include "cli/report_directory.h"

#include <filesystem>

#include "cli/report/text.h"
#include "cli/report/write_report.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

// Names in the files are those of pictures in DIR/images; one with a folder in it is no such name.
Result<std::vector<std::uint8_t>> readPicture(const std::filesystem::path& directory, const std::string& name) {
  if (name.empty()) return std::vector<std::uint8_t>{};
  if (std::filesystem::path(name).filename() != name)
    return Error{ErrorKind::kInput, "evidence.invalid", "the picture '" + name + "' does not lie in the directory of the images", {}};
  REPRISE_ASSIGN(const std::string bytes, readFile(directory / name, kMostImageBytes));
  return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

Result<ReportImages> readImages(const RunImages& images, const std::filesystem::path& directory) {
  ReportImages loaded;
  REPRISE_ASSIGN(loaded.original, readPicture(directory, images.original));
  REPRISE_ASSIGN(loaded.cached, readPicture(directory, images.cached));
  REPRISE_ASSIGN(loaded.error, readPicture(directory, images.error));
  REPRISE_ASSIGN(loaded.hit_miss, readPicture(directory, images.hit_miss));
  return loaded;
}

Result<std::optional<ReportEvidence>> readEvidence(const std::filesystem::path& root) {
  if (!std::filesystem::exists(root / "evidence.json")) return std::optional<ReportEvidence>{};
  REPRISE_ASSIGN(const std::string text, readFile(root / "evidence.json"));
  ReportEvidence loaded;
  REPRISE_ASSIGN(loaded.evidence, evidenceFromJson(text));
  std::vector<std::string> names{loaded.evidence.original};
  for (const EvidencePictures& one : loaded.evidence.pictures) names.insert(names.end(), {one.cached, one.error, one.hit_miss, one.payload});
  for (const EvidenceFrame& frame : loaded.evidence.strip) names.insert(names.end(), {frame.original, frame.cached});
  for (const std::string& name : names) {
    if (name.empty()) continue;
    REPRISE_ASSIGN(loaded.files[name], readPicture(root / "images", name));
  }
  return std::optional<ReportEvidence>(std::move(loaded));
}

Result<RunResult> readResult(const std::filesystem::path& root) {
  REPRISE_ASSIGN(const std::string text, readFile(root / "result.json"));
  return resultFromJson(text);
}

}  // namespace

Result<void> reportAgain(const std::string& directory) {
  const std::filesystem::path root = directory;
  REPRISE_ASSIGN(const RunResult result, readResult(root));
  REPRISE_ASSIGN(const ReportImages images, readImages(result.images, root / "images"));
  REPRISE_ASSIGN(const std::optional<ReportEvidence> evidence, readEvidence(root));
  return writeReport(result, images, evidence, root / "report.html");
}

Result<std::string> reportText(const std::string& directory, const std::string& format) {
  REPRISE_ASSIGN(const RunResult result, readResult(directory));
  if (format == "markdown") return summaryMarkdown(result);
  if (format == "csv") return pointsCsv(result);
  return Error{ErrorKind::kUsage, "report.format", "there is no report as '" + format + "'; there are html, markdown and csv", {}};
}

}  // namespace reprise
