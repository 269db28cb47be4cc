// SPDX-License-Identifier: MIT
// What do the fields do to a body where it is?
#pragma once
#include <vector>

#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// now: where each body is, by its slot: this one, and, where fields look around, all.
void pullOn(const FieldView& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull);

}  // namespace plumb
