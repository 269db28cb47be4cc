// SPDX-License-Identifier: MIT
// Which engines have a world of their own? All but the closed form.
#pragma once
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

inline std::vector<Engine> simulators() {
    std::vector<Engine> result = engines();
    std::erase_if(result, [](const Engine& engine) { return engine.role == Role::Truth; });
    return result;
}

}  // namespace plumb::compare
