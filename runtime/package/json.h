// JSON values of the package's parts, for the .cpp files of this folder. The readers throw std::exception on damage.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "runtime/package/interface.h"
#include "runtime/package/recipe.h"

namespace reprise {

nlohmann::json recipeJson(const Recipe& recipe);
Recipe recipeFrom(const nlohmann::json& from);
nlohmann::json interfaceJson(const ShaderInterface& interface);
ShaderInterface interfaceFrom(const nlohmann::json& from);

}  // namespace reprise
