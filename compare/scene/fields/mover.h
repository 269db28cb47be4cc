// SPDX-License-Identifier: MIT
// Which fields does a mover have in a file, and which values may they have?
#pragma once
#include <compare/scene/fields/field.h>
#include <compare/scene/fields/tags.h>

namespace plumb::compare {

void fields(auto& visit, OrConst<plumb::Cell> auto& x) {
    visit({"column", "-", Allowed::any, "from the left, from 0"}, x.column);
    visit({"row", "-", Allowed::any, "from the bottom, from 0"}, x.row);
}
void fields(auto& visit, OrConst<PathMotion> auto& x) {
    visit(needed({"points", "m", Allowed::finite, "of the body's origin"}, 2), x.points);
    visit({"spline", "", Allowed::any, "false: straight lines from point to point"}, x.spline);
    visit({"closed", "", Allowed::any, "does it go back to the first point?"}, x.closed);
    visit({"delay", "s", Allowed::notNegative, "it rests first for this time"}, x.delay);
    visit({"speed", "m/s", Allowed::positive, "the highest"}, x.speed);
    visit({"acceleration", "m/s^2", Allowed::positive, "with easing \"acceleration\""}, x.acceleration);
    visit({"easing", "", Allowed::any, "how it starts and stops"}, x.easing);
    visit({"repeat", "", Allowed::any, "what it does at the end"}, x.repeat);
}
void fields(auto& visit, OrConst<SlidingMotion> auto& x) {
    visit({"velocity", "m/s", Allowed::finite, "wanted"}, x.velocity);
    visit({"pushStrength", "N", Allowed::notNegative, "with which it pushes what it meets"}, x.pushStrength);
    visit({"standIn", "", Allowed::any, "what takes its place in an engine that has no such movers"}, x.standIn);
}
void fields(auto& visit, OrConst<GridMotion> auto& x) {
    visit(needed({"map", "", Allowed::any, "the name of a body whose first shape is a tile map"}), x.map);
    visit({"cell", "", Allowed::any, "in which it starts"}, x.cell);
    visit({"heading", "", Allowed::any, "where it goes first"}, x.heading);
    visit({"speed", "tiles/s", Allowed::positive, "at which it goes"}, x.speed);
    visit({"turns", "", Allowed::any, "each turn is wanted after the one before; then again from the first"}, x.turns);
}
void fields(auto& visit, OrConst<PlatformCue> auto& x) {
    visit({"time", "s", Allowed::notNegative, "from when on"}, x.time);
    visit({"move", "-", Allowed::within(-1, 1), "to the left or to the right"}, x.move);
    visit({"run", "", Allowed::any, "is the button to run held?"}, x.run);
    visit({"jump", "", Allowed::any, "is the button to jump held?"}, x.jump);
}
void fields(auto& visit, OrConst<PlatformMotion> auto& x) {
    visit({"profile", "", Allowed::any, "how it runs and jumps"}, x.profile);
    visit({"cues", "", Allowed::any, "what a player holds, in the order of their times"}, x.cues);
}
void fields(auto& visit, OrConst<SwingMotion> auto& x) {
    visit({"amplitude", "m", Allowed::finite, "how far, and along which line"}, x.amplitude);
    visit({"rate", "rad/s", Allowed::positive, "2 pi over the period"}, x.rate);
}
void fields(auto& visit, OrConst<SteeredMotion> auto& x) {
    visit({"behaviour", "", Allowed::any, "what it wants"}, x.behaviour);
    visit({"target", "", Allowed::any, "the name of a body; none for one that wanders, follows or flocks"}, x.target);
    visit({"velocity", "m/s", Allowed::finite, "at the start"}, x.velocity);
    visit({"maxSpeed", "m/s", Allowed::positive, "the highest"}, x.maxSpeed);
    visit({"maxAcceleration", "m/s^2", Allowed::positive, "the highest"}, x.maxAcceleration);
    visit({"points", "m", Allowed::finite, "with \"follow\": of the path, 2 or more"}, x.points);
    visit({"closed", "", Allowed::any, "with \"follow\": does the path go back to the first point?"}, x.closed);
    visit({"ahead", "m", Allowed::positive, "with \"follow\": how far along the path it looks"}, x.ahead);
    visit({"seed", "", Allowed::any, "with \"wander\": the same seed gives the same way"}, x.seed);
}
void fields(auto& visit, OrConst<SceneMover> auto& x) {
    visit(needed({"name", "", Allowed::any, "unlike the other movers'"}), x.name);
    visit(needed({"body", "", Allowed::any, "the name of a kinematic body"}), x.body);
    visit.oneOf(x.motion, moverTags);
}

}  // namespace plumb::compare
