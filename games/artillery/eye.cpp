// SPDX-License-Identifier: MIT
#include <games/artillery/eye.h>

#include <algorithm>

#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr double nearHeight = 25, readyHeight = 31;  ///< [m]
constexpr double belowDisplays = 0.79;               ///< share of a wide picture below the displays at its top [-]
constexpr double uprightLowest = -2.5;               ///< of the lower edge of an upright field [m]
constexpr double uprightReach = 38;                  ///< from the middle to the edge of an upright picture [m]
constexpr double slow = 0.06, quick = 0.12;          ///< share of the remaining way per tick: zoom in, zoom out [-]
constexpr double chase = 0.14;                       ///< the same for a shell in an upright window [-]

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
    return wholeField(std::max(fieldHeight, (at.y() + 1 - fieldBottom) / belowDisplays));
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

Eye::Look Eye::wantedUpright(const Battle& battle) const {
    const Gunner& gunner = battle.gunner();
    const Vec2 at = battle.middleOf(gunner);
    switch (battle.phase()) {
        case Phase::Ready: return {at + Vec2(0, 3), 24};
        case Phase::Aim: return {at + Vec2(9.0 * gunner.aim.facing, 4), 30};
        case Phase::Flight: return {place_, 28};
        case Phase::Settle: return {place_ + Vec2(0, 2), 20};
        case Phase::Over: break;
    }
    return {{0, 8}, 50};
}

void Eye::update(const Battle& battle) {
    before_ = now_;
    lookBefore_ = look_;
    if (const auto& shell = battle.shell()) place_ = battle.world().body(shell->body).position();
    const Camera next = wanted(battle);
    now_ = mixed(now_, next, next.height > now_.height ? quick : slow);
    const Look upright = wantedUpright(battle);
    look_.at += (upright.at - look_.at) * (battle.shell() ? chase : slow);
    look_.width += (upright.width - look_.width) * slow;
    shake_ *= 0.9;
    ++ticks_;
}

/// The look is in the middle of the field. The field ends a little below the sea, and a little beside the island.
Camera Eye::uprightCamera(double between, const Arrangement& arrangement) const {
    const Vec2 at = lookBefore_.at + (look_.at - lookBefore_.at) * between;
    const double width = lookBefore_.width + (look_.width - lookBefore_.width) * between, unit = width / screenWidth;
    const Aabb &field = arrangement.field, &screen = arrangement.screen;
    const double side = std::max(0.0, uprightReach - width / 2);
    const double least = uprightLowest + (field.upper.y() - field.lower.y()) / 2 * unit;
    const double lift = (field.lower.y() + field.upper.y() - screen.lower.y() - screen.upper.y()) / 2 * unit;
    return {.center = {std::clamp(at.x(), -side, side), std::max(at.y(), least) + lift},
            .height = width * screenHeight / screenWidth};
}

Camera Eye::camera(double between, const Arrangement& arrangement) const {
    Camera camera = arrangement.upright ? uprightCamera(between, arrangement) : mixed(before_, now_, between);
    const double time = ticks_ - 1 + between;
    camera.center += 0.45 * shake_ * Vec2(sinCos(time * 1.9).sin, sinCos(time * 2.3).cos);
    return camera;
}

Camera farCamera(const Camera& camera, double share) {
    return mixed(wholeField(fieldHeight), camera, share);
}

}  // namespace plumb::games::artillery
