// Devices, command submission, images back and forth.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "runtime/playback/formats.h"
#include "runtime/vulkan/lane_probe.h"
#include "runtime/vulkan/readback.h"
#include "runtime/vulkan/upload.h"

namespace reprise {
namespace {

class Vulkan : public testing::Test {
 protected:
  void SetUp() override {
    ContextOptions options;
    options.validation = true;
    Result<Context> context = Context::create(options);
    ASSERT_TRUE(context.ok()) << formatError(context.error());
    context_.emplace(std::move(context).value());
    Result<Commands> commands = Commands::create(*context_);
    ASSERT_TRUE(commands.ok()) << formatError(commands.error());
    commands_.emplace(std::move(commands).value());
  }
  void TearDown() override {
    if (!context_) return;
    for (const std::string& message : context_->validation_messages()) ADD_FAILURE() << message;
  }

  std::optional<Context> context_;
  std::optional<Commands> commands_;
};

TEST_F(Vulkan, DevicesAreFoundByIndexAndByPartOfTheName) {
  const Result<std::vector<DeviceSummary>> devices = listDevices();
  ASSERT_TRUE(devices.ok());
  ASSERT_FALSE(devices->empty());
  for (const DeviceSummary& device : *devices) {
    EXPECT_FALSE(device.name.empty());
    EXPECT_FALSE(device.driver.empty());
    EXPECT_TRUE(device.api_version.starts_with("1.")) << device.api_version;
  }
  const DeviceSummary last = devices->back();
  const Result<Context> by_index = Context::create({std::to_string(last.index), false});
  ASSERT_TRUE(by_index.ok()) << formatError(by_index.error());
  EXPECT_EQ(by_index->summary().index, last.index);
  const Result<Context> by_name = Context::create({last.name.substr(0, 5), false});
  ASSERT_TRUE(by_name.ok()) << formatError(by_name.error());
  EXPECT_EQ(by_name->summary().name.substr(0, 5), last.name.substr(0, 5));
}

TEST_F(Vulkan, UnknownDeviceIsRefusedWithTheNamesThatThereAre) {
  const Result<Context> context = Context::create({"Voodoo2", false});
  ASSERT_FALSE(context.ok());
  EXPECT_EQ(context.error().code, "device.unknown");
  EXPECT_EQ(context.error().kind, ErrorKind::kMachine);
  EXPECT_NE(context.error().message.find(context_->summary().name), std::string::npos) << context.error().message;
}

// In a process of its own, whose environment it changes.
[[noreturn]] void exitByDevices() {
  setenv("VK_ICD_FILENAMES", "/nonexistent/driver.json", 1);
  setenv("VK_DRIVER_FILES", "/nonexistent/driver.json", 1);
  const Result<Context> context = Context::create({});
  const Result<std::vector<DeviceSummary>> devices = listDevices();
  const bool refused = !context.ok() && !devices.ok() && context.error().code == "device.none" &&
                       devices.error().code == "device.none" && context.error().kind == ErrorKind::kMachine;
  if (!context.ok()) std::fputs(context.error().message.c_str(), stderr);
  std::exit(refused ? 3 : 0);
}

TEST(VulkanDeathTest, NoDriverIsAMachineErrorInPlainWords) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitByDevices(), testing::ExitedWithCode(3), "no Vulkan device");
}

TEST_F(Vulkan, ErrorsOfTheRecorderComeBack) {
  const Result<void> ran =
      commands_->run([](VkCommandBuffer) -> Result<void> { return Error{ErrorKind::kInput, "test.refused", "refused", {}}; });
  ASSERT_FALSE(ran.ok());
  EXPECT_EQ(ran.error().code, "test.refused");
  EXPECT_TRUE(commands_->run([](VkCommandBuffer) -> Result<void> { return {}; }).ok());
}

TEST(VulkanError, FailedCallsAreToldApart) {
  EXPECT_EQ(vulkanError(VK_ERROR_DEVICE_LOST, "device.fn.vkQueueSubmit(x)").code, "device.lost");
  EXPECT_EQ(vulkanError(VK_ERROR_DEVICE_LOST, "vkQueueSubmit(x)").kind, ErrorKind::kMeasurement);
  EXPECT_EQ(vulkanError(VK_TIMEOUT, "vkWaitForFences(x)").code, "device.timeout");
  EXPECT_EQ(vulkanError(VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkAllocateMemory(x)").code, "device.memory");
  const Error call = vulkanError(VK_ERROR_FEATURE_NOT_PRESENT, "device.fn.vkCreateImage(device.device, &create)");
  EXPECT_EQ(call.code, "device.call");
  EXPECT_TRUE(call.message.starts_with("vkCreateImage failed")) << call.message;
}

TEST_F(Vulkan, HandlesDestroyOnceAndMove) {
  Result<Buffer> buffer = createBuffer(context_->view(), 16, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  ASSERT_TRUE(buffer.ok()) << formatError(buffer.error());
  ASSERT_EQ(buffer->mapped.size(), 16u);
  Handle<VkBuffer> first = std::move(buffer->buffer);
  EXPECT_FALSE(static_cast<bool>(buffer->buffer));
  Handle<VkBuffer> second;
  second = std::move(first);
  EXPECT_FALSE(static_cast<bool>(first));
  EXPECT_TRUE(static_cast<bool>(second));
  second.reset();
  second.reset();
  EXPECT_FALSE(static_cast<bool>(second));
}

TEST_F(Vulkan, TexturesComeBackAsTheyWentUp) {
  std::vector<std::uint8_t> texels(7 * 5 * 4);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 37);
  UploadDescription description;
  description.extent = {7, 5};
  description.mipmaps = true;
  const Result<Image> image = uploadTexture(*context_, *commands_, description, std::as_bytes(std::span(texels)));
  ASSERT_TRUE(image.ok()) << formatError(image.error());
  EXPECT_EQ(image->mip_levels, 3u);
  Readback readback(*context_);
  const auto bytes = readback.read(*commands_, {image->image.get(), VK_FORMAT_R8G8B8A8_UNORM, {7, 5}, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
  ASSERT_TRUE(bytes.ok()) << formatError(bytes.error());
  ASSERT_EQ(bytes->size(), texels.size());
  EXPECT_EQ(std::memcmp(bytes->data(), texels.data(), texels.size()), 0);
}

TEST_F(Vulkan, FormatsThatCannotBeReadAreRefused) {
  Readback readback(*context_);
  const auto bytes = readback.read(*commands_, {VK_NULL_HANDLE, VK_FORMAT_BC7_UNORM_BLOCK, {4, 4}});
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, "readback.format");
}

// The validation layer is silent about it; what comes of it is the device's, and the same every time.
TEST_F(Vulkan, LanesAreProbed) {
  const Result<LaneLoads> lanes = probeLanes(*context_);
  ASSERT_TRUE(lanes.ok()) << formatError(lanes.error());
  EXPECT_EQ(*lanes, probeLanes(*context_).value());
  const DeviceSummary& device = context_->summary();
  if (device.name.find("llvmpipe") == std::string::npos || device.driver.find("Mesa 22.3") == std::string::npos)
    GTEST_SKIP() << "what is expected is known of Mesa 22.3's lavapipe alone";
  EXPECT_EQ(*lanes, (LaneLoads{false, false, false})) << describeLanes(*lanes);
}

TEST(Lanes, AreDescribedByThoseThatDoNotLoad) {
  EXPECT_EQ(describeLanes({true, true, true}), "yes");
  EXPECT_EQ(describeLanes({false, false, true}), "no (helper, rejected)");
  EXPECT_EQ(describeLanes({true, true, false}), "no (discarded)");
}

TEST(ToFloats, EveryFormatOfARecipeCanBeReadBack) {
  for (int i = 0; i <= static_cast<int>(ResourceFormat::kR32Sfloat); ++i) {
    const auto format = static_cast<ResourceFormat>(i);
    EXPECT_EQ(formatBytes(vulkanFormat(format)), static_cast<std::uint32_t>(bytesPerPixel(format))) << nameOf(format);
  }
}

TEST(ToFloats, SixteenBitUnorm) {
  const std::uint16_t words[] = {0, 65535, 32768, 1};
  const std::vector<float> rgba = toFloats(std::as_bytes(std::span(words)), VK_FORMAT_R16G16_UNORM);
  EXPECT_EQ(rgba, (std::vector<float>{0, 1, 0, 1, 32768 / 65535.0f, 1 / 65535.0f, 0, 1}));
}

TEST(ToFloats, HalfFloatsOfEveryKind) {
  // Zero, one, -2, the largest, the smallest denormal, infinity.
  const std::uint16_t halves[] = {0x0000, 0x3c00, 0xc000, 0x7bff, 0x0001, 0x7c00};
  const std::vector<float> rgba = toFloats(std::as_bytes(std::span(halves)), VK_FORMAT_R16_SFLOAT);
  const float expected[] = {0, 1, -2, 65504, 0x1p-24f, HUGE_VALF};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(rgba[4 * i], expected[i]) << i;
  EXPECT_EQ(rgba[1], 0);  // channels that the format lacks
  EXPECT_EQ(rgba[3], 1);
}

TEST(ToFloats, IntegersAreTheirValues) {
  const std::uint32_t words[] = {7, 0xfffffffeu};
  EXPECT_EQ(toFloats(std::as_bytes(std::span(words)), VK_FORMAT_R32G32_UINT), (std::vector<float>{7, 4294967294.0f, 0, 1}));
  EXPECT_EQ(toFloats(std::as_bytes(std::span(words)), VK_FORMAT_R32G32_SINT), (std::vector<float>{7, -2, 0, 1}));
}

TEST(ToFloats, BytesAreShares) {
  const std::uint8_t bytes[] = {0, 51, 255, 102};
  const std::vector<float> rgba = toFloats(std::as_bytes(std::span(bytes)), VK_FORMAT_R8G8B8A8_UNORM);
  EXPECT_EQ(rgba, (std::vector<float>{0, 51 / 255.0f, 1, 102 / 255.0f}));
}

}  // namespace
}  // namespace reprise
