// SPDX-License-Identifier: MIT
#include <games/maze/chase.h>

#include <algorithm>
#include <cmath>

namespace plumb::games::maze {
namespace {

const ArcadeProfile arcade;
constexpr int freezeFrames = 60;  ///< long enough to read the points
GridMover newPlayer() {
    return GridMover({.cell = playerStart.cell,
                      .offset = playerStart.offset,
                      .heading = Direction::Left,
                      .cornering = arcade.cornering,
                      .pixelsPerTile = arcade.pixelsPerTile});
}

std::array<Hunter, 4> newHunters() {
    return {Hunter(Who::Chaser), Hunter(Who::Ambusher), Hunter(Who::Flanker), Hunter(Who::Loner)};
}

}  // namespace

Chase::Chase(int level, std::uint64_t seed)
    : rules_(rulesOf(level)),
      seed_(Random(seed ^ static_cast<std::uint64_t>(level) << 32).bits()),
      random_(seed_),
      player_(newPlayer()),
      hunters_(newHunters()) {
    fillDots();
}

void Chase::fillDots() {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            dots_[indexOf({column, row})] = (mazeMap().at({column, row}).tag & (dotTag | powerTag)) != 0;
    dotsLeft_ = static_cast<int>(dots_.count());
}

void Chase::beginLifeAfterDeath() {
    random_ = Random(seed_);
    player_ = newPlayer();
    hunters_ = newHunters();
    counters_.beginLifeAfterDeath();
    waves_ = {};
    frightFrames_ = chain_ = freeze_ = fruitFrames_ = 0;
    hasteOff_ = true;
    catcher_.reset();
    events_.clear();
}

void Chase::step(std::optional<Direction> wanted) {
    events_.clear();
    if (playerCaught() || cleared()) return;
    if (freeze_ > 0) {
        --freeze_;
        return moveEyes();
    }
    movePlayer(wanted);
    if (cleared()) return;
    moveHunters();
    meet();
    runClocks();
}

void Chase::movePlayer(std::optional<Direction> wanted) {
    if (wanted)
        player_.want(*wanted);
    else
        player_.wantNothing();
    const Cell before = player_.cell();
    player_.moveFrame(mazeMap(), patternOf(frightFrames_ > 0 ? rules_.speeds.playerFright : rules_.speeds.player));
    if (!(player_.cell() == before)) eatAt(player_.cell());
    if (fruitShown()) eatFruit();
}

void Chase::eatAt(Cell cell) {
    if (!hasDot(cell)) return;
    dots_[indexOf(cell)] = false;
    --dotsLeft_;
    eatDot(cell, mazeMap().at(cell));
}

void Chase::eatDot(Cell cell, const Tile& tile) {
    const bool power = has(tile, powerTag);
    player_.pauseFrames(power ? arcade.energizerStall : arcade.dotStall);
    tell(power ? Happening::Power : Happening::Dot, power ? arcade.energizerPoints : arcade.dotPoints,
         mazeMap().centerOf(cell));
    Waiting waiting{};
    for (const Who who : everyone) waiting[indexOf(who)] = hunter(who).where() == Where::Home;
    counters_.dotEaten(waiting);
    if (power) frighten();
    const auto& after = arcade.fruitAfter;
    if (std::find(after.begin(), after.end(), dotsEaten()) != after.end()) {
        fruitFrames_ = random_.integer(framesIn(arcade.fruitTime[0]), framesIn(arcade.fruitTime[1]));
        tell(Happening::FruitShown, 0, positionOf(fruitPlace));
    }
    if (cleared()) tell(Happening::Cleared, 0, playerPosition());
}

void Chase::eatFruit() {
    const Vec2 place = positionOf(fruitPlace);
    const Vec2 away = playerPosition() - place;
    if (away.y() != 0 || std::fabs(away.x()) > 0.5) return;
    fruitFrames_ = 0;
    tell(Happening::Fruit, rules_.fruit.points, place);
}

void Chase::frighten() {
    turnAllBack();
    if (rules_.frightFrames == 0) return;
    frightFrames_ = rules_.frightFrames;
    chain_ = 0;
    for (Hunter& hunter : hunters_)
        if (hunter.where() != Where::Eyes && hunter.where() != Where::Entering) hunter.takeFright();
}

void Chase::turnAllBack() {
    for (Hunter& hunter : hunters_) hunter.turnBack();
}

void Chase::moveHunters() {
    letOut();
    for (Hunter& hunter : hunters_) moveHunter(hunter);
}

void Chase::moveEyes() {
    for (Hunter& hunter : hunters_) {
        const bool waits = freeze_ > 0 && hunter.who() == lastCaught_;  // its points are still shown
        const bool eyes = hunter.where() == Where::Eyes || hunter.where() == Where::Entering;
        if (eyes && !waits) moveHunter(hunter);
    }
}

void Chase::moveHunter(Hunter& hunter) {
    const Who who = hunter.who();
    hunter.step(sightOf(who), speedOf(who), random_);
}

void Chase::letOut() {
    Waiting waiting{};
    for (const Who who : everyone) waiting[indexOf(who)] = hunter(who).where() == Where::Home;
    const std::optional<Who> next = counters_.next(waiting, rules_);
    if (!next) return;
    hunters_[indexOf(*next)].letOut();
    if (*next == Who::Loner) hasteOff_ = false;
}

/// A hunter meets the player if both are in the same cell after both have moved. If they swap cells in one frame, they
/// pass through each other.
void Chase::meet() {
    for (Hunter& hunter : hunters_) {
        if (!hunter.canMeet() || !(hunter.cell() == player_.cell())) continue;
        if (!hunter.frightened()) {
            catcher_ = hunter.who();
            return tell(Happening::PlayerCaught, 0, playerPosition());
        }
        hunter.beCaught();
        lastCaught_ = hunter.who();
        freeze_ = freezeFrames;
        tell(Happening::HunterCaught, arcade.hunterPoints[static_cast<std::size_t>(std::min(chain_++, 3))],
             hunter.position());
        return;
    }
}

void Chase::runClocks() {
    if (fruitFrames_ > 0 && --fruitFrames_ == 0) tell(Happening::FruitGone, 0, positionOf(fruitPlace));
    if (frightFrames_ == 0) {
        if (waves_.step(rules_.waves)) turnAllBack();
        return;
    }
    if (--frightFrames_ > 0) return;
    for (Hunter& hunter : hunters_) hunter.takeHeart();
}

std::optional<Who> Chase::justCaught() const {
    if (freeze_ == 0) return std::nullopt;
    return lastCaught_;
}

int Chase::dotsEaten() const {
    return arcade.dots + arcade.energizers - dotsLeft_;
}

int Chase::haste() const {
    if (hasteOff_ || dotsLeft_ > rules_.hasteDots) return 0;
    return dotsLeft_ > rules_.hasteDots / 2 ? 1 : 2;
}

Sight Chase::sightOf(Who who) const {
    const bool restless = who == Who::Chaser && haste() > 0;
    return {player_.cell(), player_.heading(), hunter(Who::Chaser).cell(), mode() == HunterMode::Scatter && !restless};
}

SpeedPattern Chase::speedOf(Who who) const {
    const Hunter& one = hunter(who);
    const bool slow = isSlow(specialPlaces(), one.cell());
    return patternOf(hunterPercent(rules_.speeds, slow, one.frightened(), who == Who::Chaser ? haste() : 0));
}

void Chase::addTo(Hash& hash) const {
    const Vec2 at = playerPosition();
    hash.add(rules_.level).add(at.x()).add(at.y()).add(static_cast<int>(player_.heading()));
    for (int row = 0; row < rows; ++row) {
        std::uint64_t bits = 0;
        for (int column = 0; column < columns; ++column) bits = bits << 1 | (hasDot({column, row}) ? 1u : 0u);
        hash.add(bits);
    }
    for (const Hunter& hunter : hunters_) hunter.addTo(hash);
    counters_.addTo(hash);
    hash.add(waves_.frames()).add(frightFrames_).add(chain_).add(freeze_).add(fruitFrames_);
    hash.add(hasteOff_).add(playerCaught()).add(Random(random_).bits());
}

}  // namespace plumb::games::maze
