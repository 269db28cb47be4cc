// SPDX-License-Identifier: MIT
// Which fields do probes and checks have in a file, and which values may they have?
#pragma once
#include <compare/scene/fields/field.h>
#include <compare/scene/fields/tags.h>

namespace plumb::compare {

/// Fields that several probes have.
struct Watched {
    static constexpr Field body = needed({"body", "", Allowed::any, "the name of a body"});
    static constexpr Field bodyA = needed({"bodyA", "", Allowed::any, "the name of a body"});
    static constexpr Field bodyB = needed({"bodyB", "", Allowed::any, "the name of another body"});
    static constexpr Field joint = needed({"joint", "", Allowed::any, "the name of a joint"});
    static constexpr Field direction{"direction", "-", Allowed::finite.butNotZero("has no direction"), "a unit vector"};
};

void fields(auto& visit, OrConst<AngleProbe> auto& x) {
    visit(Watched::body, x.body);
}
void fields(auto& visit, OrConst<NormalForceProbe> auto& x) {
    visit(Watched::bodyA, x.bodyA);
    visit(Watched::bodyB, x.bodyB);
}
void fields(auto& visit, OrConst<JointForceProbe> auto& x) {
    visit(Watched::joint, x.joint);
}
void fields(auto& visit, OrConst<PositionProbe> auto& x) {
    visit(Watched::body, x.body);
    visit(Watched::direction, x.direction);
}
void fields(auto& visit, OrConst<VelocityProbe> auto& x) {
    visit(Watched::body, x.body);
    visit(Watched::direction, x.direction);
}
void fields(auto& visit, OrConst<LimitProbe> auto& x) {
    visit(Watched::joint, x.joint);
}
void fields(auto& visit, OrConst<JointBrokenProbe> auto& x) {
    visit(Watched::joint, x.joint);
}
void fields(auto& visit, OrConst<SensorCountProbe> auto& x) {
    visit(Watched::body, x.body);
}
void fields(auto& visit, OrConst<SnagsProbe> auto& x) {
    visit(Watched::body, x.body);
    visit(Watched::direction, x.direction);
    visit({"drop", "m/s", Allowed::positive, "of its speed that it must lose in a step to count"}, x.drop);
}
void fields(auto& visit, OrConst<ApartProbe> auto& x) {
    visit(Watched::bodyA, x.bodyA);
    visit(Watched::bodyB, x.bodyB);
    visit(Watched::direction, x.direction);
}
void fields(auto& visit, OrConst<Probe> auto& x) {
    visit(needed({"name", "", Allowed::any, "its metric is probe.<name>"}), x.name);
    visit.oneOf(x.quantity, probeTags);
    visit({"expected", "the unit", Allowed::finite, "of no account where the closed form gives every angle"},
          x.expected);
    visit({"from", "s", Allowed::notNegative, "watched from this time on: before it the scene settles"}, x.from);
    visit({"until", "s", Allowed::notNegative, "watched until this time; 0: to the end"}, x.until);
    visit({"watch", "", Allowed::any, "which values are held against what is expected"}, x.watch);
    visit({"unit", "", Allowed::any, "of the quantity, as it is printed"}, x.unit);
}

/// Fields that several checks have.
struct Judged {
    static constexpr Field engines{"engines", "", Allowed::any,
                                   "the names of the engines that it is for; none: the engine under test"};
    static constexpr Field reason{"reason", "", Allowed::any, "why this bound"};
};

void fields(auto& visit, OrConst<ExactCheck> auto& x) {
    visit({"limit", "m", Allowed::notNegative, "on error_max"}, x.limit);
    visit(Judged::reason, x.reason);
}
void fields(auto& visit, OrConst<AgreeCheck> auto& x) {
    visit({"tolerance", "m", Allowed::positive, "on the largest distance between the same body in both"}, x.tolerance);
    visit({"until", "s", Allowed::positive, "before chaos or modelling differences take over"}, x.until);
    visit(Judged::reason, x.reason);
}
void fields(auto& visit, OrConst<InvariantCheck> auto& x) {
    visit(needed({"metric", "", Allowed::any, "a metric's name: \"energy_drift\", \"probe.normal_1\""}), x.metric);
    visit({"limit", "the metric's unit", Allowed::notNegative, "the metric is at most this"}, x.limit);
    visit(Judged::engines, x.engines);
    visit(Judged::reason, x.reason);
}
void fields(auto& visit, OrConst<OrderCheck> auto& x) {
    visit({"order", "-", Allowed::positive, "the observed order, log2 of the ratio of errors, is at least this"},
          x.order);
    visit(Judged::engines, x.engines);
    visit(Judged::reason, x.reason);
}
void fields(auto& visit, OrConst<Check> auto& x) {
    visit.oneOf(x, checkTags);
}

}  // namespace plumb::compare
