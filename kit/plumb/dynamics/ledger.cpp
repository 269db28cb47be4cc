// SPDX-License-Identifier: MIT
#include <plumb/dynamics/ledger.h>

namespace plumb {

Vec2 MomentumLedger::gained() const {
    return edits + gravity + fields + forces + ground + damping + solver;
}

}  // namespace plumb
