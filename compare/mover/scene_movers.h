// SPDX-License-Identifier: MIT
// How does a user move a body in an engine that has no movers? By setting its velocity before each step, as near to the
// wanted motion as possible.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <compare/mover/parts.h>
#include <compare/mover/steered.h>
#include <compare/scene/state.h>

namespace plumb::compare {

/// Does the engine have its own character mover? Some engines have one for capsules.
enum class Characters { None, Capsules };

struct MoverCommand {
    std::size_t body = 0;
    Vec2 velocity{0, 0};                                ///< from now on [m/s]
    std::optional<double> gravityScale = std::nullopt;  ///< also from now on; empty if it does not change [-]
    bool asCharacter = false;                           ///< the engine's own character mover says how far the body goes
};

class SceneMovers {
public:
    explicit SceneMovers(const Scene& scene, Characters characters = Characters::None);

    bool empty() const { return movers_.empty() && agents_.empty(); }
    /// Commands for the next step of dt [s]; states: of the bodies now.
    std::vector<MoverCommand> commands(std::span<const BodyState> states, double dt);

private:
    struct OnPath {
        PathMover mover;
        double delay;
    };
    struct Swinging {
        SwingMotion motion;
        Vec2 start;
    };
    struct Straight {
        Vec2 velocity;
        bool isCharacter;
    };
    struct OnGrid {
        GridMotion motion;
        GridMover mover;
        TurnList turns;
        PlacedMap map;
    };
    /// A dynamic body that cannot turn. Running and the start of a jump set its velocity; gravity makes it fall.
    struct OnPlatforms {
        PlatformMotion motion;
        PlatformProfile profile;
        JumpBand band;
        bool jumpHeld = false;
    };
    struct Mover {
        std::size_t body;
        std::variant<OnPath, Swinging, Straight, OnGrid, OnPlatforms> kind;
    };

    MoverCommand command(OnPath& mover, const BodyState& now, double dt) const;
    MoverCommand command(Swinging& mover, const BodyState& now, double dt) const;
    MoverCommand command(Straight& mover, const BodyState& now, double dt) const;
    MoverCommand command(OnGrid& mover, const BodyState& now, double dt) const;
    MoverCommand command(OnPlatforms& mover, const BodyState& now, double dt) const;

    std::vector<Mover> movers_;
    SteeredAgents agents_;
    double gravity_;  ///< of the scene, downward [m/s^2]
    int tick_ = 0;
};

/// Does the engine's own character mover move the body? Then the body stays kinematic.
bool isCharacter(const Scene& scene, const SceneBody& body, Characters characters);

/// The body as an engine without movers needs it. A body that runs and jumps becomes dynamic and cannot turn; if it has
/// no cues, it keeps its friction and so stands still. A body that slides and stops at obstacles also becomes dynamic
/// and cannot turn, without gravity, unless it is a character.
SceneBody asMoved(const Scene& scene, const SceneBody& body, Characters characters = Characters::None);

}  // namespace plumb::compare
