// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_engine.h>
#include <compare/engine/closed_form_engine.h>
#include <compare/engine/engine.h>
#include <compare/engine/plumb_engine.h>
#ifdef PLUMB_HAS_BOX2D3
#include <compare/engine/box2d3/box2d3_engine.h>
#endif

namespace plumb::compare {

const std::vector<Engine>& engines() {
    static const std::vector<Engine> list{
        plumbEngine(),
        box2d24Engine(),
#ifdef PLUMB_HAS_BOX2D3
        box2d3Engine(),
#endif
        closedFormEngine(),
    };
    return list;
}

}  // namespace plumb::compare
