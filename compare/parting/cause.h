// SPDX-License-Identifier: MIT
// What differed most before two engines parted?
#pragma once
#include <compare/parting/account.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// Fills in what differed most, where, how much in each, and when. In this order:
///   a joint that has broken in one run only,
///   gaps or overlaps that come to at least half of the distance between the runs, on the way to what stands still,
///   energy, where a law keeps it, and its drift accounts for that much of the body's way,
///   else what the largest share of the distance comes from: see sharesOf.
void addCause(const Parted& parted, Parting& parting);

}  // namespace plumb::compare
