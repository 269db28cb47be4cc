// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <compare/engine/engine.h>
#include <compare/metric/length_text.h>
#include <compare/parting/parting.h>

namespace plumb::compare {
namespace {

constexpr const char* differenceNames[] = {"none",   "break",  "gap",   "overlap", "passed",
                                           "bounce", "hit",    "snag",  "sliding", "pressing",
                                           "pull",   "flight", "steps", "driven",  "energy"};
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
            return fmt::format("at {} it goes through {} in {}, and not in {}", when, other, sides.engine, sides.other);
        case Difference::Bounce:
            return fmt::format("it meets {} at {}, and bounces back at {} of its speed in {}, at {} in {}", other, when,
                               shareText(parting.valueA), parting.engineA, shareText(parting.valueB), parting.engineB);
        case Difference::Hit:
            return fmt::format("after it meets {} at {} it moves {}", other, when, speedsText(parting));
        case Difference::Snag:
            return fmt::format("on {} it loses {} at once at {} in {}, {} in {}", other, lossText(sides.value), when,
                               sides.engine, lossText(sides.otherValue), sides.other);
        case Difference::Sliding: return fmt::format("it moves along {} {}", other, speedsText(parting));
        default: return fmt::format("where it presses on {} it moves {}", other, speedsText(parting));
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
            return fmt::format("in {} {} and {} {}, in {} they {}", sides.engine, a, b, depthText(sides.value),
                               sides.other, depthText(sides.otherValue));
        }
        case Difference::Pull:
            return fmt::format("the {} holds it, and it moves {}", jointText(scene, parting.at), speedsText(parting));
        case Difference::Flight: return "nothing touches it, and it moves " + speedsText(parting);
        case Difference::Steps:
            return fmt::format("nothing touches it, and its speed is alike: the steps of the two place it {} apart",
                               lengthText(parting.valueA));
        case Difference::Driven: return "it is moved from outside, " + speedsText(parting);
        case Difference::Energy:
            return fmt::format("energy, which nothing takes here, has {} in {}, {} in {}", gainText(sides.value),
                               sides.engine, gainText(sides.otherValue), sides.other);
        case Difference::Passed: return touchText(parting) + chainText(scene, parting);
        default: return touchText(parting);
    }
}

}  // namespace

std::string differenceName(Difference difference) {
    return differenceNames[static_cast<std::size_t>(difference)];
}

std::string partingText(const Scene& scene, const Parting& parting) {
    if (parting.body.empty())
        return fmt::format("{} and {} stay together: no body is farther than {} off its path.", parting.engineA,
                           parting.engineB, lengthText(parting.apart));
    return fmt::format("{} and {}: {} parts at {:.3g} s, by more than {}, and is {} off at the end: {}.",
                       parting.engineA, parting.engineB, parting.body, parting.time, lengthText(parting.limit),
                       lengthText(parting.apart), causeText(scene, parting));
}

}  // namespace plumb::compare
