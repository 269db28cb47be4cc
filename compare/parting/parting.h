// SPDX-License-Identifier: MIT
// Where do two engines part, and over what?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// What differed most between two engines before they parted.
enum class Difference {
    None,      ///< nothing that was looked at
    Break,     ///< a joint has broken: 1, or 0 [-]
    Gap,       ///< how far a joint is from what it holds [m]
    Overlap,   ///< how deep two bodies are in each other, negative for a gap between them [m]
    Passed,    ///< one body went through another: 1, or 0 [-]
    Bounce,    ///< the coefficient of restitution that a hit shows [-]
    Hit,       ///< the speed after a hit [m/s]
    Snag,      ///< the speed lost at once, in one of them only [m/s]
    Sliding,   ///< the speed gained or lost along a surface [m/s]
    Pressing,  ///< the speed gained or lost where bodies press on each other [m/s]
    Pull,      ///< the speed gained or lost where joints hold the body [m/s]
    Flight,    ///< the speed of what nothing touches [m/s]
    Steps,     ///< where a step puts a body, beside its velocity: how far off the other's path it is by then [m]
    Driven,    ///< the speed of what a mover moves [m/s]
    Energy,    ///< gained since the start, where a law keeps it, relative to the largest of the run [-]
};

/// Its name in files: "gap", "overlap", "bounce".
std::string differenceName(Difference difference);

/// Two engines of which each ran the scene.
struct Parting {
    std::string engineA{}, engineB{};
    std::string body{};             ///< the first that is off its path in the other engine; empty: none is
    double limit = 0;               ///< by more than this: see partingsOf [m]
    double time = 0;                ///< when [s]
    double apart = 0;               ///< at the end, of this body; where none parts, the largest of all bodies [m]
    Difference quantity{};          ///< what differed most by then
    std::string at{};               ///< the joint, or the two bodies: "ball, floor"; or the body alone
    double valueA = 0, valueB = 0;  ///< of the quantity, in each engine
    double when = 0;                ///< when the two values were seen [s]
};

/// Of each pair of runs that have states, in their order. Bodies that do not move are left out; of the closed form,
/// those are that it does not speak of.
/// A body is off its path when it is more than 1 cm from where the other engine has it within a step before and after:
/// who is only late by a step is on the path. Where all that differs is that an engine keeps what touches apart, by up
/// to 2.5 cm, it is no parting yet: the limit is 4 cm then, and 16 cm if it is so at these too.
std::vector<Parting> partingsOf(const Scene& scene, std::span<const Observation* const> runs);

/// "a and b: plank_3 parts at 0.82 s, by more than 10 mm, and is 2 m off at the end: in b the hinge link_4 has opened
/// by 65 mm, in a by 12 um."
std::string partingText(const Scene& scene, const Parting& parting);

}  // namespace plumb::compare
