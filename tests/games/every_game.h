// SPDX-License-Identifier: MIT
// Which games do the tests of all games use?
#pragma once
#include <vector>

#include <games/all_games.h>

namespace plumb::games::walk_through {
GameInfo info();
}

namespace plumb::test {

/// The games of games/list.txt, and the example game of games/README.md.
inline std::vector<games::GameInfo> everyGame() {
    std::vector<games::GameInfo> all = games::allGames();
    all.push_back(games::walk_through::info());
    all.back().name = "bounce";
    return all;
}

}  // namespace plumb::test
