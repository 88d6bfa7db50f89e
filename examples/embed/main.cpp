// Plays a package of Reprise in an application of its own:
//
//   embed PACKAGE [--original] [--frames N] [--png DIR]
//
// renders N frames (default 16) without a window, prints the content hash of each, and writes them as PNG
// files if asked to.
// --original plays the shader as it was given, from the same package: the switch that an application would
// put into its menu.
#include <runtime/base/hash.h>
#include <runtime/package/package.h>
#include <stb/stb_image_write.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "renderer.h"
#include "vulkan_app.h"

namespace {

struct Arguments {
  std::string package_dir, png_dir;
  embed::Mode mode = embed::Mode::kCached;
  int frames = 16;
};

bool parse(int argc, char** argv, Arguments& arguments) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--original") {
      arguments.mode = embed::Mode::kOriginal;
    } else if (word == "--frames" && i + 1 < argc) {
      arguments.frames = std::atoi(argv[++i]);
    } else if (word == "--png" && i + 1 < argc) {
      arguments.png_dir = argv[++i];
    } else if (arguments.package_dir.empty() && !word.starts_with("-")) {
      arguments.package_dir = word;
    } else {
      return false;
    }
  }
  return !arguments.package_dir.empty() && arguments.frames > 0;
}

void writePng(const std::vector<std::uint8_t>& pixels, const std::filesystem::path& path) {
  const int width = embed::kWidth, height = embed::kHeight;
  if (!stbi_write_png(path.c_str(), width, height, 4, pixels.data(), width * 4)) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

void run(const Arguments& arguments) {
  reprise::Result<reprise::Package> package = reprise::readPackage(arguments.package_dir);
  if (!package.ok()) throw std::runtime_error(reprise::formatError(package.error()));

  embed::VulkanApp app;
  embed::Renderer renderer(app, *package, arguments.mode);
  std::printf("%s on %s\n", renderer.player().recipe().strategy.c_str(), app.deviceName().c_str());
  if (!renderer.player().originalReason().empty()) {
    std::printf("the original is played: %s\n", renderer.player().originalReason().c_str());
  }

  if (!arguments.png_dir.empty()) std::filesystem::create_directories(arguments.png_dir);
  for (int frame = 0; frame < arguments.frames; ++frame) {
    const std::vector<std::uint8_t> pixels = renderer.renderFrame(frame);
    const auto* bytes = reinterpret_cast<const char*>(pixels.data());
    std::printf("frame %04d %s\n", frame, reprise::contentHash({bytes, pixels.size()}).c_str());
    if (arguments.png_dir.empty()) continue;
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", frame);
    writePng(pixels, std::filesystem::path(arguments.png_dir) / name);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fprintf(stderr, "usage: embed PACKAGE [--original] [--frames N] [--png DIR]\n");
    return 2;
  }
  try {
    run(arguments);
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "embed: %s\n", exception.what());
    return 1;
  }
  return 0;
}
