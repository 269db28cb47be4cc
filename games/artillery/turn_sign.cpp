// SPDX-License-Identifier: MIT
#include <games/artillery/hud.h>

#include <games/artillery/palette.h>

namespace plumb::games::artillery {
namespace {

constexpr int answerTicks = 95;

std::string doingOf(const Match& match, const std::string& name, const std::string& owner) {
    switch (match.battle().phase()) {
        case Phase::Flight: return owner + " shell flies";
        case Phase::Settle: return owner + " turn ends";
        case Phase::Ready:
        case Phase::Aim: return name + " aim";
        case Phase::Over: break;
    }
    return {};
}

std::string crewName(const Match& match) {
    return std::string(crewNames[match.battle().crew() == 0 ? 0 : 1]);
}

}  // namespace

std::string turnText(const Match& match) {
    const Phase phase = match.battle().phase();
    const bool aims = phase == Phase::Ready || phase == Phase::Aim;
    const std::string name = crewName(match);
    if (match.rival() == "friend")
        return aims ? name + ": your turn" : doingOf(match, "The " + name, "The " + name + "'");
    if (!match.isPersonsTurn()) return doingOf(match, "The " + name, "The " + name + "'");
    return aims ? "Your turn" : doingOf(match, "You", "Your");
}

bool Answer::update(const Match& match, bool pressed) {
    if (left_ > 0) --left_;
    if (match.isPersonsTurn() || match.battle().phase() == Phase::Over)
        left_ = 0;
    else if (pressed) {
        const bool begins = left_ == 0;
        left_ = answerTicks;
        return begins;
    }
    return false;
}

std::string Answer::text(const Match& match) {
    const std::string name = "the " + crewName(match);
    return "Wait: " + doingOf(match, name, name + "'");
}

}  // namespace plumb::games::artillery
