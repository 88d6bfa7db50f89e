// `reprise play`: plays a package through a scenario's session, in this process.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

struct PlayArguments {
  std::string directory;  // a package, or the output of `reprise optimize`, which holds DIR/package and DIR/scenario
  std::string scenario;   // a TOML file; empty: DIR/scenario/scenario.toml
  std::string session;    // empty: the scenario's first validation session, or its first
  int frames = 0;         // 0: the session's
  std::optional<std::uint32_t> period_frames;  // empty: the package's; kNeverRefresh: never
  bool original = false;  // play the original that the package holds
  std::string png_dir;    // frame_0000.png, ... as displayed; empty: none
  bool hashes = false;    // print one line per frame
  std::string device;
};

// Prints what is played and, where asked for, of each frame the hash of its colour outputs (equal hashes: equal bits) and, for
// packages that count, hits and misses. Where the device lacks what the variant needs the original is played, and the reason
// is said. Errors: play.scenario (kUsage; no scenario given and none beside the package), those of readPackage,
// readScenario and checkBindings, session.unknown, file.unwritable, device.*.
Result<void> playPackage(const PlayArguments& arguments, std::ostream& out);

}  // namespace reprise
