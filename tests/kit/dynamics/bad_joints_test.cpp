// SPDX-License-Identifier: MIT
#include "catch.h"
#include "kit/dynamics/bad_input.h"

namespace plumb::test {

namespace {

const BadNumbers beyondReach{{1e16, "1e+16", "is beyond 1e+15, where no body can be, nor move so fast"}};
const BadNumbers notThere = joined(joined(notFinite, beyondReach), {{-1e300, "-1e+300", beyondReach[0].complaint}});

const Fields<Spring> springFields{
    number("stiffness", &Spring::stiffness, negative),
    number("damping", &Spring::damping, negative),
};
const Fields<Limit> limitFields{
    with(number("lower", &Limit::lower, notANumber), {{[](Limit& l) {
                                                           l = {2, 1};
                                                       },
                                                       "", "2 is more than limit.upper 1"},
                                                      {[](Limit& l) {
                                                           l = {infinity, infinity};
                                                       },
                                                       "", "inf is not finite"}}),
    with(number("upper", &Limit::upper, notANumber), {{[](Limit& l) {
                                                           l = {-infinity, -infinity};
                                                       },
                                                       "", "-inf is not finite"}}),
};
const Fields<Breaking> breakingFields{
    number("force", &Breaking::force, notPositiveBound),
    number("torque", &Breaking::torque, notPositiveBound),
};

/// The bodies and joints that every bench has, as it gives them the same ids each time but for the world's.
const BodyId never{};

template <class Id>
Id idOf(std::uint32_t index) {
    return {index, 0, 0};
}

/// Ids are of a bench, which is not there yet when a def is spoiled: marked by an index, they are put in when it is.
enum Mark : std::uint32_t { Gone = 1000, Foreign, Floor, Wall, Ball, Hinge, Slide, Rod, GoneJoint, ForeignJoint };

void resolve(const Bench& bench, BodyId& id) {
    if (id.world != 0) return;
    switch (id.index) {
        case Gone: id = bench.gone; break;
        case Foreign: id = bench.foreign; break;
        case Floor: id = bench.floor; break;
        case Wall: id = bench.wall; break;
        case Ball: id = bench.ball; break;
        default: break;
    }
}
void resolve(const Bench& bench, JointId& id) {
    if (id.world != 0) return;
    switch (id.index) {
        case GoneJoint: id = bench.goneJoint; break;
        case ForeignJoint: id = bench.foreignJoint; break;
        case Hinge: id = bench.hinge; break;
        case Slide: id = bench.slide; break;
        case Rod: id = bench.rod; break;
        default: break;
    }
}

template <class Def>
Def resolved(const Bench& bench, Def def) {
    if constexpr (requires { def.bodyA; }) resolve(bench, def.bodyA), resolve(bench, def.bodyB);
    if constexpr (requires { def.body; }) resolve(bench, def.body);
    if constexpr (requires { def.jointA; }) resolve(bench, def.jointA), resolve(bench, def.jointB);
    return def;
}

template <class Def>
Field<Def> body(const std::string& name, BodyId Def::*at) {
    return {name,
            {{[at](Def& d) { d.*at = never; }, "", "{index 0, generation 0, world 0} names no body: it was never set"},
             {[at](Def& d) { d.*at = idOf<BodyId>(Gone); }, "", "names no body of this world any more: it was removed"},
             {[at](Def& d) { d.*at = idOf<BodyId>(Foreign); }, "", "belongs to another world"}}};
}
template <class Def>
Field<Def> bodyA() {
    return body<Def>("bodyA", &Def::bodyA);
}
template <class Def>
Field<Def> bodyB(bool oneMoves = true) {
    const Field<Def> field =
        with(body<Def>("bodyB", &Def::bodyB),
             {{[](Def& d) { d.bodyB = d.bodyA; }, "", "is the same body as bodyA, two were wanted"}});
    if (!oneMoves) return field;
    return with(field, {{[](Def& d) { d.bodyA = idOf<BodyId>(Floor), d.bodyB = idOf<BodyId>(Wall); }, "",
                         "is not dynamic, nor is bodyA"}});
}

template <class Def>
Field<Def> anchor(const std::string& name, Vec2 Def::*at) {
    return with(number(name, at, notFinite), {{[at](Def& d) {
                                                   d.*at = {3e5, 0};
                                               },
                                               "", "(300000, 0) is more than 100000 m from the body it is on"}});
}
template <class Def>
Field<Def> axis() {
    return with(number("axis", &Def::axis, notFinite), {{[](Def& d) {
                                                             d.axis = {0, 0};
                                                         },
                                                         "", "(0, 0) has no direction"}});
}
template <class Def>
Field<Def> limit() {
    return nested("limit", &Def::limit, limitFields);
}
template <class Def>
Field<Def> spring() {
    return nested("spring", &Def::spring, springFields);
}
template <class Def>
Field<Def> breaking() {
    return nested("breaking", &Def::breaking, breakingFields);
}

using Hinged = RevoluteJointDef;
const Fields<Hinged> revoluteFields{
    bodyA<Hinged>(),
    bodyB<Hinged>(),
    anchor("anchor", &Hinged::anchor),
    number("motorSpeed", &Hinged::motorSpeed, notThere),
    number("maxMotorTorque", &Hinged::maxMotorTorque, negativeBound),
    limit<Hinged>(),
    spring<Hinged>(),
    number("restAngle", &Hinged::restAngle, notThere),
    anything<Hinged>("collideConnected"),
    breaking<Hinged>(),
};

using Sliding = PrismaticJointDef;
const Fields<Sliding> prismaticFields{
    bodyA<Sliding>(),
    bodyB<Sliding>(),
    anchor("anchor", &Sliding::anchor),
    axis<Sliding>(),
    number("motorSpeed", &Sliding::motorSpeed, notThere),
    number("maxMotorForce", &Sliding::maxMotorForce, negativeBound),
    limit<Sliding>(),
    spring<Sliding>(),
    number("restShift", &Sliding::restShift, notThere),
    anything<Sliding>("collideConnected"),
    breaking<Sliding>(),
};

const Fields<DistanceJointDef> distanceFields{
    bodyA<DistanceJointDef>(),
    bodyB<DistanceJointDef>(),
    anchor("anchorA", &DistanceJointDef::anchorA),
    with(anchor("anchorB", &DistanceJointDef::anchorB),
         {{[](DistanceJointDef& d) { d.anchorB = d.anchorA; }, "", "(0, 4) is anchorA too"}}),
    number("length", &DistanceJointDef::length, joined(notPositive, beyondReach)),
    spring<DistanceJointDef>(),
    number("minLength", &DistanceJointDef::minLength, negative),
    with(number("maxLength", &DistanceJointDef::maxLength, negativeBound),
         {{[](DistanceJointDef& d) { d.minLength = 2, d.maxLength = 1; }, "", "1 is less than minLength 2"}}),
    number("motorSpeed", &DistanceJointDef::motorSpeed, notThere),
    number("maxMotorForce", &DistanceJointDef::maxMotorForce, negativeBound),
    anything<DistanceJointDef>("collideConnected"),
    breaking<DistanceJointDef>(),
};

using Weld = WeldJointDef;
const Fields<Weld> weldFields{
    bodyA<Weld>(),
    bodyB<Weld>(),
    anchor("anchor", &Weld::anchor),
    spring<Weld>(),
    nested("bending", &Weld::bending, springFields),
    anything<Weld>("collideConnected"),
    breaking<Weld>(),
};

using Wheel = WheelJointDef;
const Fields<Wheel> wheelFields{
    bodyA<Wheel>(),
    bodyB<Wheel>(),
    anchor("anchor", &Wheel::anchor),
    axis<Wheel>(),
    number("motorSpeed", &Wheel::motorSpeed, notThere),
    number("maxMotorTorque", &Wheel::maxMotorTorque, negativeBound),
    limit<Wheel>(),
    spring<Wheel>(),
    number("restShift", &Wheel::restShift, notThere),
    anything<Wheel>("collideConnected"),
    breaking<Wheel>(),
};

using Pulley = PulleyJointDef;
const Fields<Pulley> pulleyFields{
    bodyA<Pulley>(),
    bodyB<Pulley>(),
    with(number("groundA", &Pulley::groundA, notThere),
         {{[](Pulley& d) { d.groundA = d.anchorA; }, "", "(0, 4) is anchorA too"}}),
    with(number("groundB", &Pulley::groundB, notThere),
         {{[](Pulley& d) { d.groundB = d.anchorB; }, "", "(2, 4) is anchorB too"}}),
    anchor("anchorA", &Pulley::anchorA),
    anchor("anchorB", &Pulley::anchorB),
    number("ratio", &Pulley::ratio, joined(notPositive, beyondReach)),
    anything<Pulley>("collideConnected"),
    breaking<Pulley>(),
};

using Gear = GearJointDef;
Field<Gear> geared(const std::string& name, JointId Gear::*at) {
    return {name,
            {{[at](Gear& d) { d.*at = {}; }, "", "{index 0, generation 0, world 0} names no joint: it was never set"},
             {[at](Gear& d) { d.*at = idOf<JointId>(GoneJoint); }, "", "names no joint of this world any more"},
             {[at](Gear& d) { d.*at = idOf<JointId>(ForeignJoint); }, "", "belongs to another world"},
             {[at](Gear& d) { d.*at = idOf<JointId>(Mark::Rod); }, "", "is neither revolute nor prismatic"}}};
}
const Fields<Gear> gearFields{
    geared("jointA", &Gear::jointA),
    with(geared("jointB", &Gear::jointB),
         {{[](Gear& d) { d.jointB = d.jointA; }, "", "is the same joint as jointA, two were wanted"}}),
    with(number("ratio", &Gear::ratio, notThere), {{[](Gear& d) { d.ratio = 0; }, "", "0 would gear nothing"}}),
    breaking<Gear>(),
};

using Motor = MotorJointDef;
const Fields<Motor> motorFields{
    bodyA<Motor>(),
    bodyB<Motor>(),
    number("offset", &Motor::offset, notThere),
    number("angle", &Motor::angle, notThere),
    number("rate", &Motor::rate, joined(negative, beyondReach)),
    number("velocity", &Motor::velocity, notThere),
    number("angularVelocity", &Motor::angularVelocity, notThere),
    number("maxForce", &Motor::maxForce, negativeBound),
    number("maxTorque", &Motor::maxTorque, negativeBound),
    anything<Motor>("collideConnected"),
    breaking<Motor>(),
};

using Target = TargetJointDef;
const Fields<Target> targetFields{
    with(body("body", &Target::body), {{[](Target& d) { d.body = idOf<BodyId>(Floor); }, "", "is not dynamic"}}),
    anchor("anchor", &Target::anchor),
    number("target", &Target::target, notThere),
    spring<Target>(),
    number("maxForce", &Target::maxForce, negativeBound),
    breaking<Target>(),
};

const Fields<FilterJointDef> filterJointFields{bodyA<FilterJointDef>(), bodyB<FilterJointDef>(false)};

const BodyId wallId = idOf<BodyId>(Mark::Wall), ballId = idOf<BodyId>(Ball);

/// Calls visit(name, fields, sound) for each kind of joint, motors running, so that what they are told counts.
template <class Visit>
void forEachKind(Visit&& visit) {
    const Vec2 at{0, 4};
    const Spring soft{20, 1};
    visit("RevoluteJointDef", revoluteFields,
          Hinged{.bodyA = wallId, .bodyB = ballId, .anchor = at, .motorSpeed = 1, .maxMotorTorque = 1});
    visit("RevoluteJointDef", revoluteFields, Hinged{.bodyA = wallId, .bodyB = ballId, .anchor = at, .spring = soft});
    visit("PrismaticJointDef", prismaticFields,
          Sliding{.bodyA = wallId, .bodyB = ballId, .anchor = at, .motorSpeed = 1, .maxMotorForce = 1});
    visit("PrismaticJointDef", prismaticFields,
          Sliding{.bodyA = wallId, .bodyB = ballId, .anchor = at, .spring = soft});
    visit("DistanceJointDef", distanceFields,
          DistanceJointDef{.bodyA = wallId, .bodyB = ballId, .anchorA = at, .anchorB = {0.3, 4}});
    visit("WeldJointDef", weldFields, Weld{.bodyA = wallId, .bodyB = ballId, .anchor = at});
    visit("WheelJointDef", wheelFields,
          Wheel{.bodyA = wallId, .bodyB = ballId, .anchor = at, .spring = soft, .motorSpeed = 1, .maxMotorTorque = 1});
    visit(
        "PulleyJointDef", pulleyFields,
        Pulley{
            .bodyA = wallId, .bodyB = ballId, .groundA = {0, 7}, .groundB = {2, 7}, .anchorA = at, .anchorB = {2, 4}});
    visit("GearJointDef", gearFields, Gear{.jointA = idOf<JointId>(Hinge), .jointB = idOf<JointId>(Slide)});
    visit("MotorJointDef", motorFields, Motor{.bodyA = wallId, .bodyB = ballId, .maxForce = 10, .maxTorque = 10});
    visit("TargetJointDef", targetFields, Target{.body = ballId, .anchor = at, .target = {1, 5}});
    visit("FilterJointDef", filterJointFields, FilterJointDef{wallId, ballId});
}

/// Those of a distance joint that only a spring makes use of.
const DistanceJointDef springy{.bodyA = wallId,
                               .bodyB = ballId,
                               .anchorA = {0, 4},
                               .anchorB = {0.3, 4},
                               .spring = Spring{20, 1},
                               .maxMotorForce = 1};

const auto joinOnBench = [](Bench& bench, const auto& def) { bench.world.join(resolved(bench, def)); };

/// Fields that only a joint that is not made yet can have wrong.
bool isFrame(const std::string& field) {
    return field.starts_with("body") || field.starts_with("joint") || field.starts_with("anchor") ||
           field.starts_with("ground") || field == "axis";
}

}  // namespace

Covered coveredJoints() {
    Covered covered;
    cover(covered, "Spring", springFields);
    cover(covered, "Limit", limitFields);
    cover(covered, "Breaking", breakingFields);
    forEachKind([&](const std::string& name, const auto& fields, const auto&) {
        covered[name].clear();
        cover(covered, name, fields);
    });
    return covered;
}

TEST_CASE("each field of each kind of joint is refused by name, value and wish when it is wrong",
          "[dynamics][joints][errors]") {
    forEachKind([](const std::string& name, const auto& fields, const auto& sound) {
        Bench bench;
        CHECK(refusalOf([&] { joinOnBench(bench, sound); }) == "");
        for (const std::string& fault : faultsOf(name, fields, sound, joinOnBench)) CHECK(fault == "");
    });
}

TEST_CASE("a joint is not changed when a field is wrong, or is one that only a new joint can have",
          "[dynamics][joints][errors]") {
    forEachKind([](const std::string& name, const auto& fields, const auto& sound) {
        Bench bench;
        const JointId id = bench.world.join(resolved(bench, sound));
        bench.world.step(1.0 / 60);
        for (const auto& field : fields) {
            for (const auto& spoil : field.spoils) {
                auto bad = sound;
                spoil.spoil(bad);
                const std::string complaint = isFrame(field.name) ? "remove it and join anew" : spoil.complaint;
                const std::string whole = name + "." + field.name + spoil.member;
                const auto set = [&] { bench.world.joint(id).set(resolved(bench, bad)); };
                const std::string refusal = refusalOf(set);
                if (isFrame(field.name))
                    CHECK_THAT(refusal, containsText("remove it and join anew"));
                else
                    CHECK(faultOf(bench, set, whole, complaint) == "");
            }
        }
    });
}

TEST_CASE("a joint can be changed after its bodies have gone 1,000 km, or can no longer move",
          "[dynamics][joints][errors]") {
    forEachKind([](const std::string& name, const auto&, const auto& sound) {
        INFO(name);
        Bench bench;
        const JointId id = bench.world.join(resolved(bench, sound));
        for (const BodyId body : {bench.ball, bench.crate}) bench.world.body(body).setPose({1e6, 2e6}, 3);
        CHECK(refusalOf([&] { bench.world.joint(id).set(resolved(bench, sound)); }) == "");
        for (const BodyId body : {bench.ball, bench.crate}) bench.world.body(body).setType(BodyType::Static);
        CHECK(refusalOf([&] { bench.world.joint(id).set(resolved(bench, sound)); }) == "");
        CHECK(unsoundAfter(bench.world) == "");
    });
}

TEST_CASE("numbers from 1e-320 to infinity in a joint are refused, or leave every body finite and out of quarantine",
          "[dynamics][joints][errors]") {
    forEachKind([](const std::string& name, const auto& fields, const auto& sound) {
        for (const std::string& fault : unsoundWith(name, fields, sound, joinOnBench, unsoundOrQuarantinedAfter))
            CHECK(fault == "");
    });
    for (const std::string& fault :
         unsoundWith("DistanceJointDef", distanceFields, springy, joinOnBench, unsoundOrQuarantinedAfter))
        CHECK(fault == "");
}

TEST_CASE(
    "such numbers given to a joint that has held for a step are refused, or leave every body finite and "
    "out of quarantine",
    "[dynamics][joints][errors]") {
    forEachKind([](const std::string& name, const auto& fields, const auto& sound) {
        const auto set = [&sound](Bench& bench, const auto& def) {
            const JointId id = bench.world.join(resolved(bench, sound));
            bench.world.step(1.0 / 60);
            bench.world.joint(id).set(resolved(bench, def));
        };
        for (const std::string& fault : unsoundWith(name, fields, sound, set, unsoundOrQuarantinedAfter))
            CHECK(fault == "");
    });
}

}  // namespace plumb::test
