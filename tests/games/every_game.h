// SPDX-License-Identifier: MIT
// Which games are tested as all games are?
#pragma once
#include <vector>

#include <games/all_games.h>

namespace plumb::games::walk_through {
GameInfo info();
}

namespace plumb::test {

/// Those of games/list.txt, and the one that games/README.md walks through.
inline std::vector<games::GameInfo> everyGame() {
    std::vector<games::GameInfo> all = games::allGames();
    all.push_back(games::walk_through::info());
    all.back().name = "bounce";
    return all;
}

}  // namespace plumb::test
