// SPDX-License-Identifier: MIT
// Which numbers define the game?
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <plumb/math/check.h>
#include <plumb/math/vec2.h>

namespace plumb::games::artillery {

inline constexpr double gravity = 9.81;    ///< [m/s^2]
inline constexpr double dragRate = 0.12;   ///< drag of a shell, divided by its mass and its speed through the air [1/s]
inline constexpr double slowestShot = 6;   ///< at a charge of 0 [m/s]
inline constexpr double fastestShot = 33;  ///< at a full charge [m/s]
inline constexpr int fullCharge = 100;     ///< each tick that fire is held adds one [-]

inline constexpr double worldEdge = 62;  ///< objects farther from the middle are removed [m]
inline constexpr double worldFloor = -9;

inline constexpr int turnTicks = 25 * 60;   ///< time to aim and fire
inline constexpr int hurryTicks = 5 * 60;   ///< the last part of turnTicks, with a countdown sound
inline constexpr int readyTicks = 50;       ///< before turnTicks, to show whose turn it is
inline constexpr int settleTicks = 7 * 60;  ///< longest wait for the next turn while anything still moves
inline constexpr int gunnersEach = 3;
inline constexpr int fullHealth = 100;
inline constexpr double walkSpeed = 2.2;  ///< [m/s]
inline constexpr int walkTicks = 110;     ///< how long a gunner may walk per turn
inline constexpr double tideRise = 0.55;  ///< per turn, once the tide rises [m]

/// The kinds of shapes, for their filters.
enum Category : std::uint64_t { Ground = 1, Thing = 2, Person = 4, Shot = 8, Air = 16, Sea = 32, Blast = 64 };

struct Weapon {
    std::string_view name;
    double blast = 0;        ///< radius of damage [m]
    double crater = 0;       ///< radius [m]
    int damage = 0;          ///< at the centre; it falls to 0 at the radius blast
    double push = 0;         ///< for World::explode: impulse per metre of width [N s/m]
    int fuse = 0;            ///< [ticks]; 0: explodes on contact
    double restitution = 0;  ///< only for weapons with a fuse [-]
    int rounds = 0;          ///< for each crew; 0: unlimited
};
inline constexpr std::array<Weapon, 3> weapons{{
    {.name = "Shell", .blast = 3.6, .crater = 2.1, .damage = 60, .push = 10},
    {.name = "Bouncer",
     .blast = 3.8,
     .crater = 2.2,
     .damage = 65,
     .push = 10.5,
     .fuse = 210,
     .restitution = 0.55,
     .rounds = 3},
    {.name = "Thunder", .blast = 6.0, .crater = 3.6, .damage = 80, .push = 14, .rounds = 1},
}};
/// The explosion of a powder keg.
inline constexpr Weapon kegBlast{.name = "Keg", .blast = 4.2, .crater = 2.0, .damage = 50, .push = 9};

/// The random error of the computer's aim: uniform up to these limits, in either direction. Strengths differ only in
/// this.
struct Strength {
    std::string_view name;
    double angleError = 0;  ///< [degrees]
    double speedError = 0;  ///< share of the planned speed [-]
};
inline constexpr std::array<Strength, 3> strengths{{
    {"weak", 9.0, 0.16},
    {"fair", 4.0, 0.06},
    {"strong", 1.0, 0.012},
}};
/// Throws std::invalid_argument when no strength has this name.
inline const Strength& strengthOf(std::string_view name) {
    for (const Strength& strength : strengths)
        if (strength.name == name) return strength;
    refuse("strength", "\"" + std::string(name) + "\" is not weak, fair or strong");
}

/// One of the islands that a single player goes through.
struct Stage {
    std::string_view name;
    std::string_view rival;  ///< a strength
    double wind = 0;         ///< highest speed, in either direction [m/s]
    int tideTurn = 0;        ///< from this turn on the sea rises
};
inline constexpr std::array<Stage, 3> stages{{
    {"Morning at Gull Rock", "weak", 6, 22},
    {"Sundown at Ember Isle", "fair", 10, 18},
    {"Night off Cape Thunder", "strong", 14, 14},
}};

}  // namespace plumb::games::artillery
