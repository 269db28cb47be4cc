// SPDX-License-Identifier: MIT
// Where is a body, and how far may it move in this step, for code that collides several pairs at a time?
#pragma once

namespace plumb {

/// A body's place and predicted motion in this step. One cache line: four rows of four floats. Each coordinate is the
/// sum of two floats, high and low, so that the difference of two places is as exact as a float can be, everywhere in
/// the world.
struct alignas(64) BodyPlace {
    float highX = 0, highY = 0, lowX = 0, lowY = 0;  ///< centre of mass [m]
    float cos = 1, sin = 0;                          ///< of its angle
    float inverseGyration = 1;                       ///< inverse radius of gyration [1/m]
    float unused = 0;
    float shiftX = 0, shiftY = 0;  ///< displacement of the centre in this step, if nothing touches the body [m]
    float turn = 0;                ///< upper bound on how far the rotation moves a point of the outline [m]
    float unused2 = 0;
    float pullX = 0, pullY = 0;  ///< velocity change by its acceleration in half of this step [m/s]
    float unused3 = 0, unused4 = 0;
};

}  // namespace plumb
