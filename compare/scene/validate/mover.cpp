// SPDX-License-Identifier: MIT
#include <compare/scene/validate/parts.h>

#include <algorithm>
#include <string>

#include <compare/scene/fields.h>
#include <compare/scene/named.h>
#include <compare/scene/require_fields.h>
#include <plumb/math/check.h>
#include <plumb/steering/path.h>

namespace plumb::compare {
namespace {

void validateMotion(const Scene&, const PathMotion& motion, const std::string& field) {
    if (motion.points.size() < 2)
        refuse(field + ".points", std::to_string(motion.points.size()) + " make no path, wanted 2 or more");
    for (std::size_t i = 0; i < motion.points.size(); ++i) requireFinite(motion.points[i], at(field + ".points", i));
    requireFields(motion, field);
    (void)pathMoverOf(motion);
}

void validateMotion(const Scene&, const SlidingMotion& motion, const std::string& field) {
    requireFields(motion, field);
}

void validateMotion(const Scene& scene, const GridMotion& motion, const std::string& field) {
    requireKnown(motion.map, namesOf(scene.bodies), field + ".map", "a body");
    const auto body = std::ranges::find(scene.bodies, motion.map, &SceneBody::name);
    if (body->def.shapes.empty() || !std::holds_alternative<TileMap>(body->def.shapes.front().shape))
        refuse(field + ".map", quoted(motion.map) + " is a body whose first shape is no tile map");
    const TileMap& map = std::get<TileMap>(body->def.shapes.front().shape);
    if (!map.contains(motion.cell)) refuse(field + ".cell", "is not one of the map");
    requireFields(motion, field);
}

void validateMotion(const Scene&, const PlatformMotion& motion, const std::string& field) {
    for (std::size_t i = 0; i < motion.cues.size(); ++i) {
        const std::string cue = at(field + ".cues", i);
        requireFields(motion.cues[i], cue);
        if (i > 0 && motion.cues[i].time < motion.cues[i - 1].time)
            refuse(cue + ".time", toText(motion.cues[i].time) + " is before the cue before it");
    }
}

void validateMotion(const Scene&, const SwingMotion& motion, const std::string& field) {
    requireFields(motion, field);
}

void validateMotion(const Scene& scene, const SteeredMotion& motion, const std::string& field) {
    requireFields(motion, field);
    for (std::size_t i = 0; i < motion.points.size(); ++i) requireFinite(motion.points[i], at(field + ".points", i));
    if (motion.behaviour == Behaviour::Follow) {
        if (motion.points.size() < 2)
            refuse(field + ".points", std::to_string(motion.points.size()) + " make no path, wanted 2 or more");
        requirePositive(lengthOf({motion.points, motion.closed}), field + ".points: the length of their path");
    }
    if (scene.wrap.any()) refuse(field, "agents do not see across a seam, wanted none where the world wraps");
}

/// The target, and what else depends on the body that the mover moves.
void validateSteered(const Scene& scene, const SceneBody& body, const SteeredMotion& motion, const std::string& field) {
    const std::string behaviour = quoted(behaviourTags[static_cast<std::size_t>(motion.behaviour)]);
    if (motion.behaviour == Behaviour::Avoid && !discRadius(body.def))
        refuse(field + ".behaviour",
               behaviour + " is for a body with a circle, and " + quoted(body.name) + " has none");
    const std::string target = field + ".target";
    if (!needsTarget(motion.behaviour)) {
        if (!motion.target.empty()) refuse(target, quoted(motion.target) + " is given, wanted none for " + behaviour);
        return;
    }
    requireKnown(motion.target, namesOf(scene.bodies), target, "a body");
    if (motion.target == body.name) refuse(target, quoted(body.name) + " is the body that steers, wanted another one");
    if (!isAlwaysThere(*std::ranges::find(scene.bodies, motion.target, &SceneBody::name)))
        refuse(target, quoted(motion.target) + " appears later, wanted a body that is always there");
}

}  // namespace

void validateMover(const Scene& scene, std::size_t index) {
    const SceneMover& mover = scene.movers[index];
    const std::string field = at("movers", index);
    requireKnown(mover.body, namesOf(scene.bodies), field + ".body", "a body");
    const auto body = std::ranges::find(scene.bodies, mover.body, &SceneBody::name);
    if (body->def.type != BodyType::Kinematic)
        refuse(field + ".body", quoted(mover.body) + " is not kinematic: it has a motion of its own");
    for (std::size_t i = 0; i < index; ++i)
        if (scene.movers[i].body == mover.body) refuse(field + ".body", quoted(mover.body) + " has a mover already");
    const std::string path = field + "." + moverTags[mover.motion.index()];
    std::visit([&](const auto& motion) { validateMotion(scene, motion, path); }, mover.motion);
    if (const auto* steered = std::get_if<SteeredMotion>(&mover.motion)) validateSteered(scene, *body, *steered, path);
}

}  // namespace plumb::compare
