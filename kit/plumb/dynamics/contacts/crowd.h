// SPDX-License-Identifier: MIT
// Which pairs get no contact, because far too many bodies are in one place?
//
// Of n bodies that are made at one point, n^2 / 2 pairs overlap: more than memory holds, for a few thousand. A few
// contacts for each body drive them apart as well. So a pair is left out while both of its bodies overlap deeply with
// many others, which is possible only in such a crowd: in a heap, however dense, no body does with more than two.
// Test: "four hundred bodies that are made at one point get few contacts, and come apart"
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/math/function_ref.h>

namespace plumb {

class Crowd {
public:
    Crowd(ContactStore& contacts, const BodyStore& bodies, const Space& space);

    /// Is the pair to be left out? Then it is noted in ContactStore.leftOut.
    bool leavesOut(const ShiftedShapes& pair);
    /// Calls add for each pair of ContactStore.leftOut that must have a contact now. The others stay there, or are
    /// forgotten because they are apart.
    void takeBack(FunctionRef<void(const ShiftedShapes&)> add);

private:
    /// With how many others does a body overlap deeply?
    struct Overlaps {
        std::uint32_t inContact = 0;  ///< of its contacts, when they were counted
        std::uint32_t added = 0;      ///< number of its contacts that are new in this step
        std::uint32_t counted = 0;    ///< added, at that time
        bool isCounted = false;
    };

    void noteAdded(const ShiftedShapes& pair);
    bool isInside(const ShiftedShapes& pair);
    bool isCrowded(BodyIndex body);
    bool isOne(BodyIndex body) const;
    template <class Visit>
    void forEachOverlap(const Pair& shapes, Visit&& visit) const;
    std::uint32_t overlapsInContact(BodyIndex body) const;
    bool overlap(BodyIndex a, BodyIndex b, const Vec2& shift) const;

    ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    StepList<Overlaps> overlaps_;  ///< of each body, as far as known; empty: none
};

}  // namespace plumb
