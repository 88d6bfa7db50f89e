// Opens pages in headless Chromium and hands back what they drew and what they wrote to the console.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace reprise {

struct OpenedPage {
  std::string dom, console;

  // The drawn part only, without the data block and the scripts, which hold every name anyway, and without what stands for the page where
  // scripts are switched off.
  std::string body() const;
  // The figure of a tile as the page holds it: data-name="..." data-value="...". NaN if there is none.
  double tile(const std::string& name) const;
};

// A test with a folder of its own and a browser; skipped loudly where Chromium is missing.
class BrowserTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  // The document after its scripts and then `script` have run.
  OpenedPage openPage(std::string html, const std::string& script) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace reprise
