// SPDX-License-Identifier: MIT
// With which masses do contacts see the bodies of islands, and how do their impulses get to the joints?
//
// The lanes of contacts know nothing of joints: they see a velocity and a mass. A body that joints hold to a heavier
// one is shown to them with the mass with which its island responds (jointed/joint_contacts.h has the method). Their
// impulse then acts on the body's own mass, at its free velocity: what joints add to it is found when they are solved
// again.
// A row at a stop transmits the push of contacts as a held row does, but only while it pushes against them: then it is
// loaded. Which stops are loaded is known from the last solution only. Where the next one shows others, the island has
// changed, and its contacts must be solved again with other masses.
#pragma once
#include <plumb/dynamics/joints/island_numbers.h>

namespace plumb {

/// With which mass and inertia contacts see a body.
struct ContactBody {
    BodyIndex body = noBody;
    double mass = 0;     ///< [kg]
    double inertia = 0;  ///< 0: it cannot turn [kg m^2]
};

class IslandContacts {
public:
    /// At the start of a step: which bodies have contacts, and which islands are heavy, that is, may have to be shown
    /// to contacts as heavier than they are?
    void find(IslandNumbers& numbers, const BodyStore& bodies);
    /// Lets the contacts' first guess act on the free velocities.
    void addFirstGuess(const IslandNumbers& numbers, const BodyStore& bodies) const;
    /// After contacts were solved: adds what they have changed in the bodies' records to the free velocities and to the
    /// next first guess; in some lanes to the present velocities, too. touched: gets the lanes in which there was
    /// something.
    void takeImpulses(const IslandNumbers& numbers, BodyStore& bodies, LaneFlags& touched,
                      const LaneFlags& toPresent) const;

    /// Before contacts are solved: adds the bodies that they shall see with another mass than before. first: in this
    /// step.
    void findBodies(IslandNumbers& numbers, const BodyStore& bodies, bool first, std::vector<ContactBody>& found) const;
    /// The same, before they are solved again, for the islands that have changed.
    void findChangedBodies(IslandNumbers& numbers, const BodyStore& bodies, std::vector<ContactBody>& found) const;
    /// After joints were solved again where contacts have touched them: returns true if an island has changed.
    bool findChanged(const IslandNumbers& numbers, const BodyStore& bodies, const LaneFlags& touched);
    /// For the islands that have changed: notes which stops are loaded. withStops: else none counts.
    void noteLoadedStops(const IslandNumbers& numbers, bool withStops) const;
    bool hasChanged(std::size_t lane) const { return changed_[lane] != 0; }

    std::size_t bytes() const { return bytesOf(touching_); }

private:
    /// A body with contacts.
    struct Touching {
        std::uint32_t node = 0, lane = 0;
        BodyIndex body = noBody;
    };

    std::vector<Touching> touching_;
    LaneFlags changed_{};  ///< of heavy islands: other stops are loaded than those with which contacts were solved
};

/// May the contacts of an island have to be solved again?
inline bool mayChange(const IslandNumbers& numbers, std::size_t lane) {
    return numbers.heavy[lane] != 0 && numbers.layout->someFree;
}
/// A contact pushes a body in this direction.
inline void addNormal(const IslandNumbers& numbers, std::size_t lane, std::size_t node, const Vec2& normal) {
    numbers.body(node, BodyField::NormalX, lane) += normal.x();
    numbers.body(node, BodyField::NormalY, lane) += normal.y();
}

}  // namespace plumb
