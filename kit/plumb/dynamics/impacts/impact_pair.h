// SPDX-License-Identifier: MIT
// When do the two shapes of a contact hit each other, and what happens then?
//
// Both bodies move by the closed form of free motion, up to the impact and after it. All in double precision, as in a
// textbook.
#pragma once
#include <array>

#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/impacts/flying_bodies.h>
#include <plumb/impact/detail/meeting.h>

namespace plumb {

/// A contact of two flying bodies: its impacts so far, and when the next one is.
struct ImpactPair {
    ContactIndex contact = 0;
    FlyingIndex a = 0, b = 0;
    std::array<std::uint32_t, 2> next{none, none};  ///< in the lists of A and B
    std::uint32_t prediction = 0;                   ///< number of its newest prediction; older ones do not hold
    std::uint32_t impacts = 0;                      ///< how many it has had in this step
    std::uint32_t outcome = none;                   ///< its entry in the list of outcomes
    bool through = false;                           ///< a rule or a one-way side lets it pass
};

/// What the impacts of a pair were in this step.
struct ImpactOutcome : Meeting {
    Distance where;
};

/// The time of the pair's next impact; empty if there is none before the end of the step at dt [s].
std::optional<double> nextImpact(const ImpactStores& stores, const FlyingBodies& bodies, const ImpactPair& pair,
                                 double dt);
/// May the two pass through each other? If the narrow phase has not predicted the contact, the rules are evaluated
/// here, at the place where the two meet.
bool isLetThrough(const ImpactStores& stores, const FlyingBodies& bodies, const ImpactPair& pair, double time);
/// Moves the two bodies to where they meet and applies the impact. False if they do not meet at that time, because they
/// spin too fast for the search, or overlap deeply; then nothing has changed.
bool solvePair(ImpactStores& stores, FlyingBodies& bodies, const ImpactPair& pair, double time, ImpactOutcome& outcome);
/// Stores the outcome in the contact, and reports it. Impacts faster than hitSpeed [m/s] are hits.
void storeOutcome(ImpactStores& stores, ContactIndex contact, const ImpactOutcome& outcome, double dt, double hitSpeed,
                  TouchEvents& touches);

}  // namespace plumb
