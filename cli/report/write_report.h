// The HTML report: one file that needs nothing else, neither network nor other files.
//
// The page (cli/report/page/) and the data are apart: the page is the same for every run and reads one JSON
// block,
// {"headline": text, "result": result.json, "images": {name: data URI or null}}. What comes from files
// (names, paths, reasons) reaches the page only through that block and as text nodes, never as markup.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/report/result.h"
#include "runtime/base/result.h"

namespace reprise {

// PNG files in memory; empty where there is none. All of one frame: RunImages says which.
struct ReportImages {
  std::vector<std::uint8_t> original, cached, error, hit_miss;
};

// The page as text. Nothing in it changes from call to call.
std::string reportHtml(const RunResult& result, const ReportImages& images);

// Writes it, whole or not at all. Errors: file.unwritable.
Result<void> writeReport(const RunResult& result, const ReportImages& images,
                         const std::filesystem::path& html);

}  // namespace reprise
