// A package as a C++ header, for programs that carry it in themselves. It is read with readEmbeddedPackage
// (runtime/package/embedded.h), which checks it as readPackage checks a directory.
#pragma once

#include <string>

#include "runtime/base/result.h"
#include "runtime/package/package.h"

namespace reprise {

// The header's text: namespace reprise_packages with `name`, an array of EmbeddedFile. The same package gives the same text.
Result<std::string> packageHeader(const Package& package, const std::string& name);

// Whether it can name the constant: a C++ identifier.
bool isHeaderName(const std::string& name);

}  // namespace reprise
