// SPDX-License-Identifier: MIT
#include <plumb/movers/platform_mover.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/movers/detail/platform_tick.h>
#include <plumb/movers/detail/slide_probe.h>

namespace plumb {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Tolerant comparison for times that are sums of ticks.
bool isWithin(double time, double limit, double dt) {
    return time <= limit + 1e-6 * dt;
}

/// The last band whose speed is reached.
std::size_t bandOf(const std::vector<JumpBand>& bands, double speed) {
    std::size_t band = 0;
    while (band + 1 < bands.size() && speed >= bands[band + 1].fromSpeed * (1 - 1e-12)) ++band;
    return band;
}

Vec2 upOf(const PlatformProfile& profile) {
    return profile.slide.up / std::sqrt(profile.slide.up.dot(profile.slide.up));
}

}  // namespace

PlatformMover::PlatformMover(BodyId body, const PlatformProfile& profile) : body_(body), profile_(profile) {
    validate(profile, "PlatformProfile");
}

void PlatformMover::setProfile(const PlatformProfile& profile) {
    validate(profile, "PlatformProfile");
    profile_ = profile;
    band_ = 0;
}

void PlatformMover::setVelocity(const Vec2& velocity) {
    requireFinite(velocity, "PlatformMover: velocity");
    slide_.velocity = velocity;
    rising_ = launched_ = false;
    thrown_ = true;
}

void PlatformMover::launch(const Vec2& velocity) {
    setVelocity(velocity);
    band_ = 0;
    launched_ = true;
}

const JumpBand& PlatformMover::band(const PlatformInput& input) const {
    return input.swim && profile_.swim ? profile_.swim->stroke : profile_.vertical.jumps[band_];
}

bool PlatformMover::takesOff(const PlatformInput& input, bool fresh, double dt) const {
    if (input.swim && profile_.swim) return fresh;
    if (launched_) return false;
    const VerticalMotion& vertical = profile_.vertical;
    const bool requested = fresh || (input.jump && isWithin(sincePress_, vertical.jumpBuffer, dt));
    const bool late = mayStillJump_ && isWithin(sinceFloor_, vertical.coyoteTime, dt);
    return requested && (slide_.isOnFloor || late);
}

bool PlatformMover::dropsThrough(const World& world, const PlatformInput& input, bool fresh) const {
    if (!profile_.dropThrough || !fresh || !input.down || !slide_.isOnFloor || !slide_.floor) return false;
    return world.contains(slide_.floor->shape) && detail::openSideOf(*slide_.floor).has_value();
}

detail::TickMotion PlatformMover::horizontalPart(const PlatformInput& input, double speed, double dt) {
    const HorizontalMotion& horizontal = profile_.horizontal;
    const bool onFloor = slide_.isOnFloor;
    const bool withIt = !horizontal.runNeedsMotion || input.move * speed >= 0;
    const bool pushes = !horizontal.runNeedsMotion || input.move != 0;
    sinceRun_ = input.run && withIt && pushes ? 0 : sinceRun_ + dt;
    bool runs = withIt && pushes &&
                (sinceRun_ == 0 || (horizontal.runGrace > 0 && isWithin(sinceRun_, horizontal.runGrace, dt)));
    if (!onFloor && horizontal.airRunSpeed) runs = std::fabs(speed) >= *horizontal.airRunSpeed * (1 - 1e-12);
    std::optional<double> most;
    if (input.swim && profile_.swim) most = profile_.swim->speed;
    return detail::horizontalTick(profile_, {speed, input.move, runs, onFloor, most}, dt);
}

detail::TickMotion PlatformMover::verticalPart(const PlatformInput& input, double speed, double dt) {
    if (rising_ && (!input.jump && risen_ >= profile_.vertical.leastRise * (1 - 1e-12))) rising_ = false;
    if (!(speed > 0)) rising_ = launched_ = false;
    if (!rising_) holdLeft_ = 0;
    const detail::VerticalTick tick{speed, band(input), rising_ || launched_, input.jump && !launched_, holdLeft_};
    const detail::TickMotion motion = detail::verticalTick(profile_, tick, dt);
    holdLeft_ = std::max(0.0, holdLeft_ - dt);
    risen_ += motion.shift;
    return motion;
}

const Slide& PlatformMover::step(World& world, const PlatformInput& input, double dt, std::span<const BodyId> later) {
    requireWithin(input.move, -1, 1, "PlatformInput", ".move");
    requirePositive(dt, "PlatformMover.step: dt");
    const bool fresh = input.jump && !jumpHeld_;
    const bool drops = dropsThrough(world, input, fresh);
    const Vec2 up = upOf(profile_), right(up.y(), -up.x());
    sincePress_ = fresh && !drops ? 0 : sincePress_ + dt;
    sinceFloor_ = slide_.isOnFloor ? 0 : sinceFloor_ + dt;
    if (slide_.isOnFloor) mayStillJump_ = true;

    const double along = slide_.velocity.dot(right);
    const bool thrown = std::exchange(thrown_, false) && slide_.velocity.dot(up) > 0;
    double rise = slide_.isOnFloor && !thrown ? 0 : slide_.velocity.dot(up);
    const bool jumps = !drops && takesOff(input, fresh, dt);
    if (jumps) {
        band_ = bandOf(profile_.vertical.jumps, std::fabs(along));
        rise = band(input).takeOffSpeed;
        rising_ = true;
        launched_ = false;
        risen_ = 0;
        holdLeft_ = band(input).holdTime;
        sincePress_ = never;
    }
    if (jumps || drops || thrown) mayStillJump_ = false;

    const detail::TickMotion horizontal = horizontalPart(input, along, dt);
    const bool falls = jumps || drops || thrown || !slide_.isOnFloor;
    const detail::TickMotion vertical = falls ? verticalPart(input, rise, dt) : detail::TickMotion{};
    const SlideMotion motion{.velocity = right * horizontal.speed + up * vertical.speed,
                             .dt = dt,
                             .displacement = right * horizontal.shift + up * vertical.shift,
                             .dropThrough = drops,
                             .later = later};
    slide_ = moveAndSlide(world, body_, motion, profile_.slide, slide_);
    if (slide_.isOnFloor) launched_ = false;
    hasJumped_ = jumps;
    jumpHeld_ = input.jump;
    return slide_;
}

}  // namespace plumb
