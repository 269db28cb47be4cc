// SPDX-License-Identifier: MIT
// Where is a body, in floats, and how far can it come in this step?
#pragma once

namespace plumb {

/// One cache line: four rows of four floats. A place is the sum of two floats, high and low, so that the difference of
/// two is as exact as a float can be anywhere in the world.
struct alignas(64) BodyPlace {
    float highX = 0, highY = 0, lowX = 0, lowY = 0;  ///< centre of mass [m]
    float cos = 1, sin = 0;                          ///< of its angle
    float rho = 1;                                   ///< inverse radius of gyration [1/m]
    float unused = 0;
    float shiftX = 0, shiftY = 0;  ///< of the centre in this step, if nothing is in the way [m]
    float turn = 0;                ///< how far turning takes its outline at most [m]
    float unused2 = 0;
    float pullX = 0, pullY = 0;  ///< speed that its acceleration gives it in half of this step [m/s]
    float unused3 = 0, unused4 = 0;
};

}  // namespace plumb
