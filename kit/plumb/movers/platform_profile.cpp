// SPDX-License-Identifier: MIT
#include <plumb/movers/platform_profile.h>

#include <algorithm>

#include <plumb/math/check.h>

namespace plumb {

namespace {

constexpr double pixel = 1.0 / 16;  // [m]

/// Speeds as in the tables: sixteenths of a pixel per tick.
double speedOf(int sixteenths) {
    return sixteenths / 16.0 * pixel / tickOf1985;
}
/// 4096ths of a pixel per tick, each tick.
double accelerationOf(int parts) {
    return parts / 4096.0 * pixel / (tickOf1985 * tickOf1985);
}
/// 256ths of a pixel per tick, each tick.
double gravityOf(int parts) {
    return accelerationOf(16 * parts);
}

JumpBand bandOf1985(int fromSpeed, int pixels, int rise, int fall) {
    return {.fromSpeed = speedOf(fromSpeed),
            .takeOffSpeed = speedOf(16 * pixels),
            .riseGravity = gravityOf(rise),
            .releaseGravity = gravityOf(fall),
            .fallGravity = gravityOf(fall)};
}

void validate(const HorizontalMotion& horizontal, const std::string& field) {
    requireNotNegative(horizontal.walkSpeed, field, ".walkSpeed");
    requireNotNegative(horizontal.runSpeed, field, ".runSpeed");
    requireNotNegative(horizontal.walkAcceleration, field, ".walkAcceleration");
    requireNotNegative(horizontal.runAcceleration, field, ".runAcceleration");
    requireNotNegative(horizontal.friction.value_or(0), field, ".friction");
    requireNotNegative(horizontal.airFriction.value_or(0), field, ".airFriction");
    requireNotNegative(horizontal.airShare, field, ".airShare");
    requireNotNegative(horizontal.turnFactor, field, ".turnFactor");
    requireNotNegative(horizontal.turnStopSpeed, field, ".turnStopSpeed");
    requireNotNegative(horizontal.fastSpeed.value_or(0), field, ".fastSpeed");
    requireNotNegative(horizontal.fastAcceleration, field, ".fastAcceleration");
    requireNotNegative(horizontal.airRunSpeed.value_or(0), field, ".airRunSpeed");
    requireNotNegative(horizontal.runGrace, field, ".runGrace");
    requireNotNegative(horizontal.moveGrain, field, ".moveGrain");
}

void validate(const JumpBand& band, const std::string& field) {
    requireNotNegative(band.fromSpeed, field, ".fromSpeed");
    requireNotNegative(band.takeOffSpeed, field, ".takeOffSpeed");
    requireNotNegative(band.riseGravity, field, ".riseGravity");
    requireNotNegative(band.releaseGravity, field, ".releaseGravity");
    requireNotNegative(band.fallGravity, field, ".fallGravity");
    requireNotNegative(band.holdTime, field, ".holdTime");
    requireFinite(band.holdAcceleration, field, ".holdAcceleration");
}

void validate(const VerticalMotion& vertical, const std::string& field) {
    if (vertical.jumps.empty()) refuse(field + ".jumps", "is empty: one band at least was wanted");
    double before = -1;
    for (std::size_t i = 0; i < vertical.jumps.size(); ++i) {
        const std::string name = field + ".jumps[" + std::to_string(i) + "]";
        validate(vertical.jumps[i], name);
        const double from = vertical.jumps[i].fromSpeed;
        if (i == 0 ? from > 0 : !(from > before))
            refuse(name + ".fromSpeed", toText(from) + (i == 0 ? " is not 0" : " is not above the one before"));
        before = from;
    }
    requireNotNegative(vertical.leastRise, field, ".leastRise");
    requireNotNegative(vertical.hangSpeed, field, ".hangSpeed");
    requirePositive(vertical.hangShare, field, ".hangShare");
    requirePositive(vertical.terminalSpeed, field, ".terminalSpeed");
    requireNotNegative(vertical.terminalUnit, field, ".terminalUnit");
    requireNotNegative(vertical.coyoteTime, field, ".coyoteTime");
    requireNotNegative(vertical.jumpBuffer, field, ".jumpBuffer");
}

void require(const JumpFeel& feel) {
    requirePositive(feel.height, "JumpFeel", ".height");
    requirePositive(feel.timeToApex, "JumpFeel", ".timeToApex");
    requirePositive(feel.fallFactor, "JumpFeel", ".fallFactor");
    requirePositive(feel.releaseFactor, "JumpFeel", ".releaseFactor");
    requireWithin(feel.hangSpeedPart, 0, 1, "JumpFeel", ".hangSpeedPart");
    requirePositive(feel.hangShare, "JumpFeel", ".hangShare");
    requireNotNegative(feel.holdTime, "JumpFeel", ".holdTime");
    if (!(feel.holdTime < feel.timeToApex))
        refuse("JumpFeel.holdTime", toText(feel.holdTime) + " is not less than timeToApex, " + toText(feel.timeToApex));
}

}  // namespace

double jumpHeight(const JumpBand& band, double held) {
    validate(band, "JumpBand");
    if (!(held >= 0)) refuse("jumpHeight: held", toText(held) + " is not 0 or more");
    const double v = band.takeOffSpeed, a = band.holdAcceleration, hold = std::min(held, band.holdTime);
    if (v + a * hold <= 0) return v > 0 ? -0.5 * v * v / a : 0;
    const double speed = v + a * hold, rise = (v + 0.5 * a * hold) * hold;
    const auto risen = [](double lost, double mean, double gravity) { return lost > 0 ? mean * lost / gravity : 0; };
    // What is left of the speed when jump is released after the hold phase.
    const double left = std::max(0.0, speed - (held > hold ? band.riseGravity * (held - hold) : 0));
    return rise + risen(speed - left, 0.5 * (speed + left), band.riseGravity) +
           risen(left, 0.5 * left, band.releaseGravity);
}

PlatformProfile modernProfile(const JumpFeel& feel) {
    require(feel);
    const double a = feel.hangSpeedPart, k = 1 / feel.hangShare - 1, T = feel.timeToApex - feel.holdTime;
    const double hold = 2 * feel.holdTime * (1 + a * k) / (1 + a * a * k);
    const double v = 2 * feel.height / (T + hold) * (1 + a * k) / (1 + a * a * k), g = v / T * (1 + a * k);
    PlatformProfile profile;
    profile.vertical.jumps = {{.takeOffSpeed = v,
                               .riseGravity = g,
                               .releaseGravity = feel.releaseFactor * g,
                               .fallGravity = feel.fallFactor * g,
                               .holdTime = feel.holdTime}};
    profile.vertical.hangSpeed = a * v;
    profile.vertical.hangShare = feel.hangShare;
    profile.vertical.coyoteTime = 0.1;
    profile.vertical.jumpBuffer = 0.1;
    profile.slide.stepHeight = 0.25;
    profile.slide.cornerCorrection = 0.25;
    profile.slide.ledgeNudge = 0.1;
    profile.slide.pushStrength = 300;
    return profile;
}

PlatformProfile profile1985() {
    PlatformProfile profile;
    profile.horizontal = {.walkSpeed = speedOf(0x18),
                          .runSpeed = speedOf(0x28),
                          .walkAcceleration = accelerationOf(0x98),
                          .runAcceleration = accelerationOf(0xE4),
                          .friction = std::nullopt,
                          .airFriction = 0,
                          .airShare = 1,
                          .turnFactor = 2,
                          .turnStopSpeed = speedOf(0x0B),
                          .fastSpeed = speedOf(0x21),
                          .fastAcceleration = accelerationOf(0xD0),
                          .airRunSpeed = speedOf(0x19),
                          .runGrace = 10 * tickOf1985,
                          .runNeedsMotion = true,
                          .overSpeed = OverSpeed::Cut,
                          .order = TickOrder::VelocityFirst,
                          .moveGrain = pixel / 16};
    profile.vertical.jumps = {bandOf1985(0, 4, 0x20, 0x70), bandOf1985(0x10, 4, 0x1E, 0x60),
                              bandOf1985(0x19, 5, 0x28, 0x90)};
    profile.vertical.leastRise = pixel;
    profile.vertical.terminalSpeed = speedOf(16 * 4);
    profile.vertical.terminalUnit = speedOf(16);
    profile.vertical.order = TickOrder::PositionFirst;
    profile.swim = SwimMotion{speedOf(0x10),
                              {.takeOffSpeed = speedOf(16 + 8),
                               .riseGravity = gravityOf(0x0D),
                               .releaseGravity = gravityOf(0x0A),
                               .fallGravity = gravityOf(0x0A)}};
    profile.dropThrough = false;
    profile.grain = pixel / 4096;
    return profile;
}

void validate(const PlatformProfile& profile, const std::string& field) {
    validate(profile.horizontal, field + ".horizontal");
    validate(profile.vertical, field + ".vertical");
    if (profile.swim) {
        requireNotNegative(profile.swim->speed, field, ".swim.speed");
        validate(profile.swim->stroke, field + ".swim.stroke");
    }
    validate(profile.slide, field + ".slide");
    requireNotNegative(profile.grain, field, ".grain");
}

}  // namespace plumb
