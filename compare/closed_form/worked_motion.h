// SPDX-License-Identifier: MIT
// What is the result for one body of a closed form?
#pragma once
#include <compare/scene/closed_form.h>

namespace plumb::compare {

struct WorkedMotion {
    BodyMotion motion{};  ///< with its numbers
    double until = 0;     ///< it holds until this time; 0: to the scene's end [s]
};

}  // namespace plumb::compare
