#include "tests/session/spoiled_package.h"

#include <bit>

#include "compiler/ir/module.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "runtime/package/package.h"

namespace reprise {

void spoilPackage(const std::string& package_dir, const std::string& to, const std::string& module, float from_value, float to_value) {
  Package package = readPackage(package_dir).value();
  const auto found = package.modules.find(module);
  REPRISE_CHECK(found != package.modules.end(), module);
  Module changed = readModule(found->second).value();
  int replaced = 0;
  for (Instruction& global : changed.globals) {
    if (global.opcode != spv::Op::OpConstant || global.word(0) != std::bit_cast<std::uint32_t>(from_value)) continue;
    global.operands[0].words[0] = std::bit_cast<std::uint32_t>(to_value);
    ++replaced;
  }
  REPRISE_CHECK(replaced > 0, module, from_value);
  found->second = writeModule(changed);
  for (ModuleEntry& entry : package.variant.modules)
    if (entry.name == module) entry.hash = contentHash(bytesOf(found->second));
  const Result<void> written = writePackageFiles(package, to);
  REPRISE_CHECK(written.ok(), formatError(written.error()));
}

}  // namespace reprise
