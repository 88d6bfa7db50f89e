// A package as a faulty rewrite would leave it: valid, with one constant of one module that is another.
#pragma once

#include <string>

namespace reprise {

// Copies the package to `to` with every float constant of `from_value` in the module replaced. Stops the test where there is none.
void spoilPackage(const std::string& package_dir, const std::string& to, const std::string& module, float from_value, float to_value);

}  // namespace reprise
