// Which shaders have to be looked at with zeros for undefined values.
#include "cli/check/undefined_values.h"

#include <gtest/gtest.h>

#include "compiler/source/compile.h"

namespace reprise {
namespace {

bool mayShow(const std::string& body) {
  const std::string text = "#version 450\nlayout(location = 0) in vec3 place;\nlayout(location = 0) out vec4 color;\n"
                           "layout(location = 1) out vec4 other;\nvoid main() { other = vec4(1.0); " + body + " }\n";
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  const CompiledShader shader = compileText(text, "test.frag", options).value();
  return mayShowUndefined(prepareForCaching(readModule(shader.words).value(), "").value());
}

TEST(UndefinedValues, AreSeen) {
  EXPECT_FALSE(mayShow("float a; a = sin(place.x); color = vec4(a);"));
  EXPECT_FALSE(mayShow("float a; if (place.x > 0.0) a = 1.0; else a = 2.0; color = vec4(a);"));
  EXPECT_TRUE(mayShow("float a; if (place.x > 0.0) a = 1.0; color = vec4(a);"));
  EXPECT_TRUE(mayShow("vec4 a; a.x = place.x; color = a;"));
  EXPECT_TRUE(mayShow("if (place.x > 0.0) color = vec4(1.0);"));
  EXPECT_TRUE(mayShow("color.x = 1.0;"));
  EXPECT_TRUE(mayShow("float a[3]; a[int(place.y)] = 1.0; color = vec4(a[int(place.x)]);"));
}

}  // namespace
}  // namespace reprise
