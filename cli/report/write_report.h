// The HTML report: one file that needs nothing else, neither network nor other files.
//
// The page (cli/report/page/) and the data are apart: the page is the same for every run and reads one JSON block,
// {"headline": text, "result": result.json, "evidence": evidence.json or null, "images": {name: data URI or null},
// "pictures": {file name: data URI}}. What comes from files (names, paths, sources, reasons) reaches the page only through that block
// and as text nodes, never as markup.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/report/evidence.h"
#include "cli/report/result.h"
#include "runtime/base/result.h"

namespace reprise {

// PNG files in memory; empty where there is none. All of one frame: RunImages says which.
struct ReportImages {
  std::vector<std::uint8_t> original, cached, error, hit_miss;
};

// What evidence.json names. Pictures are embedded in the order of the evidence, as PNG while there is room, then as JPEG, and left out
// when the page would exceed kMostPageBytes.
struct ReportEvidence {
  RunEvidence evidence;
  std::map<std::string, std::vector<std::uint8_t>> files;  // PNG, by name
};
inline constexpr std::size_t kMostPageBytes = 6'000'000;

// The page as text. Nothing in it changes from call to call.
std::string reportHtml(const RunResult& result, const ReportImages& images, const std::optional<ReportEvidence>& evidence = {});

// Writes it, whole or not at all. Errors: file.unwritable.
Result<void> writeReport(const RunResult& result, const ReportImages& images, const std::optional<ReportEvidence>& evidence,
                         const std::filesystem::path& html);

}  // namespace reprise
