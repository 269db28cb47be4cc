// SPDX-License-Identifier: MIT
// What happens in a level while it is played?
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <games/frame/hash.h>
#include <games/runner/event.h>
#include <games/runner/feel.h>
#include <games/runner/level.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>
#include <plumb/movers/platform_mover.h>

namespace plumb::games::runner {

inline const Vec2 heroHalf{0.36, 0.45};      ///< [m]
inline const Vec2 walkerHalf{0.42, 0.38};    ///< of snuffers and burrs [m]
inline constexpr double mothRadius = 0.36;   ///< [m]
inline constexpr double crateHalf = 0.48;    ///< [m]
inline constexpr double platformHalf = 0.2;  ///< half its thickness [m]

struct Hero {
    PlatformMover mover;
    bool tall = true;  ///< a tall flame survives one hurt
    bool alive = true;
    int facing = 1;
    int safeTicks = 0;     ///< how long nothing can hurt it
    int chain = 0;         ///< number of stomps since it left the floor
    double fallSpeed = 0;  ///< in the tick before [m/s]
};

/// A snuffer or a burr.
struct Walker {
    BodyId body;
    bool thorny = false;
    int direction = -1;
    Slide slide{};
    bool alive = true;
    int deadTicks = 0;
};

struct Moth {
    BodyId body;
    PathMover path;
    std::int64_t phase = 0;  ///< [ticks]
    bool alive = true;
    int deadTicks = 0;
};

struct Lift {
    BodyId body;
    PathMover path;
    std::int64_t phase = 0;  ///< [ticks]
    double width = 3;        ///< [m]
};

struct Spring {
    ShapeId shape;
    Vec2 at{0, 0};          ///< the middle of its base
    int ticksSince = 1000;  ///< since it last threw the hero
};

struct Crate {
    BodyId body;
};

struct Lantern {
    Vec2 at{0, 0};
    bool lit = false;
};

/// A coin, a sun or a drop of oil.
struct Treasure {
    ThingKind kind = ThingKind::Coin;
    Vec2 at{0, 0};
    bool taken = false;
    int number = 0;  ///< counted within its kind, from 0
};

struct StageSetup {
    std::string profile = "modern";
    std::uint64_t seed = 1;  ///< for start phases, the walkers' places and directions, and lamp contents
};

/// A copy continues exactly like the original. The computer player tries its moves on copies.
class Stage {
public:
    Stage(std::shared_ptr<const Level> level, const StageSetup& setup);

    void update(const PlatformInput& input);  ///< one tick
    /// Starts again, but keeps broken tiles, taken treasures and lit lanterns. The hero starts at the last lit lantern.
    void beginAgain();
    /// Whether events are recorded; a copy that only looks ahead does not need them.
    void keepEvents(bool keep) { keepsEvents_ = keep; }

    const std::vector<Event>& events() const { return events_; }  ///< of the last tick
    bool isOver() const { return finished_ || !hero_.alive; }
    bool isFinished() const { return finished_; }
    std::int64_t ticks() const { return ticks_; }  ///< since the last start
    double tick() const { return feel_.tick; }     ///< [s]
    std::uint64_t hash() const;

    const Level& level() const { return *level_; }
    const World& world() const { return world_; }
    const TileMap& tiles() const { return world_.tiles(ground_); }  ///< with all changes since the start
    const Hero& hero() const { return hero_; }
    Vec2 heroAt() const { return std::as_const(world_).body(hero_.mover.body()).position(); }
    const std::vector<Walker>& walkers() const { return walkers_; }
    const std::vector<Moth>& moths() const { return moths_; }
    const std::vector<Lift>& lifts() const { return lifts_; }
    const std::vector<Spring>& springs() const { return springs_; }
    const std::vector<Crate>& crates() const { return crates_; }
    const std::vector<Lantern>& lanterns() const { return lanterns_; }
    const std::vector<Treasure>& treasures() const { return treasures_; }
    int ticksSinceBump(Cell cell) const;  ///< 1000 if there was none lately; for the picture

private:
    struct Bump {
        Cell cell;
        std::int64_t tick;
    };

    // stage_build.cpp
    void build(const TileMap& tiles);
    void add(const Thing& thing);
    void addWalker(const Thing& thing);
    void addMoth(const Vec2& at);
    void addSpring(const Vec2& at);
    void addCrate(const Vec2& at);
    void addLift(const Platform& platform);
    PlatformMover heroMover(const Vec2& at);
    std::int64_t phaseOf(const PathMover& path);

    // stage_foes.cpp
    void moveLifts();
    void moveWalkers();
    void walk(Walker& walker);
    void moveMoths();
    void meetFoes(const PlatformInput& input);
    void squashByCrates();
    void knock(Cell cell);  ///< squashes walkers on top of it
    void squash(Walker& walker);
    // stage.cpp
    void moveHero(const PlatformInput& input);
    void meetFloor();
    void meetHits();
    void bump(Cell cell);
    void stomp(const Vec2& at, const PlatformInput& input);
    void takeTreasures();
    void meetPlaces();
    void throwUp(double height);
    void hurt();
    void die();
    void note(EventKind kind, const Vec2& at, double strength = 0);
    bool isNear(const Vec2& at) const;

    std::shared_ptr<const Level> level_;
    StageSetup setup_;
    Feel feel_;
    Random random_{0};
    World world_;
    ShapeId ground_;
    Hero hero_{PlatformMover{BodyId{}}};
    std::vector<Walker> walkers_;
    std::vector<Moth> moths_;
    std::vector<Lift> lifts_;
    std::vector<Spring> springs_;
    std::vector<Crate> crates_;
    std::vector<Lantern> lanterns_;
    std::vector<Treasure> treasures_;
    std::vector<Bump> bumps_;
    std::vector<Event> events_;
    bool keepsEvents_ = true;
    bool finished_ = false;
    std::int64_t ticks_ = 0;
};

}  // namespace plumb::games::runner
