// SPDX-License-Identifier: MIT
#include <games/runner/stage.h>

#include <algorithm>
#include <cmath>

#include <plumb/record/state_hash.h>

namespace plumb::games::runner {
namespace {

constexpr double springRise = 7.2, thornRise = 1.6;  ///< how high the hero is thrown [m]
constexpr double lanternReach = 6;                   ///< above it: a jump over it lights it, too [m]
constexpr int safeAfterHurt = 100;                   ///< [ticks]
constexpr double skidSpeed = 4;                      ///< [m/s]
constexpr int bumpTicks = 20;                        ///< how long a bump is remembered

bool isThorns(const TileMap& tiles, const std::optional<Cell>& cell) {
    return cell && tiles.at(*cell).kind == TileKind::Hazard;
}

}  // namespace

void Stage::update(const PlatformInput& input) {
    events_.clear();
    if (isOver()) return;
    moveLifts();
    moveWalkers();
    moveMoths();
    moveHero(input);
    world_.step(feel_.tick);
    ++ticks_;
    meetFloor();
    meetHits();
    squashByCrates();
    meetFoes(input);
    takeTreasures();
    meetPlaces();
    std::erase_if(bumps_, [&](const Bump& bump) { return bump.tick + bumpTicks < ticks_; });
}

void Stage::moveHero(const PlatformInput& input) {
    PlatformMover& mover = hero_.mover;
    const bool wasOnFloor = mover.slide().isOnFloor;
    hero_.fallSpeed = wasOnFloor ? 0 : -mover.slide().velocity.y();
    const Slide& slide = mover.step(world_, input, feel_.tick);
    if (input.move != 0) hero_.facing = input.move < 0 ? -1 : 1;
    if (hero_.safeTicks > 0) --hero_.safeTicks;
    if (mover.hasJumped()) note(EventKind::Jumped, heroAt());
    if (!wasOnFloor && slide.isOnFloor)
        note(EventKind::Landed, slide.position - Vec2(0, heroHalf.y()), hero_.fallSpeed);
    if (slide.isOnFloor) hero_.chain = 0;
    if (slide.isOnFloor && input.move * slide.velocity.x() < -skidSpeed && ticks_ % 4 == 0)
        note(EventKind::Skidded, slide.position - Vec2(0, heroHalf.y()), input.move);
}

void Stage::meetFloor() {
    const Slide& slide = hero_.mover.slide();
    if (!slide.isOnFloor || !slide.floor) return;
    for (Spring& spring : springs_) {
        if (spring.shape != slide.floor->shape) continue;
        spring.ticksSince = 0;
        note(EventKind::Sprung, spring.at);
        return throwUp(springRise);
    }
    if (slide.floor->shape == ground_ && isThorns(tiles(), slide.floor->tile)) hurt();
}

void Stage::meetHits() {
    for (const SlideHit& hit : hero_.mover.slide().hits) {
        if (hit.shape != ground_ || !hit.tile) continue;
        if (isThorns(tiles(), hit.tile)) hurt();
        if (hit.normal.y() < -0.7 && hit.effect != SlideEffect::Nudged) bump(*hit.tile);
    }
}

void Stage::bump(Cell cell) {
    Tile tile = tiles().at(cell);
    const Vec2 at = tiles().centerOf(cell);
    if (tile.tag == Ground) return;
    bumps_.push_back({cell, ticks_});
    knock(cell);
    if (tile.tag == SpentLamp) return note(EventKind::Bumped, at);
    if (tile.tag == Brick) {
        world_.setTile(ground_, cell, {});
        return note(EventKind::BrickBroke, at);
    }
    tile.tag = SpentLamp;
    world_.setTile(ground_, cell, tile);
    const int inside = random_.integer(0, 3);
    if (inside == 0) hero_.tall = true;
    note(EventKind::LampLit, at, inside);
}

void Stage::takeTreasures() {
    const Vec2 at = heroAt();
    for (Treasure& treasure : treasures_) {
        const double reach = treasure.kind == ThingKind::Sun ? 1.0 : 0.85;
        if (treasure.taken || std::fabs(treasure.at.x() - at.x()) > reach ||
            std::fabs(treasure.at.y() - at.y()) > reach)
            continue;
        treasure.taken = true;
        if (treasure.kind == ThingKind::Oil) hero_.tall = true;
        const EventKind kind = treasure.kind == ThingKind::Coin  ? EventKind::Coin
                               : treasure.kind == ThingKind::Sun ? EventKind::Sun
                                                                 : EventKind::Oil;
        note(kind, treasure.at, treasure.number);
    }
}

void Stage::meetPlaces() {
    const Vec2 at = heroAt();
    const auto isAt = [&](const Vec2& place, double width, double up) {
        return std::fabs(place.x() - at.x()) < width && at.y() > place.y() - 1.5 && at.y() < place.y() + up;
    };
    for (std::size_t i = 0; i < lanterns_.size(); ++i) {
        if (lanterns_[i].lit || !isAt(lanterns_[i].at, 0.8, lanternReach)) continue;
        for (std::size_t before = 0; before <= i; ++before) lanterns_[before].lit = true;
        hero_.tall = true;
        note(EventKind::LanternLit, lanterns_[i].at);
    }
    if (tiles().at(tiles().cellAt(at)).kind == TileKind::Sensor || at.y() < -1.5 || hero_.mover.slide().crushed) die();
    if (hero_.alive && isAt(level_->beacon, 0.7, 2.5)) {
        finished_ = true;
        note(EventKind::Finished, level_->beacon);
    }
    for (Spring& spring : springs_) ++spring.ticksSince;
    for (std::size_t i = crates_.size(); i-- > 0;) {
        if (world_.body(crates_[i].body).position().y() > -6) continue;
        world_.remove(crates_[i].body);
        crates_.erase(crates_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void Stage::throwUp(double height) {
    PlatformMover& mover = hero_.mover;
    mover.launch({mover.slide().velocity.x(), speedToRise(mover.profile(), height)});
}

void Stage::hurt() {
    if (hero_.safeTicks > 0 || !hero_.alive) return;
    if (!hero_.tall) return die();
    hero_.tall = false;
    hero_.safeTicks = safeAfterHurt;
    note(EventKind::Hurt, heroAt());
    throwUp(thornRise);
}

void Stage::die() {
    if (!hero_.alive) return;
    hero_.alive = false;
    note(EventKind::Died, heroAt());
}

void Stage::note(EventKind kind, const Vec2& at, double strength) {
    if (keepsEvents_) events_.push_back({kind, at, strength});
}

int Stage::ticksSinceBump(Cell cell) const {
    for (const Bump& bump : bumps_)
        if (bump.cell == cell) return static_cast<int>(ticks_ - bump.tick);
    return 1000;
}

std::uint64_t Stage::hash() const {
    Hash hash;
    hash.add(ticks_).add(finished_).add(hero_.tall).add(hero_.alive).add(hero_.safeTicks).add(hero_.chain);
    hash.add(hero_.facing).add(hero_.mover.slide().velocity.x());
    hash.add(hero_.mover.slide().velocity.y()).add(Random(random_).bits());
    for (const Walker& walker : walkers_) hash.add(walker.alive).add(walker.direction);
    for (const Moth& moth : moths_) hash.add(moth.alive);
    for (const Lantern& lantern : lanterns_) hash.add(lantern.lit);
    for (const Treasure& treasure : treasures_) hash.add(treasure.taken);
    for (int row = 0; row < tiles().rows(); ++row)
        for (int column = 0; column < tiles().columns(); ++column)
            hash.add(std::uint64_t{tiles().at({column, row}).tag} * 16 +
                     static_cast<std::uint64_t>(tiles().at({column, row}).form));
    return hash.add(stateHash(world_)).value();
}

}  // namespace plumb::games::runner
