// SPDX-License-Identifier: MIT
// On which of its sides does another shape lie along a body? What covers a face lies along it.
//
// Directions count in sectors of the circle. So most corners of a heap are known to be free without a look at their
// shapes and at what their bodies touch.
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// A bit of KeptLanes.open beside floorA and floorB.
inline constexpr std::int32_t seenBit = 4;

/// The value of CornerFaces for a face.
std::uint8_t faceFrom(const Vec2f& normal, const Vec2f& face);

class FlushSides {
public:
    /// Takes the contacts of two points that are in the solver. Sets seenBit in their KeptLanes.
    void gather(ContactGraph& graph, const BodyStore& bodies);
    /// Takes one more contact; normal: in the world, from A to B; moved: since it was last seen.
    void add(BodyIndex a, BodyIndex b, const Vec2f& normal, bool moved);
    /// May something lie along the body?
    bool any(BodyIndex body, bool onlyNew) const { return of(body, onlyNew) != 0; }
    /// May something lie along one of a body's faces? Of bodies that do not move by forces it is not known.
    /// normal: of the contact, in the world, from A to B; onlyNew: nothing did that has not moved since.
    bool mayLieAlong(BodyIndex body, const Vec2f& normal, const std::uint8_t (&faces)[2], bool onlyNew) const;

private:
    struct Sides {
        std::uint64_t all = 0, moved = 0;  ///< a bit a sector
    };
    std::uint64_t of(BodyIndex body, bool onlyNew) const { return onlyNew ? sides_[body].moved : sides_[body].all; }
    void addColour(Colour& colour, bool areKept);

    StepList<Sides> sides_;  ///< by body
};

}  // namespace plumb
