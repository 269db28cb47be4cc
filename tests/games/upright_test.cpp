// SPDX-License-Identifier: MIT
// Can the displays of artillery and runner be read on an upright phone?
#include <games/all_games.h>
#include <games/frame/canvas.h>
#include <games/frame/source.h>

#include "catch.h"
#include "games/texts.h"

using namespace plumb;
using namespace plumb::games;

namespace {

constexpr PixelSize phone{390, 534};  ///< what the controls leave of a display of 390 x 844

/// What is wrong with the texts that a round of the computer's shows, looked at now and then.
std::vector<std::string> faultsIn(const GameInfo& game, int ticks) {
    const Painter painter;
    Session session(game, {1, {}, {}});
    const auto computer = computerSource(game);
    for (int tick = 0; tick < ticks; ++tick) {
        session.update(*computer->next(session));
        if (session.screen() != Screen::Play || tick % 10 != 0) continue;
        Canvas canvas(phone);
        session.draw(canvas);
        for (const auto& faults : {plumb::test::textsBelow(canvas.drawing(), painter, hudLayer, 11),
                                   plumb::test::textsOverlapping(canvas.drawing(), painter, hudLayer)})
            if (!faults.empty()) return faults;
    }
    return {};
}

}  // namespace

TEST_CASE("on an upright phone the texts of artillery and runner have at least 11 pixels and lie apart",
          "[games][upright]") {
    for (const GameInfo& game : allGames()) {
        if (game.name != "artillery" && game.name != "runner") continue;
        CAPTURE(game.name);
        CHECK(faultsIn(game, 2500) == std::vector<std::string>{});
    }
}
