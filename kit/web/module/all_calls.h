// SPDX-License-Identifier: MIT
// Which functions does JavaScript have, in the order of their numbers?
#pragma once
#include <web/module/formula_calls.h>
#include <web/module/mover_calls.h>
#include <web/module/shape_calls.h>
#include <web/module/world_calls.h>

namespace plumb::web {

void listAllCalls(auto&& list) {
    listEditCalls(list);
    listQueryCalls(list);
    listBodyCalls(list);
    listOtherViewCalls(list);
    listShapeCalls(list);
    listGridCalls(list);
    listPlatformCalls(list);
    listPathCalls(list);
    listClockCalls(list);
    listBallisticsCalls(list);
    listKinematicsCalls(list);
    listSteeringCalls(list);
}

}  // namespace plumb::web
