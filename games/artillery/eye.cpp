// SPDX-License-Identifier: MIT
#include <games/artillery/eye.h>

#include <algorithm>

#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr double nearHeight = 25, readyHeight = 31;  ///< [m]
constexpr double slow = 0.06, quick = 0.12;          ///< share of the remaining way per tick: zoom in, zoom out [-]

Camera wholeField(double height) {
    return {.center = {0, fieldBottom + height / 2}, .height = height};
}

/// A view of this height around a place, kept within the whole field.
Camera closeUp(const Vec2& place, double height) {
    const double side = (fieldHeight - height) * 8 / 9;
    const double low = fieldBottom + height / 2, high = fieldBottom + fieldHeight - height / 2;
    return {.center = {std::clamp(place.x(), -side, side), std::clamp(place.y() + 2, low, high)}, .height = height};
}

Camera mixed(const Camera& a, const Camera& b, double share) {
    return {a.center + (b.center - a.center) * share, a.height + (b.height - a.height) * share};
}

/// The whole field while the shell rises, or more if it flies higher; then a closer view of its fall.
Camera following(const Battle& battle) {
    const BodyView shell = battle.world().body(battle.shell()->body);
    const Vec2 at = shell.position();
    if (shell.velocity().y() < 0 && at.y() < fieldBottom + readyHeight - 10) return closeUp(at, readyHeight);
    return wholeField(std::max(fieldHeight, at.y() + 4 - fieldBottom));
}

}  // namespace

Eye::Eye() : now_(wholeField(fieldHeight)), before_(now_) {}

Camera Eye::wanted(const Battle& battle) const {
    switch (battle.phase()) {
        case Phase::Ready: return closeUp(battle.middleOf(battle.gunner()), readyHeight);
        case Phase::Flight: return battle.shell() ? following(battle) : now_;
        case Phase::Settle: return closeUp(place_, nearHeight);
        case Phase::Aim:
        case Phase::Over: break;
    }
    return wholeField(fieldHeight);
}

void Eye::update(const Battle& battle) {
    before_ = now_;
    if (const auto& shell = battle.shell()) place_ = battle.world().body(shell->body).position();
    const Camera next = wanted(battle);
    now_ = mixed(now_, next, next.height > now_.height ? quick : slow);
    shake_ *= 0.9;
    ++ticks_;
}

Camera Eye::camera(double between) const {
    Camera camera = mixed(before_, now_, between);
    const double time = ticks_ - 1 + between;
    camera.center += 0.45 * shake_ * Vec2(sinCos(time * 1.9).sin, sinCos(time * 2.3).cos);
    return camera;
}

Camera Eye::farCamera(double between, double share) const {
    return mixed(wholeField(fieldHeight), mixed(before_, now_, between), share);
}

}  // namespace plumb::games::artillery
