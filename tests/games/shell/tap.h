// SPDX-License-Identifier: MIT
// What does a player press?
#pragma once
#include <string>

#include <games/frame/session.h>

namespace plumb::test {

/// Down in one frame and up in the next.
inline void tap(games::Session& session, const std::string& action) {
    session.update(session.actions().button(action));
    session.update(0);
}

}  // namespace plumb::test
