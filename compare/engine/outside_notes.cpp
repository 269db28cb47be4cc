// SPDX-License-Identifier: MIT
#include <compare/engine/outside_notes.h>

#include <algorithm>

namespace plumb::compare {
namespace {

bool hasMover(const Scene& scene, const auto& isMeant) {
    return std::ranges::any_of(scene.movers, [&](const SceneMover& mover) { return isMeant(mover.motion); });
}

bool isStopped(const MoverMotion& motion) {
    const auto* sliding = std::get_if<SlidingMotion>(&motion);
    return sliding != nullptr && sliding->standIn == StandIn::Stopped;
}

/// Is the motion a platform motion that only rides (jumps is false), or one that runs and jumps (jumps is true)?
bool isPlatform(const MoverMotion& motion, bool jumps) {
    const auto* platform = std::get_if<PlatformMotion>(&motion);
    return platform != nullptr && platform->cues.empty() != jumps;
}

bool isTold(const MoverMotion& motion) {
    return !isStopped(motion) && !std::holds_alternative<PlatformMotion>(motion);
}

}  // namespace

std::vector<std::string> outsideNotes(const Scene& scene, const std::string& product, const std::string& stoppedMover) {
    std::vector<std::string> notes;
    if (!scene.fields.empty())
        notes.push_back(product +
                        " has no fields: the forces of this scene's fields are applied to its bodies from outside, "
                        "once a step, and stay the same through it. In Plumb they act in each sub-step.");
    if (hasMover(scene, isTold))
        notes.push_back(product +
                        " has no such movers: before each step their bodies are given the velocity that takes them "
                        "where they are wanted, through whatever is there.");
    if (hasMover(scene, [](const MoverMotion& motion) { return isPlatform(motion, true); }))
        notes.push_back("What runs and jumps is, in " + product +
                        ", a dynamic body that cannot turn: it is told its velocity before each step, and falls by the "
                        "gravity of its phase.");
    if (hasMover(scene, [](const MoverMotion& motion) { return isPlatform(motion, false); }))
        notes.push_back("Who rides is, in " + product +
                        ", a dynamic body that cannot turn, and stands by its friction.");
    if (hasMover(scene, isStopped)) notes.push_back(stoppedMover);
    if (scene.wrap.any())
        notes.push_back(
            product +
            "'s world does not wrap: what has left it after a step is put in at the other side, and nothing "
            "meets across the seam.");
    return notes;
}

EngineCard asBullets(EngineCard card, std::vector<double> dash) {
    card.name += " bullets";
    card.label += " with bullets";
    card.look.dash = std::move(dash);
    card.look.width = 2.4;
    return card;
}

}  // namespace plumb::compare
