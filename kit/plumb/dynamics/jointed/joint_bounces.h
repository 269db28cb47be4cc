// SPDX-License-Identifier: MIT
// How do jointed bodies bounce?
//
// A body that moves freely bounces at the moment of contact (see impacts/isolated_impacts.h). The motion of a jointed
// body is constrained by its joints, so it bounces at the start of the sub-step in which it would meet another. The
// pairs are handled one by one, the fastest first, until none approaches, each by the law of all impacts
// (bodies/meeting.h), with the body's whole island as what answers: so five discs on pendulums in a row pass an impact
// from one to the next. Friction is left to the solver.
// Source: sequential impulses: Herrmann, Seitz, "How does the ball-chain work?", Am. J. Phys. 50 (1982) 977.
// Test: "of five hanging discs one swung sends one out, and two send two"
#pragma once
#include <vector>

#include <plumb/dynamics/jointed/joint_solver.h>

namespace plumb {

class JointBounces {
public:
    /// At the start of a step: finds the contacts that bounce and have a jointed body, and keeps the solver from
    /// bouncing them again. Contacts through which an impact may pass from one to the next are in one group: those that
    /// meet at a body, or at bodies of one island. Fixed bodies pass nothing on.
    void take(JointStores& stores, std::span<const JointIsland> islands);
    /// Before contacts are solved, in either half of a sub-step: applies the impulses of those bounces that would meet
    /// in this sub-step.
    void solve(JointStores& stores, JointSolver& joints) const;

private:
    /// A point of a contact, in its present state.
    struct Point {
        ContactIndex contact = none;
        std::size_t number = 0;
        double approach = 0;  ///< [m/s]
    };
    /// A contact, and a body that stands for its group.
    struct Bounce {
        BodyIndex group = noBody;
        ContactIndex contact = none;
    };

    static Point fastest(const JointStores& stores, std::span<const Bounce> group);
    static void bounce(JointStores& stores, JointSolver& joints, const Point& point);

    std::vector<Bounce> found_;  ///< one group after the other
};

}  // namespace plumb
