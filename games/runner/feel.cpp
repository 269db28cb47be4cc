// SPDX-License-Identifier: MIT
#include <games/runner/feel.h>

#include <cmath>

#include <plumb/math/check.h>

namespace plumb::games::runner {
namespace {

PlatformProfile modern() {
    PlatformProfile profile =
        modernProfile({.height = 4.3, .timeToApex = 0.46, .fallFactor = 1.5, .releaseFactor = 3, .hangShare = 0.6});
    profile.horizontal.walkSpeed = 5.8;
    profile.horizontal.runSpeed = 9.4;
    profile.horizontal.walkAcceleration = 34;
    profile.horizontal.runAcceleration = 26;
    profile.horizontal.friction = 40;
    profile.horizontal.airFriction = 10;
    profile.horizontal.airShare = 0.8;
    profile.horizontal.turnFactor = 2;
    profile.vertical.terminalSpeed = 17;
    return profile;
}

}  // namespace

Feel feelOf(const std::string& name) {
    if (name != "1985" && name != "modern") plumb::refuse("--profile", "\"" + name + "\" is not one of 1985, modern");
    Feel feel{name == "1985" ? profile1985() : modern(), name == "1985" ? tickOf1985 : 1.0 / 60};
    feel.profile.slide.pushStrength = 260;
    feel.profile.slide.weight = 160;
    feel.profile.slide.platformOnLeave = PlatformOnLeave::AddUpwardVelocity;
    return feel;
}

double speedToRise(const PlatformProfile& profile, double height) {
    return std::sqrt(2 * profile.vertical.jumps.front().riseGravity * height);
}

}  // namespace plumb::games::runner
