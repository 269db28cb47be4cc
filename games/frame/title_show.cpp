// SPDX-License-Identifier: MIT
#include <games/frame/title_show.h>

#include <games/frame/menu.h>

namespace plumb::games {
namespace {

constexpr std::int64_t longest = 60 * 60;  ///< of one round [ticks]

}  // namespace

void TitleShow::begin() {
    const GameSetup setup{++seed_, optionsOf(*info_, {})};
    actions_ = ActionList(info_->actions);
    game_ = info_->make(setup);
    player_ = info_->computer ? info_->computer(setup) : nullptr;
    before_ = 0;
    ticks_ = 0;
}

void TitleShow::update() {
    ++ticks_;
    if (info_->drawTitle) return;
    if (!game_ || game_->progress().outcome != Outcome::Running || ticks_ > longest) begin();
    const Buttons buttons = player_ ? player_->decide(*game_) : 0;
    game_->update(Input(*actions_, buttons, before_));
    game_->takeCues();
    before_ = buttons;
}

void TitleShow::draw(Canvas& canvas) const {
    if (info_->drawTitle)
        info_->drawTitle(canvas, static_cast<double>(ticks_) * tickSeconds);
    else if (game_)
        game_->draw(canvas);
}

}  // namespace plumb::games
