// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include <compare/engine/engine.h>
#include <compare/metric/length_text.h>
#include <compare/parting/parting.h>

namespace plumb::compare {
namespace {

constexpr const char* differenceNames[] = {"none",   "break", "gap",    "overlap", "passed",   "bounce",
                                           "moment", "hit",   "snag",   "sliding", "pressing", "pull",
                                           "flight", "steps", "driven", "energy",  "track"};
constexpr const char* agentNames[] = {"across", "along", "joints", "nothing", "steps"};
constexpr double mostShare = 1.25;       // of the distance: with larger parts, no parts are told [-]
constexpr std::size_t mostTold = 3;      // so many parts are told
constexpr double leastShareTold = 0.05;  // smaller parts are not told [-]
constexpr double lateTimes = 2;          // late is told if it is so many times the distance off the path [-]
constexpr double leastLate = 1e-4;       // [m]
// The names of joints in a sentence, in the order of JointDef.
constexpr const char* jointNames[] = {"hinge",  "slide", "rod",   "weld",   "wheel",
                                      "pulley", "gear",  "motor", "target", "filter"};

std::string jointText(const Scene& scene, const std::string& name) {
    const auto joint = std::ranges::find(scene.joints, name, &SceneJoint::name);
    if (joint == scene.joints.end()) return name;
    const auto* rod = std::get_if<DistanceJointDef>(&joint->def);
    const char* kind = rod && rod->spring ? "spring" : jointNames[joint->def.index()];
    return fmt::format("{} {}", kind, name);
}

/// The two sides of a sentence, with the larger value first.
struct Sides {
    std::string engine, other;
    double value = 0, otherValue = 0;
};

Sides sidesOf(const Parting& parting) {
    if (std::abs(parting.valueB) > std::abs(parting.valueA))
        return {parting.engineB, parting.engineA, parting.valueB, parting.valueA};
    return {parting.engineA, parting.engineB, parting.valueA, parting.valueB};
}

std::string depthText(double depth) {
    return depth >= 0 ? "overlap by " + lengthText(depth) : "are " + lengthText(-depth) + " apart";
}

std::string gainText(double gain) {
    return fmt::format("{} by {:.2g} %", gain >= 0 ? "grown" : "fallen", 100 * std::abs(gain));
}

/// The share of the speed after a bounce; 0 % if the body goes on in its direction.
std::string shareText(double share) {
    return fmt::format("{:.0f} %", share > 0 ? 100 * share : 0.0);
}

/// "ball" and "floor" from "ball, floor".
std::pair<std::string, std::string> bothOf(const std::string& at) {
    const std::size_t comma = at.find(", ");
    return {at.substr(0, comma), comma == std::string::npos ? "" : at.substr(comma + 2)};
}

/// "at 3 m/s in a, at 2 m/s in b", in the order of the pair; or one speed, if both are printed alike.
std::string speedsText(const Parting& parting) {
    const std::string a = fmt::format("{:.4g} m/s", parting.valueA), b = fmt::format("{:.4g} m/s", parting.valueB);
    if (a == b) return fmt::format("at {} in both by then", a);
    return fmt::format("at {} in {}, at {} in {}", a, parting.engineA, b, parting.engineB);
}

std::string lossText(double speed) {
    return speed > 0 ? fmt::format("{:.3g} m/s", speed) : "nothing";
}

std::string touchText(const Parting& parting) {
    const auto [body, other] = bothOf(parting.at);
    const Sides sides = sidesOf(parting);
    const std::string when = fmt::format("{:.4g} s", parting.when);
    switch (parting.quantity) {
        case Difference::Passed:
            return fmt::format("at {} {} goes through {} in {}, and not in {}", when,
                               body == parting.body ? "it" : body, other, sides.engine, sides.other);
        case Difference::Bounce:
            return fmt::format("it meets {} at {}, and bounces back at {} of its speed in {}, at {} in {}", other, when,
                               shareText(parting.valueA), parting.engineA, shareText(parting.valueB), parting.engineB);
        case Difference::Hit:
            return fmt::format("after it meets {} at {} it moves {}", other, when, speedsText(parting));
        case Difference::Moment:
            return fmt::format("it meets {} at {}, up to a step sooner in one of the two, and then moves {}", other,
                               when, speedsText(parting));
        case Difference::Snag:
            return fmt::format("on {} it loses {} at once at {} in {}, {} in {}", other, lossText(sides.value), when,
                               sides.engine, lossText(sides.otherValue), sides.other);
        case Difference::Sliding: return fmt::format("it moves along {} {}", other, speedsText(parting));
        default:
            return fmt::format("no cause was found; while it presses on {}, it comes to move {}", other,
                               speedsText(parting));
    }
}

/// A reminder, if an engine's chains let through what comes from their left.
std::string chainText(const Scene& scene, const Parting& parting) {
    const std::string body = bothOf(parting.at).second, engine = sidesOf(parting).engine;
    const Engine* known = findKnown(engine);
    const auto other = std::ranges::find(scene.bodies, body, &SceneBody::name);
    if (!known || !known->oneSidedChains || other == scene.bodies.end()) return "";
    const auto isChain = [](const ShapeDef& shape) { return std::holds_alternative<Chain>(shape.shape); };
    if (std::ranges::none_of(other->def.shapes, isChain)) return "";
    return fmt::format(" (in {} a chain is solid only on the right of its direction)", engine);
}

/// A reminder, if an engine keeps apart what touches.
std::string skinText(const Parting& parting) {
    const auto [least, engine] =
        std::min(std::pair(parting.valueA, parting.engineA), std::pair(parting.valueB, parting.engineB));
    return isSkin(parting) ? fmt::format(" (what touches is kept {} apart in {})", lengthText(-least), engine) : "";
}

std::string agentText(const Portion& portion) {
    switch (portion.agent) {
        case Agent::Across: return "the push of " + portion.other;
        case Agent::Along: return "friction on " + portion.other;
        case Agent::Joints: return "its joints";
        case Agent::Nothing: return "its flight";
        case Agent::Steps: break;
    }
    return "the order of the integration";
}

/// ": 93 % by the order of the integration, 7 % by the push of floor". Empty if parts are larger than the whole: then
/// they say little.
std::string portionsText(const std::vector<Portion>& portions) {
    std::vector<std::string> parts;
    for (const Portion& portion : portions) {
        if (std::abs(portion.share) > mostShare) return "";
        if (parts.size() == mostTold) break;
        if (std::abs(portion.share) < leastShareTold) continue;
        parts.push_back(fmt::format("{:.0f} % by {}", 100 * portion.share, agentText(portion)));
    }
    return parts.empty() ? "" : fmt::format(": {}", fmt::join(parts, ", "));
}

std::string togetherText(const Parting& parting) {
    const Late& late = parting.late;
    const std::string beside = fmt::format("no body is farther than {} off its path", lengthText(parting.apart));
    if (late.distance < lateTimes * parting.apart || late.distance < leastLate) return beside;
    return fmt::format("in {} {} is late by at most one step ({}), and {}", late.engine, late.body,
                       lengthText(late.distance), beside);
}

std::string causeText(const Scene& scene, const Parting& parting) {
    const Sides sides = sidesOf(parting);
    switch (parting.quantity) {
        case Difference::None: return "nothing that was looked at differs";
        case Difference::Break:
            return fmt::format("in {} the {} has broken, in {} it holds", sides.engine, jointText(scene, parting.at),
                               sides.other);
        case Difference::Gap:
            return fmt::format("in {} the {} has opened by {}, in {} by {}", sides.engine, jointText(scene, parting.at),
                               lengthText(sides.value), sides.other, lengthText(sides.otherValue));
        case Difference::Overlap: {
            const auto [a, b] = bothOf(parting.at);
            return fmt::format("in {} {} and {} {}, in {} they {}{}", sides.engine, a, b, depthText(sides.value),
                               sides.other, depthText(sides.otherValue), skinText(parting));
        }
        case Difference::Pull:
            return fmt::format("no cause was found; while the {} holds it, it comes to move {}",
                               jointText(scene, parting.at), speedsText(parting));
        case Difference::Flight: return "nothing touches it, and it moves " + speedsText(parting);
        case Difference::Steps:
            return fmt::format("by the order of the integration the steps of the two place it {} apart",
                               lengthText(parting.valueA));
        case Difference::Driven: return "it is moved from outside, " + speedsText(parting);
        case Difference::Energy:
            return fmt::format("energy, which nothing takes here, has {} in {}, {} in {}", gainText(sides.value),
                               sides.engine, gainText(sides.otherValue), sides.other);
        case Difference::Track: return "it moves " + speedsText(parting) + ", and a track tells no cause";
        case Difference::Passed: return touchText(parting) + chainText(scene, parting);
        default: return touchText(parting);
    }
}

}  // namespace

std::string differenceName(Difference difference) {
    return differenceNames[static_cast<std::size_t>(difference)];
}

std::string agentName(Agent agent) {
    return agentNames[static_cast<std::size_t>(agent)];
}

std::string partingText(const Scene& scene, const Parting& parting) {
    const std::string both = fmt::format("{} and {}", parting.engineA, parting.engineB);
    if (parting.body.empty()) return fmt::format("{} stay together: {}.", both, togetherText(parting));
    return fmt::format("{}: {} parts at {:.3g} s, by more than {}: {}. At the end it is {} off{}.", both, parting.body,
                       parting.time, lengthText(parting.limit), causeText(scene, parting), lengthText(parting.apart),
                       portionsText(parting.portions));
}

}  // namespace plumb::compare
