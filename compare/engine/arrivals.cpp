// SPDX-License-Identifier: MIT
#include <compare/engine/arrivals.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumb::compare {
namespace {

int stepsIn(double time, double dt) {
    return static_cast<int>(std::lround(time / dt));
}

}  // namespace

bool bodyIsThereAtStart(const Scene& scene, std::size_t body) {
    return stepsIn(scene.bodies[body].appears, scene.dt) == 0;
}

bool jointIsThereAtStart(const Scene& scene, const std::vector<JointGeometry>& joints, std::size_t joint) {
    return std::ranges::all_of(bodiesOf(joints, joint),
                               [&](std::size_t body) { return bodyIsThereAtStart(scene, body); });
}

Arrivals::Arrivals(const Scene& scene) {
    if (std::ranges::all_of(scene.bodies, isAlwaysThere)) return;
    scene_ = std::make_shared<const Scene>(scene);
    joints_ = jointGeometries(scene);
    std::map<std::pair<int, int>, std::size_t> places;
    std::vector<std::size_t> arrivalOf(scene.bodies.size(), noBody);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        if (isAlwaysThere(body)) continue;
        const Arrival arrival{stepsIn(body.appears, scene.dt), stepsIn(body.renewed, scene.dt), {}, {}};
        const auto [place, isNew] = places.try_emplace({arrival.first, arrival.period}, arrivals_.size());
        if (isNew) arrivals_.push_back(arrival);
        arrivalOf[i] = place->second;
        arrivals_[place->second].bodies.push_back(i);
    }
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        for (const std::size_t body : bodiesOf(joints_, i)) {
            if (arrivalOf[body] == noBody) continue;
            arrivals_[arrivalOf[body]].joints.push_back(i);
            break;
        }
    }
}

BodyState Arrivals::awaited(std::size_t body) const {
    const BodyDef& def = scene_->bodies[body].def;
    return {.position = def.position, .angle = def.angle, .present = false};
}

std::vector<Arrivals::Due> Arrivals::dueBefore(int step) const {
    std::vector<Due> due;
    for (const Arrival& arrival : arrivals_) {
        const int since = step - arrival.first;
        const bool again = since > 0 && arrival.period > 0 && since % arrival.period == 0;
        if (again || (since == 0 && step > 0)) due.push_back({arrival, again});
    }
    return due;
}

}  // namespace plumb::compare
