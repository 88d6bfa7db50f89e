#include "tests/report/browser.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr const char* kBrowser = "/usr/bin/chromium";
constexpr const char* kBrowserOptions =
    " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update"
    " --disable-sync --enable-logging=stderr --v=0 --window-size=1280,900 --virtual-time-budget=5000";

}  // namespace

std::string OpenedPage::body() const {
  const std::string end_of_words = "</noscript>";
  const std::size_t words = dom.find(end_of_words), start = words == std::string::npos ? 0 : words + end_of_words.size();
  return dom.substr(start, dom.find("<script type=\"application/json\"", start) - start);
}

double OpenedPage::tile(const std::string& name) const {
  const std::string text = body(), start = "data-name=\"" + name + "\" data-value=\"";
  const std::size_t at = text.find(start);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + start.size()));
}

void BrowserTest::SetUp() {
  if (!std::filesystem::exists(kBrowser)) {
    std::cerr << "NOT TESTED: " << kBrowser << " is missing, so no report was opened in a browser (apt-get install chromium)\n";
    GTEST_SKIP() << kBrowser << " is missing";
  }
  std::string pattern = (std::filesystem::temp_directory_path() / "reprise_browser_XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  folder_ = pattern;
}

void BrowserTest::TearDown() {
  if (!folder_.empty()) std::filesystem::remove_all(folder_);
}

OpenedPage BrowserTest::openPage(std::string html, const std::string& script) const {
  const std::filesystem::path page_file = folder_ / "page.html", dom_file = folder_ / "dom", log_file = folder_ / "log";
  const std::size_t end_of_script = html.rfind("</script>");
  EXPECT_NE(end_of_script, std::string::npos);
  if (end_of_script != std::string::npos) html.insert(end_of_script, script + "\n");
  EXPECT_TRUE(writeFile(page_file, html).ok());
  const std::string command = std::string("timeout 120 ") + kBrowser + kBrowserOptions + " --user-data-dir='" + (folder_ / "profile").string() +
                              "' --dump-dom 'file://" + page_file.string() + "' > '" + dom_file.string() + "' 2> '" + log_file.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << readFile(log_file).value();
  OpenedPage page{readFile(dom_file).value(), ""};
  std::istringstream log(readFile(log_file).value());
  for (std::string line; std::getline(log, line);)
    if (line.find("CONSOLE") != std::string::npos) page.console += line + "\n";
  return page;
}

}  // namespace reprise
