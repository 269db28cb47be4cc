// SPDX-License-Identifier: MIT
// What happens in one level, frame by frame, according to the rules?
#pragma once
#include <array>
#include <bitset>
#include <optional>
#include <span>
#include <vector>

#include <games/maze/house_counters.h>
#include <games/maze/hunter.h>
#include <games/maze/wave_clock.h>

namespace plumb::games::maze {

enum class Happening : std::uint8_t { Dot, Power, HunterCaught, Fruit, FruitShown, FruitGone, PlayerCaught, Cleared };

struct ChaseEvent {
    Happening kind;
    int points = 0;
    Vec2 position{0, 0};  ///< [tiles]
};

/// One level, without pictures, sounds, lives or score. A copy runs independently: the computer player uses
/// copies to look ahead.
class Chase {
public:
    /// The random numbers follow from the seed, and are the same in each life of a level.
    explicit Chase(int level, std::uint64_t seed = 1);

    void beginLifeAfterDeath();
    /// Runs one frame. The player turns in the wanted direction as soon as it can. Does nothing when the player was
    /// caught or the level is cleared.
    void step(std::optional<Direction> wanted);
    std::span<const ChaseEvent> events() const { return events_; }  ///< of the last frame, in order

    const LevelRules& rules() const { return rules_; }
    const GridMover& player() const { return player_; }
    Vec2 playerPosition() const { return player_.position(mazeMap()); }
    const std::array<Hunter, 4>& hunters() const { return hunters_; }
    const Hunter& hunter(Who who) const { return hunters_[indexOf(who)]; }
    const HouseCounters& counters() const { return counters_; }
    HunterMode mode() const { return waves_.mode(); }
    int framesOfWaves() const { return waves_.frames(); }
    bool hasDot(Cell cell) const { return dots_[indexOf(cell)]; }  ///< or a power dot
    int dotsLeft() const { return dotsLeft_; }
    int dotsEaten() const;
    int frightFrames() const { return frightFrames_; }  ///< remaining
    bool frozen() const { return freeze_ > 0; }         ///< a hunter was just caught: only eyes move
    std::optional<Who> justCaught() const;              ///< while frozen
    bool fruitShown() const { return fruitFrames_ > 0; }
    bool playerCaught() const { return catcher_.has_value(); }
    std::optional<Who> catcher() const { return catcher_; }
    bool cleared() const { return dotsLeft_ == 0; }
    int haste() const;  ///< of the chaser: 0, 1 or 2
    Sight sightOf(Who who) const;
    Cell targetOf(Who who) const { return hunter(who).targetFor(sightOf(who)); }
    SpeedPattern speedOf(Who who) const;

    void reseed(std::uint64_t seed) { random_ = Random(seed); }  ///< for a look ahead, which must not know chance
    void addTo(Hash& hash) const;

private:
    static std::size_t indexOf(Who who) { return maze::indexOf(who); }
    static std::size_t indexOf(Cell cell) { return static_cast<std::size_t>(cell.row * columns + cell.column); }

    void fillDots();
    void movePlayer(std::optional<Direction> wanted);
    void eatAt(Cell cell);
    void eatDot(Cell cell, const Tile& tile);
    void eatFruit();
    void frighten();
    void moveHunters();
    void moveEyes();
    void moveHunter(Hunter& hunter);
    void letOut();
    void meet();
    void runClocks();
    void tell(Happening kind, int points, const Vec2& position) { events_.push_back({kind, points, position}); }
    void turnAllBack();

    LevelRules rules_;
    std::uint64_t seed_;
    Random random_;
    std::bitset<std::size_t{columns} * rows> dots_;
    int dotsLeft_ = 0;
    GridMover player_;
    std::array<Hunter, 4> hunters_;
    HouseCounters counters_;
    WaveClock waves_;
    int frightFrames_ = 0, chain_ = 0, freeze_ = 0, fruitFrames_ = 0;
    Who lastCaught_ = Who::Chaser;
    bool hasteOff_ = false;  ///< after a death, until the loner leaves the house
    std::optional<Who> catcher_;
    std::vector<ChaseEvent> events_;
};

}  // namespace plumb::games::maze
