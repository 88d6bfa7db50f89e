// A package with something in every list, of modules that are SPIR-V by their header only.
#pragma once

#include "runtime/package/package.h"

namespace reprise {

Package twoPassPackage();

}  // namespace reprise
