// SPDX-License-Identifier: MIT
// What are the alternatives of a scene's parts, and its enumerators in their order, called in a file?
#pragma once
#include <array>
#include <span>

#include <compare/scene/scene.h>

namespace plumb::compare {

inline constexpr std::array<const char*, 3> sideTags{"both", "left", "right"};
inline constexpr std::array<const char*, 3> watchTags{"every", "largest", "last"};
inline constexpr std::array<const char*, 10> shownAsTags{"number", "downwards", "perSecond", "x",       "y",
                                                         "size",   "direction", "hanging",   "degrees", "degreesDown"};
inline constexpr std::array<const char*, 4> directionTags{"up", "left", "down", "right"};
inline constexpr std::array<const char*, 3> easingTags{"none", "acceleration", "smoothStep"};
inline constexpr std::array<const char*, 3> repeatTags{"once", "loop", "backAndForth"};
inline constexpr std::array<const char*, 2> styleTags{"modern", "1985"};
inline constexpr std::array<const char*, 2> standInTags{"kinematic", "stopped"};
inline constexpr std::array<const char*, 9> behaviourTags{"seek",   "flee",   "arrive", "pursue", "evade",
                                                          "wander", "follow", "avoid",  "flock"};
constexpr std::span<const char* const> tagsOf(Behaviour) {
    return behaviourTags;
}
constexpr std::span<const char* const> tagsOf(Direction) {
    return directionTags;
}
constexpr std::span<const char* const> tagsOf(Easing) {
    return easingTags;
}
constexpr std::span<const char* const> tagsOf(PathRepeat) {
    return repeatTags;
}
constexpr std::span<const char* const> tagsOf(PlatformStyle) {
    return styleTags;
}
constexpr std::span<const char* const> tagsOf(StandIn) {
    return standInTags;
}
constexpr std::span<const char* const> tagsOf(Side) {
    return sideTags;
}
constexpr std::span<const char* const> tagsOf(ShownAs) {
    return shownAsTags;
}
constexpr std::span<const char* const> tagsOf(Watch) {
    return watchTags;
}

inline constexpr std::array motionTags{"piecewise", "damped",  "pendulum", "oscillator", "dragFall",
                                       "kepler",    "free",    "swings",   "springs",    "floats",
                                       "orbits",    "hoisted", "geared",   "caught",     "rests"};
inline constexpr std::array moverTags{"path", "slide", "grid", "platform", "swing", "steer"};
inline constexpr std::array probeTags{"angle", "normalForce", "jointForce",  "position", "velocity",
                                      "limit", "jointBroken", "sensorCount", "snags",    "apart"};
inline constexpr std::array checkTags{"exact", "agree", "invariant", "order"};

// For numbers without bound, because JSON cannot write infinity.
inline constexpr const char* infiniteTag = "infinite";
inline constexpr const char* minusInfiniteTag = "-infinite";

}  // namespace plumb::compare
