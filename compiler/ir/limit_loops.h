// Loops that do not end by themselves, made visible.
//
// Devices end such loops as they like: a driver may stop after some thousand iterations and then skip later loops, another hangs. What
// a shader shows after that is no result to compare with.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace reprise {

// An invocation whose loops, all together, take more than `most` iterations leaves them where they branch to their merge blocks,
// and discards its fragment when its entry point returns. Helper invocations leave, too: endless ones keep a driver that counts
// for a group of lanes from running the others' loops. For modules of one entry point.
Module limitLoops(const Module& module, std::uint32_t most);

}  // namespace reprise
