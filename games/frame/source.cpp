// SPDX-License-Identifier: MIT
#include <games/frame/source.h>

#include <plumb/math/check.h>

namespace plumb::games {
namespace {

class Computer final : public Source {
public:
    explicit Computer(const GameInfo& info) : make_(info.computer) {
        if (!make_) refuse("player", info.name + " has no computer player");
    }

    std::optional<Buttons> next(const Session& session) override {
        if (session.screen() == Screen::Play) return play(session);
        // Pressed in every other tick: a button that stays down is not pressed again.
        const Buttons confirm = session.actions().button("confirm");
        return session.ticks() % 2 == 0 ? confirm : 0;
    }

private:
    Buttons play(const Session& session) {
        if (round_ != session.rounds()) {
            round_ = session.rounds();
            player_ = make_(session.gameSetup());
        }
        return player_->decide(*session.game());
    }

    std::function<std::unique_ptr<Player>(const GameSetup&)> make_;
    std::unique_ptr<Player> player_;
    int round_ = 0;
};

}  // namespace

std::unique_ptr<Source> computerSource(const GameInfo& info) {
    return std::make_unique<Computer>(info);
}

}  // namespace plumb::games
