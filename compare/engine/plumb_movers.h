// SPDX-License-Identifier: MIT
// How do the kit's movers move a scene's bodies in a world of Plumb?
#pragma once
#include <variant>
#include <vector>

#include <compare/engine/plumb_world.h>
#include <compare/mover/parts.h>
#include <compare/mover/steered.h>
#include <plumb/movers/platform_mover.h>

namespace plumb::compare {

class PlumbMovers {
public:
    PlumbMovers(const Scene& scene, const PlumbWorld& made);

    /// To be called before each step of the world.
    void step(World& world, double dt);

private:
    struct OnPath {
        PathMover mover;
        double delay;
        BodyId body;
        double angle;
    };
    struct Swinging {
        SwingMotion motion;
        Vec2 start;
        BodyId body;
        double angle;
    };
    struct Sliding {
        SlidingMotion motion;
        BodyId body;
        Slide last{};
    };
    struct OnGrid {
        GridMotion motion;
        GridMover mover;
        TurnList turns;
        PlacedMap map;
        BodyId body;
    };
    struct OnPlatforms {
        PlatformMotion motion;
        PlatformMover mover;
    };

    void steer(World& world, double dt);
    void step(World& world, OnPath& mover, double dt) const;
    void step(World& world, Swinging& mover, double dt) const;
    void step(World& world, Sliding& mover, double dt) const;
    void step(World& world, OnGrid& mover, double dt) const;
    void step(World& world, OnPlatforms& mover, double dt) const;

    std::vector<std::variant<OnPath, Swinging, Sliding, OnGrid, OnPlatforms>> movers_;
    SteeredAgents agents_;
    std::vector<BodyId> bodies_;  // of the scene
    int tick_ = 0;
};

}  // namespace plumb::compare
