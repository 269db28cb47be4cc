// SPDX-License-Identifier: MIT
// Which numbers make the game what it is?
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include <plumb/math/vec2.h>

namespace plumb::games::artillery {

inline constexpr double gravity = 9.81;    ///< [m/s^2]
inline constexpr double dragRate = 0.12;   ///< of a shell: drag over mass and speed through the air [1/s]
inline constexpr double slowestShot = 6;   ///< at a charge of 0 [m/s]
inline constexpr double fastestShot = 33;  ///< at a full charge [m/s]
inline constexpr int fullCharge = 100;     ///< each tick that fire is held adds one [-]

inline constexpr double worldEdge = 62;  ///< what is farther from the middle is gone [m]
inline constexpr double worldFloor = -9;

inline constexpr int turnTicks = 25 * 60;   ///< to aim and fire in
inline constexpr int hurryTicks = 5 * 60;   ///< the last of them, which are counted aloud
inline constexpr int readyTicks = 50;       ///< before all of them, to see whose turn it is
inline constexpr int settleTicks = 7 * 60;  ///< at most, until the next turn, while anything still moves
inline constexpr int gunnersEach = 3;
inline constexpr int fullHealth = 100;
inline constexpr double walkSpeed = 2.2;  ///< [m/s]
inline constexpr int walkTicks = 110;     ///< of a turn in which a gunner may walk
inline constexpr double tideRise = 0.55;  ///< of every turn, once the tide has turned [m]

/// Which shapes are what, for their filters.
enum Category : std::uint64_t { Ground = 1, Thing = 2, Person = 4, Shot = 8, Air = 16, Sea = 32, Blast = 64 };

struct Weapon {
    std::string_view name;
    double blast = 0;        ///< as far as this it hurts [m]
    double crater = 0;       ///< radius [m]
    int damage = 0;          ///< where it goes off; none at the blast's edge
    double push = 0;         ///< of world.explode, of a width of 1 m [N s/m]
    int fuse = 0;            ///< 0: it goes off at what it touches [ticks]
    double restitution = 0;  ///< of one with a fuse [-]
    int rounds = 0;          ///< for each crew; 0: as many as it likes
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
/// What a powder keg does, once it is set off.
inline constexpr Weapon kegBlast{.name = "Keg", .blast = 4.2, .crater = 2.0, .damage = 50, .push = 9};

/// How far off a computer's hand may be; evenly spread up to these, either way. Nothing else tells the strengths apart.
struct Strength {
    std::string_view name;
    double angleError = 0;  ///< [degrees]
    double speedError = 0;  ///< of the speed it wants [-]
};
inline constexpr std::array<Strength, 3> strengths{{
    {"weak", 9.0, 0.16},
    {"fair", 4.0, 0.06},
    {"strong", 1.0, 0.012},
}};
/// Throws std::invalid_argument when there is none of that name.
const Strength& strengthOf(std::string_view name);

/// What a lone player's way through the islands is made of.
struct Stage {
    std::string_view name;
    std::string_view rival;  ///< a strength
    double wind = 0;         ///< at most, either way [m/s]
    int tideTurn = 0;        ///< from this turn on the sea rises
};
inline constexpr std::array<Stage, 3> stages{{
    {"Morning at Gull Rock", "weak", 6, 22},
    {"Sundown at Ember Isle", "fair", 10, 18},
    {"Night off Cape Thunder", "strong", 14, 14},
}};

}  // namespace plumb::games::artillery
