// SPDX-License-Identifier: MIT
// What are the parts of a scene called in its schema, and what does each mean?
#pragma once
#include <compare/scene/fields.h>

namespace plumb::compare {

struct PartName {
    const char* name = nullptr;
    const char* meaning = "";  ///< a phrase or a formula
};

/// A part that the kit describes has the kit's own name.
template <class T>
inline constexpr PartName partOf{definitionName<T>.type, ""};

template <>
inline constexpr PartName partOf<Scene>{"Scene", "what is put into each engine, what is watched, and what must hold"};
template <>
inline constexpr PartName partOf<SceneBody>{"SceneBody", "a body, and when it is there"};
template <>
inline constexpr PartName partOf<SceneJoint>{"SceneJoint",
                                             "a joint of one kind, between bodies or joints by their names"};
template <>
inline constexpr PartName partOf<SceneField>{"SceneField", "a force of one law that acts on bodies from afar"};
template <>
inline constexpr PartName partOf<SceneMover>{"SceneMover", "what moves a kinematic body, in one of several ways"};
template <>
inline constexpr PartName partOf<Shape>{"Shape", "an outline of one kind"};
template <>
inline constexpr PartName partOf<BoxFields>{"Box", "kept as the polygon it is"};
template <>
inline constexpr PartName partOf<TilesFields>{"Tiles", "a map of tiles, in the letters of the standard legend"};
template <>
inline constexpr PartName partOf<plumb::Cell>{"Cell", "a place in a map of tiles"};
template <>
inline constexpr PartName partOf<PathMotion>{"PathMotion", "along straight lines through its points, or a spline"};
template <>
inline constexpr PartName partOf<SlidingMotion>{"SlidingMotion", "straight on at a speed, sliding along what it meets"};
template <>
inline constexpr PartName partOf<GridMotion>{"GridMotion", "from tile to tile of a map"};
template <>
inline constexpr PartName partOf<PlatformCue>{"PlatformCue", "what a player holds from a time on"};
template <>
inline constexpr PartName partOf<PlatformMotion>{"PlatformMotion", "runs and jumps as a profile has it"};
template <>
inline constexpr PartName partOf<SwingMotion>{"SwingMotion",
                                              "to and fro about where it starts: amplitude times sin(rate t)"};
template <>
inline constexpr PartName partOf<SteeredMotion>{"SteeredMotion", "as an agent that steers, by one of nine behaviours"};
template <>
inline constexpr PartName partOf<ClosedForm>{"ClosedForm", "what the textbook says the bodies do"};
template <>
inline constexpr PartName partOf<BodyMotion>{"BodyMotion", "how one body moves, by one kind of formula"};
template <>
inline constexpr PartName partOf<Flight>{"Flight", "x = x0 + v0 s + a s^2 / 2 with s = t - start; the angle likewise"};
template <>
inline constexpr PartName partOf<PiecewiseMotion>{"PiecewiseMotion", "flights joined at impacts"};
template <>
inline constexpr PartName partOf<DampedFlight>{"DampedFlight",
                                               "dv/dt = g - k v: x = x0 + (v0 - g/k) (1 - e^(-k t)) / k + g t / k"};
template <>
inline constexpr PartName partOf<PendulumMotion>{
    "PendulumMotion", "released at rest: theta'' = -(g / L) sin theta, theta from straight down"};
template <>
inline constexpr PartName partOf<OscillatorMotion>{"OscillatorMotion", "m x'' = -k x - c x', along a line"};
template <>
inline constexpr PartName partOf<DragFall>{"DragFall", "x = x0 - (v_t^2 / g) ln cosh(g t / v_t)"};
template <>
inline constexpr PartName partOf<KeplerMotion>{"KeplerMotion", "an ellipse about a focus"};
template <>
inline constexpr PartName partOf<FreeMotion>{
    "FreeMotion", "as gravity, the air, what it meets and other free bodies let it; its numbers are the scene's"};
template <>
inline constexpr PartName partOf<SwingsMotion>{"SwingsMotion",
                                               "on a hinge or rods, released at rest; its numbers are the scene's"};
template <>
inline constexpr PartName partOf<SpringsMotion>{"SpringsMotion",
                                                "on a spring and damper, along their line, with the scene's numbers"};
template <>
inline constexpr PartName partOf<FloatsMotion>{"FloatsMotion", "up and down in water, with the scene's numbers"};
template <>
inline constexpr PartName partOf<OrbitsMotion>{"OrbitsMotion", "about another that draws it, with the scene's numbers"};
template <>
inline constexpr PartName partOf<HoistedMotion>{"HoistedMotion", "on a rope over two wheels, with the scene's numbers"};
template <>
inline constexpr PartName partOf<GearedMotion>{"GearedMotion",
                                               "driven by a motor through gears, with the scene's numbers"};
template <>
inline constexpr PartName partOf<CaughtMotion>{
    "CaughtMotion", "a bullet that stays in a block on rods, or that block, with the scene's numbers"};
template <>
inline constexpr PartName partOf<RestsMotion>{"RestsMotion", "it stays where it starts: joints hold it in balance"};
template <>
inline constexpr PartName partOf<Probe>{
    "Probe", "one quantity watched; its metric, probe.<name>, is the largest distance from expected"};
template <>
inline constexpr PartName partOf<AngleProbe>{"AngleProbe", "the body's angle [rad]"};
template <>
inline constexpr PartName partOf<NormalForceProbe>{"NormalForceProbe", "how hard two bodies press on each other [N]"};
template <>
inline constexpr PartName partOf<JointForceProbe>{"JointForceProbe", "the size of the force in a joint [N]"};
template <>
inline constexpr PartName partOf<PositionProbe>{"PositionProbe",
                                                "how far the body's origin lies along a direction [m]"};
template <>
inline constexpr PartName partOf<VelocityProbe>{"VelocityProbe",
                                                "how fast the centre of mass moves along a direction [m/s]"};
template <>
inline constexpr PartName partOf<LimitProbe>{"LimitProbe", "by how much a joint is beyond its limit [rad or m]"};
template <>
inline constexpr PartName partOf<JointBrokenProbe>{"JointBrokenProbe", "1 once the joint has broken, 0 before"};
template <>
inline constexpr PartName partOf<SensorCountProbe>{"SensorCountProbe", "how often something has come into a sensor"};
template <>
inline constexpr PartName partOf<SnagsProbe>{"SnagsProbe",
                                             "in how many steps the body has lost speed along a direction"};
template <>
inline constexpr PartName partOf<ApartProbe>{"ApartProbe",
                                             "by how much one body is beyond another along a direction [m]"};
template <>
inline constexpr PartName partOf<SceneControl>{"SceneControl", "a number that a page offers to a person to change"};
template <>
inline constexpr PartName partOf<Check>{"Check", "one thing that must hold"};
template <>
inline constexpr PartName partOf<ExactCheck>{
    "ExactCheck", "Plumb stays within limit of the closed form, and no farther off than the best of its peers or 1 mm"};
template <>
inline constexpr PartName partOf<AgreeCheck>{"AgreeCheck", "Plumb and each of its peers stay together until a time"};
template <>
inline constexpr PartName partOf<InvariantCheck>{"InvariantCheck", "a metric of an engine's run stays within a bound"};
template <>
inline constexpr PartName partOf<OrderCheck>{"OrderCheck", "the error falls as dt^order: seen at dt, dt/2 and dt/4"};

}  // namespace plumb::compare
