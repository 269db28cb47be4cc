// SPDX-License-Identifier: MIT
// Through which contacts does a light body pass on the load of a heavy one?
//
// A path begins at a point where a heavy body meets a lighter one. The points that hold the light body from the other
// side take shares of the load, so that the body stays at rest, as well as it can. If they belong to a light body
// again, it passes its share on in the same way.
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_point.h>
#include <plumb/dynamics/contacts/lanes/single_lane.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// A contact whose impulses belong to paths.
struct LoadedContact {
    ContactBatch* batch = nullptr;
    std::size_t lane = 0;
    bool isGround = false;    ///< one of its bodies is static or kinematic
    float compliance = 1;     ///< of its spring, as a share of that of a contact of its own effective mass [-]
    ContactImpulses start{};  ///< before this half
};

/// A point of a contact, which carries a share of a load.
struct LoadRow {
    std::uint32_t contact = 0;  ///< its place in LoadPathList.contacts
    std::uint32_t point = 0;    ///< of the contact: 0 or 1
    float share = 0;            ///< [-]

    bool isSamePoint(const LoadRow& o) const { return contact == o.contact && point == o.point; }
};

/// How a unit of load changes the velocity of a body: the changes of x, y and w of SolverVelocity, times the body's
/// mass.
struct LoadEffect : PointAxis {
    BodyIndex body = noBody;

    void add(float share, const PointAxis& o) {
        x += share * o.x;
        y += share * o.y;
        w += share * o.w;
    }
};

struct LoadPath {
    BodyIndex heavy = noBody, light = noBody;
    StepList<LoadRow> rows;  ///< the first one is where the load enters
    StepList<LoadEffect> effects;

    /// By how much a unit of load changes the speeds at the rows, by their shares [1/kg].
    float inverseMass(const BodyStore& bodies) const;
};

/// Paths that share bodies, and all contacts of the light ones among these; as places in a LoadPathList.
struct LoadGroup {
    StepList<std::uint32_t> paths, contacts;
    float ratio = 0;  ///< the largest, of a heavy body's mass to that of a body on its path [-]
};

struct LoadPathList {
    StepList<LoadedContact> contacts;
    StepList<LoadPath> paths;
    StepList<LoadGroup> groups;
};

class LoadPathFinder {
public:
    LoadPathFinder(LoadPathList& list, ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies)
        : list_(list), graph_(graph), contacts_(contacts), bodies_(bodies) {}

    /// Finds all paths of this step. solved: the bodies that the solver moves.
    void findAll(std::span<const BodyIndex> solved);
    /// Finds a path anew, only through points that carry load at present. isRelax: the impulses before this
    /// half still count.
    void findAgain(LoadPath& path, bool isRelax);

private:
    /// A contact at which a heavy body may press on a light one.
    struct Start {
        ContactIndex contact;
        BodyIndex heavy, light;
    };
    /// A point that may hold a body.
    struct Support {
        LoadRow row;
        PointAxis effect;
        BodyIndex other;
    };

    StepList<Start> startsOf(std::span<const BodyIndex> all) const;
    bool isStart(const Start& start) const;
    void leaveOutCrowds(StepList<Start>& starts, std::span<const BodyIndex> solved) const;
    void group();
    std::uint32_t placeOf(ContactIndex contact);
    bool follow(LoadPath& path, const LoadRow& load);
    void passOn(LoadPath& path, BodyIndex body);
    void add(LoadPath& path, const LoadRow& row) const;
    PointAxis effectOn(BodyIndex body, const LoadRow& row) const;
    bool passesOn(const LoadPath& path, BodyIndex body) const;
    void findSupports(const LoadPath& path, BodyIndex body, const LoadEffect& load, bool isLever);
    bool carriesLoad(const LoadedContact& contact, std::uint32_t point, float gap) const;
    float shareOut(LoadEffect kept);

    LoadPathList& list_;
    ContactGraph& graph_;
    const ContactStore& contacts_;
    const BodyStore& bodies_;
    StepMap<ContactIndex, std::uint32_t> places_;  ///< of contacts in the list
    StepList<std::uint32_t> pathOf_;  ///< for each contact in the list: the first path that may use it, or none
    bool onlyLoaded_ = false, isRelax_ = false;

    // Of the path that is followed:
    StepList<BodyIndex> loaded_, passed_;  ///< bodies that carry the load; those that need not do so any more
    StepList<std::uint32_t> seen_;         ///< contacts of the loaded bodies, as places in the list
    StepList<Support> supports_;           ///< of a loaded body
};

}  // namespace plumb
