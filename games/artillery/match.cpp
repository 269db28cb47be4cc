// SPDX-License-Identifier: MIT
#include <games/artillery/match.h>

namespace plumb::games::artillery {
namespace {

constexpr int killPoints = 50, stagePoints = 200;
constexpr int bannerTicks = 200;

int stageOf(const std::string& rival) {
    for (std::size_t i = 0; i < stages.size(); ++i)
        if (stages[i].rival == rival) return static_cast<int>(i);
    return 0;
}

}  // namespace

Match::Match(std::uint64_t seed, const std::string& rival)
    : ladder_(rival == "weak-to-strong"),
      rival_(ladder_ ? std::string(stages[0].rival) : rival),
      seeds_(seed),
      stage_(stageOf(rival_)),
      battle_(newBattle()) {
    if (rival_ != "friend") commander_.emplace(1, strengthOf(rival_), seeds_.bits());
}

Battle Match::newBattle() {
    const Stage& stage = stages[static_cast<std::size_t>(stage_)];
    return Battle({.seed = seeds_.bits(), .wind = stage.wind, .tideTurn = stage.tideTurn});
}

std::vector<Happening> Match::update(const Orders& orders) {
    battle_.update(isPersonsTurn() ? orders : commander_->decide(battle_));
    std::vector<Happening> happenings = battle_.takeHappenings();
    for (const Happening& happening : happenings) count(happening);
    if (battle_.phase() == Phase::Over && ++sinceOver_ >= bannerTicks) goOn();
    return happenings;
}

void Match::count(const Happening& happening) {
    if (happening.kind == Happening::Kind::Hurt && happening.crew == 1) score_ += happening.amount;
    if (happening.kind == Happening::Kind::Died && happening.crew == 1) score_ += killPoints;
    if (happening.kind == Happening::Kind::Over && happening.crew == 0) score_ += stagePoints + battle_.healthOf(0);
}

void Match::goOn() {
    const bool won = battle_.winner() == 0;
    if (!won || isLast()) {
        outcome_ = won ? Outcome::Won : Outcome::Lost;
        return;
    }
    ++stage_;
    rival_ = stages[static_cast<std::size_t>(stage_)].rival;
    battle_ = newBattle();
    commander_.emplace(1, strengthOf(rival_), seeds_.bits());
    sinceOver_ = 0;
}

void Match::addTo(Hash& hash) const {
    battle_.addTo(hash);
    if (commander_) commander_->addTo(hash);
    Random next = seeds_;
    hash.add(next.bits()).add(stage_).add(score_).add(sinceOver_).add(static_cast<int>(outcome_));
}

}  // namespace plumb::games::artillery
