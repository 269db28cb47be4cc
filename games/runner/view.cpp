// SPDX-License-Identifier: MIT
#include <games/runner/view.h>

#include <algorithm>
#include <cmath>

namespace plumb::games::runner {
namespace {

constexpr double height = 11.5;  ///< of the camera's view [m]
constexpr double width = height * screenWidth / screenHeight;
constexpr double uprightWidth = 13;  ///< of the view in an upright window [m]
constexpr double soilBelow = 1.6;    ///< what such a view shows below the map [m]
constexpr double lookAhead = 2.6;    ///< at full speed [m]

/// Keeps the view inside the map; centres a map that is smaller than the view.
double within(double center, double extent, double size) {
    return size < extent ? size / 2 : std::clamp(center, extent / 2, size - extent / 2);
}

}  // namespace

void View::reset(const Stage& stage) {
    *this = View{};
    stageTicks_ = stage.ticks();
    floor_ = stage.heroAt().y();
    center_ = {within(stage.heroAt().x(), width, stage.tiles().columns()),
               within(floor_ + 1.4, height, stage.tiles().rows())};
    before_ = center_;
    rows_ = stage.tiles().rows();
    upright_ = {within(stage.heroAt().x(), uprightWidth, stage.tiles().columns()), floor_ + 1.4};
    uprightBefore_ = upright_;
}

void View::hear(const Event& event) {
    if (event.kind == EventKind::Jumped) squashSpeed_ = -7;
    if (event.kind == EventKind::Sprung) squashSpeed_ = -12;
    if (event.kind == EventKind::Stomped) squashSpeed_ = 6;
    if (event.kind == EventKind::Landed) squashSpeed_ = std::min(10.0, 0.75 * event.strength);
    if (event.kind == EventKind::BrickBroke) shake_ = 0.12;
    if (event.kind == EventKind::Hurt) shake_ = 0.25;
    if (event.kind == EventKind::Died) shake_ = 0.35;
}

void View::update(const Stage& stage) {
    ++ticks_;
    before_ = center_;
    uprightBefore_ = upright_;
    const Vec2 hero = stage.heroAt();
    const Slide& slide = stage.hero().mover.slide();
    moves_ = stage.ticks() != stageTicks_;
    stageTicks_ = stage.ticks();
    pace_ = moves_ ? slide.velocity.x() : 0;  // a stage that stands still keeps its last velocity
    squashSpeed_ += (-220 * squash_ - 18 * squashSpeed_) * tickSeconds;
    squash_ = std::clamp(squash_ + squashSpeed_ * tickSeconds, -0.3, 0.32);
    lean_ += (std::clamp(pace_ / 9, -1.0, 1.0) - lean_) * 0.15;
    if (slide.isOnFloor) stride_ += pace_ * tickSeconds;
    shake_ *= 0.86;

    ahead_ += (lookAhead * std::clamp(pace_ / 9, -1.0, 1.0) - ahead_) * 0.03;
    // The camera follows the hero's height on the floor, in a fall and in a very high rise, but not in every jump.
    if (slide.isOnFloor || hero.y() < floor_ || hero.y() > floor_ + 4.5)
        floor_ += (hero.y() - floor_) * (hero.y() < floor_ ? 0.16 : 0.07);
    const Vec2 wanted(within(hero.x() + ahead_, width, stage.tiles().columns()),
                      within(floor_ + 1.4, height, stage.tiles().rows()));
    center_ += Vec2((wanted.x() - center_.x()) * 0.2, (wanted.y() - center_.y()) * 0.16);
    const double ahead = within(hero.x() + 1.3 * ahead_, uprightWidth, stage.tiles().columns());
    upright_ += Vec2((ahead - upright_.x()) * 0.2, (floor_ + 1.4 - upright_.y()) * 0.16);
}

double View::stageTime(double between) const {
    return (static_cast<double>(stageTicks_) - (moves_ ? 1 - between : 0)) * tickSeconds;
}

Vec2 View::shaken(const Vec2& center) const {
    const double turn = ticks_ * 1.9;
    return center + shake_ * Vec2(std::sin(turn), std::cos(1.3 * turn));
}

Camera View::camera(double between) const {
    return {.center = shaken(before_ + (center_ - before_) * between), .height = height};
}

Camera View::cameraIn(const Aabb& screen, double between) const {
    if (!isUpright(screen)) return camera(between);
    const double unit = uprightWidth / screenWidth, seen = (screen.upper.y() - screen.lower.y()) * unit;
    const double lowest = seen / 2 - soilBelow, highest = rows_ + uprightBand * unit - seen / 2;
    Vec2 center = uprightBefore_ + (upright_ - uprightBefore_) * between;
    center = {center.x(), std::clamp(center.y(), lowest, std::max(lowest, highest))};
    return {.center = shaken(center), .height = uprightWidth * screenHeight / screenWidth};
}

}  // namespace plumb::games::runner
