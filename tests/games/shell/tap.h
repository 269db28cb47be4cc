// SPDX-License-Identifier: MIT
// How does a test press a button?
#pragma once
#include <string>

#include <games/frame/session.h>

namespace plumb::test {

/// Down in one tick and up in the next.
inline void tap(games::Session& session, const std::string& action) {
    session.update(session.actions().button(action));
    session.update(0);
}

}  // namespace plumb::test
