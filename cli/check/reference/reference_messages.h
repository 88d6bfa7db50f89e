// What a checking process and its reference say to each other.
#pragma once

#include "cli/check/reference/pipe_messages.h"
#include "cli/check/reference/reference.h"

namespace reprise {

PipeMessage messageOf(const ReferenceModule& module);
PipeMessage messageOf(const ReferenceAsk& ask);
PipeMessage messageOf(const Result<std::vector<HarnessFrame>>& answer);

// Of messages that the functions above made; others throw a std::exception.
ReferenceModule moduleFrom(const PipeMessage& message);
ReferenceAsk askFrom(const PipeMessage& message);
Result<std::vector<HarnessFrame>> answerFrom(const PipeMessage& message);

}  // namespace reprise
