// SPDX-License-Identifier: MIT
// What differs in two runs where a body touches another?
#pragma once
#include <compare/parting/account.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// Fills in what a share that comes from a touch is: a hit, a bounce, a way through, a snag, sliding or pressing.
void addTouchCause(const Parted& parted, const Share& share, const Touching& touching, Parting& parting);

}  // namespace plumb::compare
