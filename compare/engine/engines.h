// SPDX-License-Identifier: MIT
// How is a scene run in each engine?
#pragma once
#include <compare/engine/engine.h>
#include <compare/engine/own_track.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb::compare {

Engine plumbEngine(const SolverSettings& solver = {});

/// Box2D 2.4 at its defaults: 8 velocity and 3 position iterations a step. The restitution threshold is 0 if a scene
/// bounces. A capsule is a box and two discs on one body, with the capsule's mass; a rounded polygon has a skin of its
/// radius, and its own mass. Unsupported: rolling resistance, polygons with more than 8 corners or with corners that
/// Box2D would weld, capsules not thicker than twice its skin, rods and segments of chains not longer than its slop,
/// filter categories and groups beyond 16 bits, numbers beyond single precision.
/// bullets: each body that moves at the start is flagged as a bullet, and the engine is called "box2d-2.4 bullets".
Engine box2d24Engine(bool bullets = false);

/// Box2D 3.2 or later at its defaults, among them 4 sub-steps a step. The restitution threshold is 0 if a scene
/// bounces. Unsupported: polygons with more than 8 corners or with corners that Box2D would weld, rings with fewer than
/// 4 points, capsules, segments and rods shorter than its slop, numbers beyond single precision. bullets: each body
/// that moves at the start is flagged as a bullet, and the engine is called "box2d-3 bullets". If Plumb was built
/// without Box2D 3, the engine cannot build any scene.
Engine box2d3Engine(bool bullets = false, int subSteps = 4);

/// Chipmunk 7 at its defaults: 10 iterations a step, and joints that remove a tenth of their error in a sixtieth of a
/// second. Its slop is made for pixels, so Box2D's slop is used. A capsule is a segment with a radius, and a chain is a
/// list of segments. A wheel or a slide is a groove with springs and motors. Unsupported: rolling resistance, one-way
/// shapes, locks along an axis, pulleys, targets, motors along a line, welds with a soft anchor, and gears except
/// between two hinges on static bases.
Engine chipmunkEngine();

/// States are NaN for bodies and times for which the closed form gives nothing. It has no probes.
Engine closedFormEngine();

/// What a lecture does without an engine; each runs only if it is named. Five methods of integration with a loop that
/// tests all pairs in each frame (see textbook/frame_loop.h; the number collisionTest chooses how); a loop, Plumb and
/// Box2D 3 with steps as long as the frames of a display, and Plumb by a fixed clock (textbook/frames.h); bisection and
/// swept test of one frame (textbook/search.h).
std::vector<Engine> textbookEngines();

/// What somebody measured or calculated, beside the engines. It is in no list: whoever has a track adds it for a run.
/// States are NaN for other bodies that are not static, and before the first and after the last row; a body's angle is
/// NaN unless the closed form says that it does not turn. It has no probes. Its build throws std::invalid_argument if
/// the scene does not have the body, if the track names none and the scene has no dynamic one, and if no step of the
/// scene is within the rows.
Engine mineEngine(OwnTrack track);

}  // namespace plumb::compare
