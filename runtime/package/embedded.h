// A package that a program carries in itself, as bytes under the names of its files (made by `reprise emit --header`).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/package/package.h"

namespace reprise {

struct EmbeddedFile {
  const char* name;  // "manifest.json", "vertex.spv"
  const unsigned char* bytes;
  std::size_t size;
};

// The same checks and errors as readPackage; a file that is not there is file.missing.
Result<Package> readEmbeddedPackage(std::span<const EmbeddedFile> files);

// The files of a package that a program needs: its modules, then the manifest.
struct PackageFile {
  std::string name, bytes;
};
std::vector<PackageFile> packageFiles(const Package& package);

}  // namespace reprise
