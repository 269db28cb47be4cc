// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_engine.h>
#include <compare/engine/box2d3/box2d3_engine.h>
#include <compare/engine/chipmunk/chipmunk_engine.h>
#include <compare/engine/closed_form_engine.h>
#include <compare/engine/engine.h>
#include <compare/engine/plumb_engine.h>

namespace plumb::compare {

const std::vector<Engine>& engines() {
    static const std::vector<Engine> list = [] {
        std::vector<Engine> found{plumbEngine(), box2d24Engine()};
        if (const std::optional<Engine> box2d3 = box2d3Engine()) found.push_back(*box2d3);
        found.push_back(chipmunkEngine());
        found.push_back(closedFormEngine());
        return found;
    }();
    return list;
}

}  // namespace plumb::compare
