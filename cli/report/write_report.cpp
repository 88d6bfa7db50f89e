#include "cli/report/write_report.h"

#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/report/page_text.h"
#include "cli/report/text.h"
#include "runtime/base/check.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[at + i] : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? kDigits[group >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

Json dataUri(const std::vector<std::uint8_t>& png) {
  return png.empty() ? Json(nullptr) : Json("data:image/png;base64," + base64(png));
}

// JSON may stand in a script element once it has no '<': neither "</script" nor "<!--" can then end or change
// it.
std::string withoutTags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string escapedText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

std::string dataBlock(const RunResult& result, const ReportImages& images) {
  Json block;
  block["headline"] = choiceSentence(result);
  block["result"] = Json::parse(resultToJson(result));
  block["images"] = {{"original", dataUri(images.original)},
                     {"cached", dataUri(images.cached)},
                     {"error", dataUri(images.error)},
                     {"hit_miss", dataUri(images.hit_miss)}};
  return withoutTags(block.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string reportHtml(const RunResult& result, const ReportImages& images) {
  const std::pair<std::string_view, std::string> places[] = {
      {"@TITLE@", escapedText(printable(result.scenario.name))},
      {"@STYLE@", kPageCss},
      {"@SUMMARY@", escapedText(summaryText(result))},
      {"@DATA@", dataBlock(result, images)},
      {"@SCRIPT@", kPageJs},
  };
  // One walk through the template: what is filled in is never searched for places.
  std::string_view rest = kPageHtml;
  std::string html;
  for (const auto& [place, text] : places) {
    const std::size_t at = rest.find(place);
    REPRISE_CHECK(at != std::string_view::npos,
                  "page.html lacks " + std::string(place) + ", or has it out of order");
    html += rest.substr(0, at);
    html += text;
    rest.remove_prefix(at + place.size());
  }
  html += rest;
  return html;
}

Result<void> writeReport(const RunResult& result, const ReportImages& images,
                         const std::filesystem::path& html) {
  return writeFile(html, reportHtml(result, images));
}

}  // namespace reprise
