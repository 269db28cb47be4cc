// SPDX-License-Identifier: MIT
// Which fields does a closed form have in a file, and which values may they have?
#pragma once
#include <compare/scene/fields/field.h>
#include <compare/scene/fields/tags.h>

namespace plumb::compare {

/// The field that names the body of a motion.
inline constexpr Field whoseBody = needed({"body", "", Allowed::any, "the name of the body that moves so"});

void fields(auto& visit, OrConst<Flight> auto& x) {
    visit({"start", "s", Allowed::finite, "from when it holds; the first from 0"}, x.start);
    visit({"position", "m", Allowed::finite, "of the body's origin, at start"}, x.position);
    visit({"velocity", "m/s", Allowed::finite, "at start"}, x.velocity);
    visit({"acceleration", "m/s^2", Allowed::finite, "all the time"}, x.acceleration);
    visit({"angle", "rad", Allowed::finite, "at start"}, x.angle);
    visit({"angularVelocity", "rad/s", Allowed::finite, "at start"}, x.angularVelocity);
    visit({"angularAcceleration", "rad/s^2", Allowed::finite, "all the time"}, x.angularAcceleration);
}
void fields(auto& visit, OrConst<PiecewiseMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"flights", "", Allowed::any, "in the order of their starts; each holds until the next"}), x.flights);
}
void fields(auto& visit, OrConst<DampedFlight> auto& x) {
    visit(whoseBody, x.body);
    visit({"position", "m", Allowed::finite, "at t = 0"}, x.position);
    visit({"velocity", "m/s", Allowed::finite, "at t = 0"}, x.velocity);
    visit({"acceleration", "m/s^2", Allowed::finite, "g"}, x.acceleration);
    visit(needed({"damping", "1/s", Allowed::positive, "k"}), x.damping);
}
void fields(auto& visit, OrConst<PendulumMotion> auto& x) {
    visit(whoseBody, x.body);
    visit({"pivot", "m", Allowed::finite, "about which it swings"}, x.pivot);
    visit({"length", "m", Allowed::positive, "from the pivot to the body's origin"}, x.length);
    visit({"equivalentLength", "m", Allowed::positive, "L = I_pivot / (m l): length itself for a point mass"},
          x.equivalentLength);
    visit({"gravity", "m/s^2", Allowed::positive, "downward"}, x.gravity);
    visit({"amplitude", "rad", Allowed::finite, "theta at t = 0, between -pi and pi; positive to the right"},
          x.amplitude);
    visit({"bodyAngle", "rad", Allowed::finite, "of the body at t = 0"}, x.bodyAngle);
    visit({"turns", "", Allowed::any, "does the body turn with theta? false for a bob that keeps its angle"}, x.turns);
    visit({"from", "s", Allowed::notNegative, "not 0: it passes straight down then, on its way up to amplitude"},
          x.from);
    visit({"approach", "m/s", Allowed::finite, "at which it comes to there, straight; 0: it hangs there until then"},
          x.approach);
    visit({"side", "", Allowed::any, "on which side it swings; the rest of the time it hangs still"}, x.side);
}
void fields(auto& visit, OrConst<OscillatorMotion> auto& x) {
    visit(whoseBody, x.body);
    visit({"rest", "m", Allowed::finite, "where it comes to rest"}, x.rest);
    visit({"direction", "-", Allowed::finite.butNotZero("has no direction"), "of x, a unit vector"}, x.direction);
    visit({"offset", "m", Allowed::finite, "x at t = 0"}, x.offset);
    visit({"speed", "m/s", Allowed::finite, "x' at t = 0"}, x.speed);
    visit({"mass", "kg", Allowed::positive, "m"}, x.mass);
    visit({"stiffness", "N/m", Allowed::positive, "k"}, x.stiffness);
    visit({"damping", "N s/m", Allowed::notNegative, "c"}, x.damping);
}
void fields(auto& visit, OrConst<DragFall> auto& x) {
    visit(whoseBody, x.body);
    visit({"position", "m", Allowed::finite, "x0"}, x.position);
    visit({"terminalSpeed", "m/s", Allowed::positive, "v_t, which it never reaches"}, x.terminalSpeed);
    visit({"gravity", "m/s^2", Allowed::positive, "downward"}, x.gravity);
}
void fields(auto& visit, OrConst<KeplerMotion> auto& x) {
    visit(whoseBody, x.body);
    visit({"focus", "m", Allowed::finite, "the point about which it goes, at t = 0"}, x.focus);
    visit({"drift", "m/s", Allowed::finite, "velocity of the focus"}, x.drift);
    visit({"nearEnd", "-", Allowed::finite.butNotZero("has no direction"),
           "from the focus to the near end, a unit vector"},
          x.nearEnd);
    visit({"semiMajorAxis", "m", Allowed::positive, "half of the ellipse's length"}, x.semiMajorAxis);
    visit({"eccentricity", "-", Allowed::within(0, 1), "1 falls straight in"}, x.eccentricity);
    visit({"period", "s", Allowed::positive, "of a round"}, x.period);
    visit({"since", "s", Allowed::finite, "time since the near end at t = 0, counter-clockwise"}, x.since);
}
void fields(auto& visit, OrConst<FreeMotion> auto& x) {
    visit(whoseBody, x.body);
    visit({"shortestFlight", "s", Allowed::positive,
           "the first flight off a face that would be shorter, and all after it, count as rest"},
          x.shortestFlight);
}
void fields(auto& visit, OrConst<SwingsMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"joint", "", Allowed::any, "the name of its hinge, or of its rod"}), x.joint);
    visit({"side", "", Allowed::any, "on which side it swings, of a row of alike discs; the rest it hangs still"},
          x.side);
    visit({"after", "", Allowed::any, "the name of the body whose swing it takes over; empty: its own"}, x.after);
}
void fields(auto& visit, OrConst<SpringsMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"joint", "", Allowed::any, "the name of a distance joint with a spring"}), x.joint);
}
void fields(auto& visit, OrConst<FloatsMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"field", "", Allowed::any, "the name of a pool"}), x.field);
}
void fields(auto& visit, OrConst<OrbitsMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"field", "", Allowed::any, "the name of mutual gravity, or of a magnet of power 2"}), x.field);
}
void fields(auto& visit, OrConst<HoistedMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"joint", "", Allowed::any, "the name of a pulley"}), x.joint);
}
void fields(auto& visit, OrConst<GearedMotion> auto& x) {
    visit(whoseBody, x.body);
    visit(needed({"joint", "", Allowed::any, "the name of its hinge or slide"}), x.joint);
}
void fields(auto& visit, OrConst<CaughtMotion> auto& x) {
    visit(needed({"body", "", Allowed::any, "the name of the body that moves so: of the bullet or of the block"}),
          x.body);
    visit(needed({"bullet", "", Allowed::any, "the name of what stays in the block"}), x.bullet);
    visit(needed({"block", "", Allowed::any, "the name of what catches it, on rods"}), x.block);
}
void fields(auto& visit, OrConst<RestsMotion> auto& x) {
    visit(whoseBody, x.body);
}
void fields(auto& visit, OrConst<BodyMotion> auto& x) {
    visit.oneOf(x, motionTags);
}
void fields(auto& visit, OrConst<ClosedForm> auto& x) {
    visit({"formula", "", Allowed::any, "in plain text, for the report"}, x.formula);
    visit({"source", "", Allowed::any, "where it comes from"}, x.source);
    visit({"until", "s", Allowed::notNegative, "it holds from t = 0 to here; 0: to the scene's end"}, x.until);
    visit(needed({"bodies", "", Allowed::any, "the motions of the bodies that have a closed form"}), x.bodies);
}

}  // namespace plumb::compare
