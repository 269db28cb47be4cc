// SPDX-License-Identifier: MIT
#include <games/frame/pose_trail.h>

#include <plumb/stepping/interpolate.h>

namespace plumb::games {

void PoseTrail::keep(const World& world) {
    kept_.clear();
    for (const BodyId id : world.bodies()) {
        if (kept_.size() <= id.index) kept_.resize(id.index + std::size_t{1});
        kept_[id.index] = {id, world.body(id).pose()};
    }
}

Transform PoseTrail::pose(const World& world, BodyId body, double between) const {
    Transform now = world.body(body).pose();
    if (body.index >= kept_.size() || kept_[body.index].body != body) return now;
    const Transform& before = kept_[body.index].pose;
    now.position += world.wrap().shiftNear(now.position, before.position);
    return interpolate(before, now, between);
}

}  // namespace plumb::games
