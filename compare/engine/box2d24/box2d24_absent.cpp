// SPDX-License-Identifier: MIT
// This is compiled instead of the engine for a page.
#include <compare/engine/box2d24/box2d24_card.h>
#include <compare/engine/engines.h>

namespace plumb::compare {

Engine box2d24Engine(bool) {
    Engine engine{box2d24Card(), {}, {}};
    engine.missing = "use a build for this machine: pages are built without it";
    return engine;
}

}  // namespace plumb::compare
