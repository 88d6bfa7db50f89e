#include "cli/report/write_report.h"

#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/report/embedded_picture.h"
#include "cli/report/page_text.h"
#include "cli/report/text.h"
#include "runtime/base/check.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPngBytes = 3'000'000;
constexpr int kMostWidth = 1280, kStripWidth = 320;  // pixels
constexpr int kQuality = 88, kStripQuality = 80;
constexpr std::size_t kTextReserve = 400'000;  // for what else the page holds

Json dataUri(const std::vector<std::uint8_t>& png) { return png.empty() ? Json(nullptr) : Json(pngDataUri(png)); }

// Pictures of the evidence by name. The strip is small and comes first, so that large pictures cannot crowd it out.
class PictureShelf {
 public:
  PictureShelf(const ReportEvidence& evidence, std::size_t room) : evidence_(evidence), room_(room) {
    for (const EvidenceFrame& frame : evidence.evidence.strip)
      for (const std::string& name : {frame.original, frame.cached}) add(name, jpeg(name, kStripWidth, kStripQuality));
    addLarge(evidence.evidence.original);
    for (const EvidencePictures& one : evidence.evidence.pictures)
      for (const std::string& name : {one.cached, one.error, one.hit_miss, one.payload}) addLarge(name);
  }
  Json take() { return std::move(shelf_); }

 private:
  void addLarge(const std::string& name) {
    const auto file = evidence_.files.find(name);
    if (file == evidence_.files.end()) return;
    const std::size_t size = file->second.size() * 4 / 3;
    if (as_png_ + size <= kMostPngBytes && size + kTextReserve <= room_) {
      as_png_ += size;
      return add(name, pngDataUri(file->second));
    }
    add(name, jpeg(name, kMostWidth, kQuality));
  }
  std::optional<std::string> jpeg(const std::string& name, int most_width, int quality) const {
    const auto file = evidence_.files.find(name);
    return file == evidence_.files.end() ? std::nullopt : jpegDataUri(file->second, most_width, quality);
  }
  void add(const std::string& name, const std::optional<std::string>& uri) {
    if (!uri || uri->size() + kTextReserve > room_ || shelf_.contains(name)) return;
    room_ -= uri->size();
    shelf_[name] = *uri;
  }

  const ReportEvidence& evidence_;
  std::size_t room_;
  std::size_t as_png_ = 0;
  Json shelf_ = Json::object();
};

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

std::string dataBlock(const RunResult& result, const ReportImages& images, const std::optional<ReportEvidence>& evidence) {
  Json block;
  block["headline"] = choiceSentence(result);
  if (const std::optional<std::string> leading = leadingWarning(result)) block["leading"] = printable(*leading);
  block["result"] = Json::parse(resultToJson(result));
  block["evidence"] = evidence ? Json::parse(evidenceToJson(evidence->evidence)) : Json(nullptr);
  // The evidence has the same pictures.
  const bool has_pictures = evidence && !evidence->evidence.pictures.empty();
  const ReportImages none;
  const ReportImages& embedded = has_pictures ? none : images;
  block["images"] = {{"original", dataUri(embedded.original)},
                     {"cached", dataUri(embedded.cached)},
                     {"error", dataUri(embedded.error)},
                     {"hit_miss", dataUri(embedded.hit_miss)}};
  const std::size_t used = block.dump(-1, ' ', false, Json::error_handler_t::replace).size();
  block["pictures"] = evidence ? PictureShelf(*evidence, used < kMostPageBytes ? kMostPageBytes - used : 0).take() : Json::object();
  return withoutTags(block.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string reportHtml(const RunResult& result, const ReportImages& images, const std::optional<ReportEvidence>& evidence) {
  const std::pair<std::string_view, std::string> places[] = {
      {"@TITLE@", escapedText(printable(result.scenario.name))},
      {"@STYLE@", kPageCss},
      {"@SUMMARY@", escapedText(summaryText(result))},
      {"@DATA@", dataBlock(result, images, evidence)},
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

Result<void> writeReport(const RunResult& result, const ReportImages& images, const std::optional<ReportEvidence>& evidence,
                         const std::filesystem::path& html) {
  return writeFile(html, reportHtml(result, images, evidence));
}

}  // namespace reprise
