// SPDX-License-Identifier: MIT
// Which definitions does a bench take, and how can their members be wrong together?
#pragma once
#include <variant>
#include <vector>

#include "kit/dynamics/described_spoils.h"

namespace plumb::test {

/// Each kind of joint, those with a motor and a spring both ways, motors running, so that what they are told counts.
std::vector<JointDef> soundJoints(const Bench& bench);
/// With a shape of each kind; on the bench it falls on the floor.
BodyDef soundBody();
/// One of each kind.
std::vector<ShapeDef> soundShapes();
/// Of each law.
std::vector<FieldDef> soundFields(BodyId carrier);

/// Calls visit(make) for each sound joint, of which make(bench) gives the definition.
template <class Visit>
void forEachSoundJoint(Visit&& visit) {
    const std::vector<JointDef> all = soundJoints(Bench());
    for (std::size_t i = 0; i < all.size(); ++i)
        std::visit([&]<class Def>(
                       const Def&) { visit([i](const Bench& bench) { return std::get<Def>(soundJoints(bench)[i]); }); },
                   all[i]);
}

/// Calls visit(bad, wrong) for each way in which members of a joint are wrong together, or do not suit the world.
template <class Def, class Visit>
void forEachWrongTogether(const Bench& bench, const Def& sound, Visit&& visit) {
    const auto spoil = [&](const Wrong& wrong, auto&& change) {
        Def bad = sound;
        change(bad);
        visit(std::as_const(bad), wrong);
    };
    if constexpr (requires { sound.bodyA; }) {
        spoil({"bodyB", "", "is the same body as bodyA, two were wanted", true}, [](Def& d) { d.bodyB = d.bodyA; });
        if constexpr (!std::is_same_v<Def, FilterJointDef>)
            spoil({"bodyB", "", "is not dynamic, nor is bodyA", true}, [&](Def& d) { d.bodyB = bench.floor; });
    }
    if constexpr (requires { sound.limit; })
        spoil({"limit", ".lower", "2 is more than limit.upper 1"}, [](Def& d) { d.limit = Limit{2, 1}; });
    if constexpr (std::is_same_v<Def, DistanceJointDef>) {
        spoil({"maxLength", "", "1 is less than minLength 2"}, [](Def& d) { d.minLength = 2, d.maxLength = 1; });
        if (!sound.spring) spoil({"anchorB", "", "(0, 4) is anchorA too", true}, [](Def& d) { d.anchorB = d.anchorA; });
    }
    if constexpr (std::is_same_v<Def, PulleyJointDef>) {
        spoil({"groundA", "", "(0, 4) is anchorA too", true}, [](Def& d) { d.groundA = d.anchorA; });
        spoil({"groundB", "", "(2, 4) is anchorB too", true}, [](Def& d) { d.groundB = d.anchorB; });
    }
    if constexpr (std::is_same_v<Def, GearJointDef>) {
        spoil({"jointB", "", "is the same joint as jointA, two were wanted", true},
              [](Def& d) { d.jointB = d.jointA; });
        spoil({"jointA", "", "is neither revolute nor prismatic", true}, [&](Def& d) { d.jointA = bench.rod; });
        spoil({"jointB", "", "is neither revolute nor prismatic", true}, [&](Def& d) { d.jointB = bench.rod; });
    }
    if constexpr (std::is_same_v<Def, TargetJointDef>)
        spoil({"body", "", "is not dynamic", true}, [&](Def& d) { d.body = bench.floor; });
}

}  // namespace plumb::test
