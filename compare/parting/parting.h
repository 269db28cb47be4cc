// SPDX-License-Identifier: MIT
// Where do two engines part, and for what reason?
#pragma once
#include <span>
#include <string>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// What differed most between two engines before they parted.
enum class Difference {
    None,      ///< nothing that was checked
    Break,     ///< a joint has broken: 1, or 0 [-]
    Gap,       ///< the gap of a joint: how far apart the points are that it holds together [m]
    Overlap,   ///< how deep two bodies overlap; negative for a gap between them [m]
    Passed,    ///< one body went through another: 1, or 0 [-]
    Bounce,    ///< the coefficient of restitution seen in a hit [-]
    Moment,    ///< the same bounce, up to a step sooner in one run: the speed after it [m/s]
    Hit,       ///< the speed after a hit [m/s]
    Snag,      ///< the speed lost at once, in one run only [m/s]
    Sliding,   ///< the speed along a surface, relative to the other body; positive in the faster one's direction [m/s]
    Pressing,  ///< the speed of a body that presses on another, and no cause was found [m/s]
    Pull,      ///< the speed gained or lost when joints hold the body, and no cause was found [m/s]
    Flight,    ///< the speed of a body that nothing touches [m/s]
    Steps,     ///< how far steps have moved the body in addition to its velocity: the order of the integration [m]
    Driven,    ///< the speed of a body that a mover moves [m/s]
    Energy,    ///< gained since the start although a law keeps it, relative to the largest of the run [-]
    Track,     ///< the speed of a body in two runs, of which one is the user's track: that tells no cause [m/s]
};

/// Its name in files: "gap", "overlap", "bounce".
std::string differenceName(Difference difference);

/// What moves a body, in a step?
enum class Agent {
    Across,   ///< a contact, along its normal
    Along,    ///< a contact, along the surface
    Joints,   ///< the joints that hold the body
    Nothing,  ///< no contact and no joint: gravity, damping, fields
    Steps,    ///< no change of velocity: the step moves the body in addition to its velocity
};

/// Its name in files: "across", "along", "joints", "nothing", "steps".
std::string agentName(Agent agent);

/// A part of the distance at the end.
struct Portion {
    Agent agent{};
    std::string other{};  ///< the body of the contact; else empty
    double share = 0;     ///< of the distance; negative if it brings the body nearer [-]
};

/// A body that is on the other's path, but not at the same time.
struct Late {
    std::string engine{}, body{};  ///< where it is late
    double distance = 0;           ///< the largest distance to the place that it has in the other engine then [m]
};

/// How two engines that both ran the scene part.
struct Parting {
    std::string engineA{}, engineB{};
    std::string body{};             ///< the first body that leaves its path in the other engine; empty: none does
    double limit = 0;               ///< the distance from the path that counts as parting: see partingsOf [m]
    double time = 0;                ///< when it leaves the path [s]
    double apart = 0;               ///< distance at the end, of this body; if none parts, the largest of all bodies [m]
    Difference quantity{};          ///< what differed most until then
    std::string at{};               ///< the joint, or the two bodies: "ball, floor"; or only the body
    double valueA = 0, valueB = 0;  ///< values of the quantity in each engine
    double when = 0;                ///< when the two values were seen [s]
    /// What the distance at the end is made of, the largest part first: see addPortions. Empty if no body parts, or it
    /// was lost.
    std::vector<Portion> portions{};
    Late late{};  ///< if no body parts: who is late most
};

/// True if what differed is that one engine keeps touching bodies apart.
bool isSkin(const Parting& parting);

/// One or two partings for each pair of runs that have states, in their order. Bodies that do not move are left out; so
/// are bodies that the closed form does not describe, in pairs with it. A body is off its path if it is more than 1 cm
/// from where the other engine has it within a step before and after: a body that is only late by a step is still on
/// the path. If the only difference is that an engine keeps touching bodies apart, by up to 2.5 cm, this is not yet a
/// parting: then the limit is 4 cm, and 16 cm if the same is true at 4 cm. If a body is much farther away at the end, a
/// second parting says why the farthest one is off its path by a tenth of that distance, unless the reason is the same.
std::vector<Parting> partingsOf(const Scene& scene, std::span<const Observation* const> runs);

/// Fills in what the distances at the end are made of: it looks at every step of every run. runs: those of partingsOf.
void addPortions(const Scene& scene, std::span<const Observation* const> runs, std::vector<Parting>& partings);

/// "a and b: plank_3 parts at 0.82 s, by more than 10 mm: in b the hinge link_4 has opened by 65 mm, in a by 12 µm. At
/// the end it is 2 m off: 80 % by its joints, 20 % by the order of the integration."
std::string partingText(const Scene& scene, const Parting& parting);

}  // namespace plumb::compare
