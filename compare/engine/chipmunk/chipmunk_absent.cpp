// SPDX-License-Identifier: MIT
// This is compiled instead of the engine for a page.
#include <compare/engine/chipmunk/chipmunk_card.h>
#include <compare/engine/engines.h>

namespace plumb::compare {

Engine chipmunkEngine() {
    Engine engine{chipmunkCard(), {}, {}};
    engine.missing = "use a build for this machine: pages are built without it";
    return engine;
}

}  // namespace plumb::compare
