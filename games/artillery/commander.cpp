// SPDX-License-Identifier: MIT
#include <games/artillery/commander.h>

#include <algorithm>
#include <cmath>

namespace plumb::games::artillery {
namespace {

constexpr int mostTried = 40;        ///< forecasts per turn
constexpr int leastThought = 25;     ///< so that the player sees whose turn it is [ticks]
constexpr double closeEnough = 1.0;  ///< accepted distance from the explosion to the target's outline [m]
constexpr double ownDistance = 4.2;  ///< least distance from the explosion to its own crew [m]
constexpr int thunder = 2;           ///< its index in weapons
constexpr double thunderSpan = 6;    ///< two enemies within this distance are worth a Thunder [m]

/// How valuable a hit on this enemy is, as the extra time of flight that it may cost [s].
double worthOf(const Gunner& enemy) {
    return enemy.health <= 40 ? 3 : enemy.health <= weapons[0].damage ? 2 : 0;
}

double nearestOwn(const Battle& battle, int crew, const Vec2& place) {
    double least = worldEdge;
    for (const Gunner& one : battle.gunners())
        if (one.alive && one.crew == crew) least = std::min(least, distanceToGunner(battle.middleOf(one), place));
    return least;
}

/// Where a shell on this path explodes; empty: in the sea, or not within the forecast.
std::optional<Vec2> endOf(const Forecast& path, const Battle& battle) {
    if (path.hits.empty()) return std::nullopt;
    const Vec2 end = path.poses[static_cast<std::size_t>(path.hits.front().tick)].position;
    return end.y() > battle.sea() ? std::optional(end) : std::nullopt;
}

}  // namespace

Commander::Commander(int crew, const Strength& strength, std::uint64_t seed)
    : crew_(crew), strength_(strength), random_(seed) {}

Orders Commander::decide(const Battle& battle) {
    if (battle.phase() != Phase::Aim || battle.crew() != crew_) return last_ = {};
    if (turn_ != battle.turn()) {
        turn_ = battle.turn();
        tried_ = held_ = 0;
        bestMiss_ = worldEdge;
        best_ = meant_ = wanted_ = std::nullopt;
        last_ = {};
        listed_ = 0;
        choices_.clear();
    }
    if (!wanted_) think(battle);
    if (!wanted_ || battle.phaseTicks() < leastThought) return last_ = {};
    return last_ = steer(battle);
}

void Commander::listChoices(const Battle& battle, const Gunner& enemy) {
    const Vec2 from = battle.middleOf(battle.gunner()), at = battle.middleOf(enemy);
    const double worth = worthOf(enemy) + random_.uniform(0, 2);
    for (const FireSolution& solution : fireSolutions({from, at, battle.wind()}, battle.terrain()))
        choices_.push_back({solution, at, worth - solution.time + std::min(solution.clearance, 2.0) / 2});
}

void Commander::think(const Battle& battle) {
    const std::vector<Gunner>& all = battle.gunners();
    if (listed_ == all.size()) return tryNext(battle);
    // Skip its own crew and the dead.
    while (listed_ < all.size() && (!all[listed_].alive || all[listed_].crew == crew_)) ++listed_;
    if (listed_ < all.size()) listChoices(battle, all[listed_++]);
    const auto worse = [](const Choice& a, const Choice& b) { return a.worth < b.worth; };
    if (listed_ == all.size()) std::stable_sort(choices_.begin(), choices_.end(), worse);
}

void Commander::tryNext(const Battle& battle) {
    if (choices_.empty() || tried_ >= mostTried) return settleOn(best_.value_or(battle.gunner().aim), 0);
    // The best choices are very similar, and one crate may block them all: later tries skip some.
    const std::size_t step = tried_ < 8 ? 1 : 1 + choices_.size() / mostTried;
    const Choice choice = choices_.back();
    choices_.resize(choices_.size() - std::min(step, choices_.size()));
    ++tried_;
    const int ticks = static_cast<int>(choice.solution.time * 60) + 30;
    const std::optional<Vec2> end = endOf(battle.forecastOf(choice.solution.aim, 0, ticks), battle);
    if (!end || nearestOwn(battle, crew_, *end) < ownDistance) return;
    const double miss = distanceToGunner(choice.target, *end);
    if (miss < bestMiss_) {
        bestMiss_ = miss;
        best_ = choice.solution.aim;
    }
    if (miss > closeEnough) return;
    int near = 0;
    for (const Gunner& enemy : battle.gunners())
        if (enemy.alive && enemy.crew != crew_ && (battle.middleOf(enemy) - choice.target).norm() < thunderSpan) ++near;
    const bool worthThunder = near > 1 && battle.roundsLeft(crew_, thunder) != 0;
    settleOn(choice.solution.aim, worthThunder ? thunder : 0);
}

void Commander::settleOn(const Aim& aim, int weapon) {
    meant_ = wanted_ = aim;
    weapon_ = weapon;
    const double turned = 10 * strength_.angleError * random_.uniform(-1, 1);
    const double faster = 1 + strength_.speedError * random_.uniform(-1, 1);
    wanted_->elevation = std::clamp(aim.elevation + static_cast<int>(std::lround(turned)), lowestAim, highestAim);
    // Without an error this is exactly the planned charge.
    wanted_->charge = chargeFor(speedOf(aim.charge) * faster);
}

Orders Commander::steer(const Battle& battle) {
    const Gunner& gunner = battle.gunner();
    if (battle.charging()) return {.fire = gunner.aim.charge < wanted_->charge};
    if (gunner.aim.facing != wanted_->facing) return {.left = wanted_->facing<0, .right = wanted_->facing> 0};
    if (gunner.weapon != weapon_) return {.weapon = !last_.weapon};
    const int way = wanted_->elevation - gunner.aim.elevation;
    if (way == 0) {
        held_ = 0;
        return {.fire = !last_.fire};
    }
    // A long press turns the barrel fast: release it near the end, and finish in small steps.
    if (std::abs(way) < Battle::aimStep(held_)) {
        held_ = 0;
        return {};
    }
    ++held_;
    return {.up = way > 0, .down = way < 0};
}

void Commander::addTo(Hash& hash) const {
    Random next = random_;
    hash.add(next.bits())
        .add(turn_)
        .add(static_cast<int>(listed_))
        .add(tried_)
        .add(static_cast<int>(choices_.size()))
        .add(held_)
        .add(weapon_);
    hash.add(std::uint64_t{buttonsOf(last_)});
    for (const auto& aim : {best_, wanted_})
        if (aim) hash.add(aim->elevation).add(aim->charge).add(aim->facing);
}

}  // namespace plumb::games::artillery
