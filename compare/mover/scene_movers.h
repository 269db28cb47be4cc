// SPDX-License-Identifier: MIT
// How does a user move a body in an engine that has no movers? By setting its velocity before each step, as near to
// what is wanted as that goes.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/mover/parts.h>

namespace plumb::compare {

/// Has the engine a character mover of its own, as some have for capsules?
enum class Characters { None, Capsules };

struct MoverCommand {
    std::size_t body = 0;
    Vec2 velocity{0, 0};                                ///< from now on [m/s]
    std::optional<double> gravityScale = std::nullopt;  ///< likewise, where it changes [-]
    bool asCharacter = false;                           ///< as far as the engine's own character mover goes that way
};

class SceneMovers {
public:
    explicit SceneMovers(const Scene& scene, Characters characters = Characters::None);

    bool empty() const { return movers_.empty(); }
    /// For a step of dt, from where bodies are now [s].
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
    /// A dynamic body that cannot turn: it runs by its velocity, takes off by one, and falls by gravity.
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
    double gravity_;  ///< of the scene, downward [m/s^2]
    int tick_ = 0;
};

/// Is the body moved by that? Then it stays the kinematic body it is.
bool isCharacter(const Scene& scene, const SceneBody& body, Characters characters);

/// The body as such an engine needs it. One that runs and jumps is dynamic, and cannot turn; one that is told nothing
/// stands there by its friction. So is one that slides and shall be stopped, without gravity, where it is no character.
SceneBody asMoved(const Scene& scene, const SceneBody& body, Characters characters = Characters::None);

}  // namespace plumb::compare
