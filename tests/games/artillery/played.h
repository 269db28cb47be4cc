// SPDX-License-Identifier: MIT
// How does a test play a battle to a given point?
#pragma once
#include <cstdint>

#include <games/artillery/commander.h>

namespace plumb::games::artillery::test {

inline constexpr Strength unerring{"unerring", 0, 0};

/// Gives no orders until Phase::Aim.
inline void waitToAim(Battle& battle) {
    while (battle.phase() != Phase::Aim) battle.update({});
    battle.takeHappenings();
}

struct FirstShot {
    Aim meant{}, fired{};
    double wind = 0;
    bool wentOff = false;
    Vec2 at{0, 0};
    double miss = 1e9;  ///< from the explosion to the nearest enemy's outline, as placed when fired [m]
};

/// Plays the computer's first shot of a battle, up to the explosion.
inline FirstShot firstShot(Battle& battle, const Strength& strength) {
    waitToAim(battle);
    Commander commander(battle.crew(), strength, 1);
    FirstShot shot{.wind = battle.wind()};
    while (battle.phase() == Phase::Aim) battle.update(commander.decide(battle));
    shot.meant = commander.meant().value_or(Aim{});
    shot.fired = battle.gunner().aim;
    std::vector<Vec2> enemies;
    for (const Gunner& gunner : battle.gunners())
        if (gunner.crew != battle.crew()) enemies.push_back(battle.middleOf(gunner));
    battle.takeHappenings();
    while (battle.phase() == Phase::Flight) battle.update({});
    for (const Happening& happening : battle.takeHappenings()) {
        if (happening.kind != Happening::Kind::Exploded || shot.wentOff) continue;
        shot.wentOff = true;
        shot.at = happening.at;
        for (const Vec2& enemy : enemies) shot.miss = std::min(shot.miss, distanceToGunner(enemy, shot.at));
    }
    return shot;
}

}  // namespace plumb::games::artillery::test
