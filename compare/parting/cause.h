// SPDX-License-Identifier: MIT
// What differed most before two engines parted?
#pragma once
#include <compare/parting/account.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// Fills in what differed most, where, how much in each, and when. In this order:
///   a joint that has broken in one run only,
///   gaps of joints that come to at least half of the distance between the runs; a fifth, where the joints pull,
///   else what the largest share of the distance comes from, see sharesOf:
///     a touch: what came at once, or overlaps that come to half of the distance, or how it slid or was pressed,
///     joints: energy, where a law keeps it, and its drift accounts for half of the distance, or how they pull,
///     nothing: the speed in flight, or how the steps place it.
void addCause(const Parted& parted, Parting& parting);

}  // namespace plumb::compare
