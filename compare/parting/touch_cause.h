// SPDX-License-Identifier: MIT
// What differs between two runs when a body touches another?
#pragma once
#include <utility>

#include <compare/parting/account.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// Finds what a share from a contact is: a hit, a bounce, a way through, a snag, sliding or pressing.
class TouchCause {
public:
    TouchCause(const Parted& parted, const Share& share, const Touching& touching);

    /// True if the change was sudden and the results differ.
    bool isSudden() const;
    void add(Parting& parting) const;

private:
    /// One run around the time of a contact.
    struct Seen {
        double approach = 0, leaving = 0;  ///< towards the other along the normal before, away from it after [m/s]
        double across = 0, along = 0;  ///< the change of the body's speed along the normal and along the surface [m/s]
        double before = 0, after = 0;  ///< the body's speed [m/s]
        Vec2 from{0, 0}, to{0, 0};     ///< its centre, before and after [m]
    };

    Difference kind() const;
    std::size_t lastTick() const;
    std::size_t hitTickIn(const Observation& run) const;
    Seen seenIn(const Observation& run) const;
    bool mayBounce() const;
    bool isPassed(const Seen& through, const Seen& back) const;
    std::pair<double, double> valuesOf(Difference quantity) const;

    const Parted& parted_;
    const Share& share_;
    const Touching& touching_;
    Seen a_, b_;
};

}  // namespace plumb::compare
