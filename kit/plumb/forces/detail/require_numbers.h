// SPDX-License-Identifier: MIT
// Are the numbers of a law within what its description allows?
#pragma once

namespace plumb {

struct Attractor;
struct Drag;
struct Fluid;
struct GroundFriction;
struct MutualGravity;
struct UniformGravity;

// Each throws std::invalid_argument with the member's name, its value and what is wanted. Vectors are left out, but for
// a fluid's: a centre may be a body's, and a step never throws.

void requireNumbers(const Attractor& law);
void requireNumbers(const Drag& law);
void requireNumbers(const Fluid& fluid);
void requireNumbers(const GroundFriction& law);
void requireNumbers(const MutualGravity& law);
void requireNumbers(const UniformGravity& law);

}  // namespace plumb
