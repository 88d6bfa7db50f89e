#include "cli/check/reference/reference_messages.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace reprise {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::uint32_t>;

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void append(Words& body, const Words& part) { body.insert(body.end(), part.begin(), part.end()); }

// Takes the parts of a body in order.
class BodyReader {
 public:
  explicit BodyReader(const Words& body) : body_(body) {}

  Words take(std::size_t count) {
    if (count > body_.size() - at_) throw std::out_of_range("the body of a message is too short");
    const auto begin = body_.begin() + static_cast<std::ptrdiff_t>(at_);
    at_ += count;
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }

 private:
  const Words& body_;
  std::size_t at_ = 0;
};

}  // namespace

PipeMessage messageOf(const ReferenceModule& module) {
  PipeMessage message;
  message.head = textOf({{"path", module.path}, {"device", module.device}, {"vertex_words", module.vertex_words.size()},
                         {"fragment_words", module.fragment_words.size()}});
  append(message.body, module.vertex_words);
  append(message.body, module.fragment_words);
  return message;
}

ReferenceModule moduleFrom(const PipeMessage& message) {
  const Json head = Json::parse(message.head);
  BodyReader body(message.body);
  ReferenceModule module;
  module.path = head.at("path");
  module.device = head.at("device");
  module.vertex_words = body.take(head.at("vertex_words"));
  module.fragment_words = body.take(head.at("fragment_words"));
  return module;
}

PipeMessage messageOf(const ReferenceAsk& ask) {
  Json integers = Json::array();
  for (const IntegerValue& one : ask.inputs.integers)
    integers.push_back({{"kind", static_cast<int>(one.input.kind)}, {"location", one.input.location}, {"component", one.input.component},
                        {"set", one.input.set}, {"binding", one.input.binding}, {"offsets", one.input.offsets}, {"value", one.value}});
  return {textOf({{"seed", ask.inputs.seed}, {"width", ask.inputs.width}, {"height", ask.inputs.height}, {"frames", ask.frames},
                  {"no_contraction", ask.no_contraction}, {"integers", integers}}), {}};
}

ReferenceAsk askFrom(const PipeMessage& message) {
  const Json head = Json::parse(message.head);
  ReferenceAsk ask;
  ask.inputs.seed = head.at("seed");
  ask.inputs.width = head.at("width");
  ask.inputs.height = head.at("height");
  ask.frames = head.at("frames");
  ask.no_contraction = head.at("no_contraction");
  for (const Json& described : head.at("integers")) {
    IntegerValue one;
    one.input.kind = static_cast<IntegerInput::Kind>(described.at("kind").get<int>());
    one.input.location = described.at("location");
    one.input.component = described.at("component");
    one.input.set = described.at("set");
    one.input.binding = described.at("binding");
    one.input.offsets = described.at("offsets").get<std::vector<std::uint32_t>>();
    one.value = described.at("value");
    ask.inputs.integers.push_back(std::move(one));
  }
  return ask;
}

PipeMessage messageOf(const Result<std::vector<HarnessFrame>>& answer) {
  if (!answer.ok()) {
    const Error& error = answer.error();
    return {textOf({{"kind", static_cast<int>(error.kind)}, {"code", error.code}, {"message", error.message}}), {}};
  }
  PipeMessage message;
  Json frames = Json::array();
  for (const HarnessFrame& frame : *answer) {
    Json colors = Json::array();
    for (const Words& color : frame.colors) {
      colors.push_back(color.size());
      append(message.body, color);
    }
    append(message.body, frame.depth);
    frames.push_back({{"colors", colors}, {"depth", frame.depth.size()}});
  }
  message.head = textOf({{"frames", frames}});
  return message;
}

Result<std::vector<HarnessFrame>> answerFrom(const PipeMessage& message) {
  const Json head = Json::parse(message.head);
  if (head.contains("code")) return Error{static_cast<ErrorKind>(head.at("kind").get<int>()), head.at("code"), head.at("message"), {}};
  BodyReader body(message.body);
  std::vector<HarnessFrame> frames;
  for (const Json& described : head.at("frames")) {
    HarnessFrame frame;
    for (const Json& size : described.at("colors")) frame.colors.push_back(body.take(size));
    frame.depth = body.take(described.at("depth"));
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace reprise
