// SPDX-License-Identifier: MIT
// Where are a scene's bodies while it runs, whoever runs it?
#pragma once
#include <stdexcept>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb::compare {

struct BodyState {
    Vec2 position{0, 0};         ///< of the body's origin [m]
    double angle = 0;            ///< not reset after whole turns [rad]
    Vec2 velocity{0, 0};         ///< of the centre of mass [m/s]
    double angularVelocity = 0;  ///< [rad/s]
    bool present = true;         ///< false before it appears; then the other members say where it will appear
};

/// Says for each joint, by its index in the scene, whether it has broken. A joint beyond the list's end has not broken.
using Broken = std::vector<bool>;

/// Thrown by an engine that lacks something that is in the scene, and where no formula is known for it.
struct Unsupported : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace plumb::compare
