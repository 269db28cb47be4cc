// SPDX-License-Identifier: MIT
// Which forces do the fields exert on a body at its position?
#pragma once
#include <vector>

#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Sets pull to the sum of all fields' effects on a body. now: the motions of the bodies, by slot. Only this body's is
/// needed, but all of them if a field depends on other bodies (see dependsOnOtherBodies).
void pullOn(const FieldStores& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull);

}  // namespace plumb
