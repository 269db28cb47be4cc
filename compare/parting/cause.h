// SPDX-License-Identifier: MIT
// What differed most before two engines parted?
#pragma once
#include <compare/parting/account.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// Fills in what differed most, where, its value in each engine, and when. In this order:
///   a joint that has broken in one run only,
///   an obstacle that it, or a body that joints hold to it, goes through in one run only, sooner or later,
///   gaps of joints that sum to at least half of the distance between the runs; a fifth if the joints are what pulls,
///   else the origin of the largest share of the distance, see sharesOf:
///     a contact: a sudden change, or overlaps that sum to half of the distance, or how the body slid or was pressed,
///     joints: energy, if a law keeps it and its drift explains half of the distance, or how the joints pull,
///     nothing: the speed in flight, or how the steps move the body.
void addCause(const Parted& parted, Parting& parting);

}  // namespace plumb::compare
