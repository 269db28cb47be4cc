// SPDX-License-Identifier: MIT
#include <compare/lab/builtin.h>

#include <compare/lab/builtin/labs.h>

namespace plumb::compare {

std::vector<Lab> builtinLabs() {
    return {
        frameRate(), integrators(), convergence(), broadPhases(), bulletAndWindow(), forecasts(), flushTiles(),
    };
}

std::optional<Lab> findLab(const std::string& name) {
    for (Lab& lab : builtinLabs()) {
        if (lab.name == name) return std::move(lab);
    }
    return std::nullopt;
}

}  // namespace plumb::compare
