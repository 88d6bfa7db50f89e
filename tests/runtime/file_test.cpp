// Which files are read, and how much of them.
#include "runtime/base/file.h"

#include <gtest/gtest.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace reprise {
namespace {

namespace fs = std::filesystem;

class ReadFile : public testing::Test {
 protected:
  ReadFile() {
    std::string name = (fs::temp_directory_path() / "reprise_file_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~ReadFile() override { fs::remove_all(folder_); }

  // 20 GB that do not lie on the disk.
  fs::path sparse() const {
    const fs::path file = folder_ / "sparse";
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
    EXPECT_EQ(ftruncate(descriptor, 20'000'000'000), 0);
    close(descriptor);
    return file;
  }

  static std::string codeOf(const fs::path& file, std::size_t most = kMostTextBytes) {
    const Result<std::string> bytes = readFile(file, most);
    if (bytes.ok()) return "";
    EXPECT_EQ(bytes.error().kind, ErrorKind::kInput);
    EXPECT_EQ(bytes.error().place.file, file.string());
    return bytes.error().code;
  }

  fs::path folder_;
};

TEST_F(ReadFile, GivesTheBytesOfARegularFile) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(writeFile(folder_ / "a", bytes).ok());
  EXPECT_EQ(readFile(folder_ / "a").value(), bytes);
  ASSERT_TRUE(writeFile(folder_ / "long", std::string(300'000, 'x')).ok());
  EXPECT_EQ(readFile(folder_ / "long").value(), std::string(300'000, 'x'));
  ASSERT_TRUE(writeFile(folder_ / "empty", "").ok());
  EXPECT_EQ(readFile(folder_ / "empty").value(), "");
}

TEST_F(ReadFile, RefusesWhatIsNoRegularFile) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(codeOf(folder_ / "pipe"), "file.not_regular");
  EXPECT_EQ(codeOf("/dev/zero"), "file.not_regular");
  EXPECT_EQ(codeOf(folder_), "file.not_regular");
  fs::create_symlink("/dev/zero", folder_ / "link");
  EXPECT_EQ(codeOf(folder_ / "link"), "file.not_regular");
  EXPECT_EQ(codeOf(folder_ / "nonesuch"), "file.missing");
}

TEST_F(ReadFile, RefusesWhatIsLargerThanItsLimitWithBothNumbers) {
  const Result<std::string> bytes = readFile(sparse(), 1000);
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, "file.too_large");
  for (const char* number : {"20000000000", "1000 "}) EXPECT_NE((bytes.error().message + " ").find(number), std::string::npos) << bytes.error().message;
  ASSERT_TRUE(writeFile(folder_ / "ten", "0123456789").ok());
  EXPECT_EQ(codeOf(folder_ / "ten", 9), "file.too_large");
  EXPECT_EQ(codeOf(folder_ / "ten", 10), "");
}

TEST_F(ReadFile, ReadsNoMoreThanItsLimitOfAFileThatDoesNotSayItsSize) {
  EXPECT_EQ(codeOf("/proc/self/mem"), "file.unreadable");
  EXPECT_EQ(codeOf("/proc/self/maps", 64), "file.too_large");
  EXPECT_FALSE(readFile("/proc/self/stat").value().empty());
}

TEST_F(ReadFile, StandardInputHasALimitToo) {
  const int before = dup(STDIN_FILENO), zeros = open("/dev/zero", O_RDONLY);
  dup2(zeros, STDIN_FILENO);
  EXPECT_EQ(codeOf("/dev/stdin", 1 << 20), "file.too_large");
  EXPECT_EQ(readStandardInput("-", 1 << 20).error().code, "file.too_large");
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(write(ends[1], "text", 4), 4);
  close(ends[1]);
  dup2(ends[0], STDIN_FILENO);
  EXPECT_EQ(readStandardInput("-", 4).value(), "text");
  dup2(before, STDIN_FILENO);
  for (const int descriptor : {before, zeros, ends[0]}) close(descriptor);
}

}  // namespace
}  // namespace reprise
