// SPDX-License-Identifier: MIT
// How does a light body carry a heavy one?
//
// A pass over the contacts changes an impulse between two bodies by what stops the lighter one. A crate of a ton that
// falls on a plank of a kilogram stops the plank; the ground stops it again, and the crate goes on almost as before.
// So for each point where a heavy body hits a lighter one, or rests on a much lighter one, the solver knows the path
// of the load: an impulse there, and those with which the contacts behind the light body keep it at rest. All impulses
// of a path change together, until the sum of their errors, by their shares, is zero:
//   dP = -sum d_i (v_i + bias_i + c_i P_i) / (sum m |e|^2 + sum c_i d_i^2), as far as each P_i stays >= 0
// d share of a point, v speed at which it opens [m/s], P its impulse [N s], c compliance of its spring [1/kg], e effect
// on a body of inverse mass m [1/kg] This is one more direction in which to look for the lowest point of the same
// function that the passes over single contacts make smaller. So a path need not be exact. But it must move the heavy
// body: shares that press it from both sides cancel, and would be divided by almost nothing.
//
// The contacts of the light bodies are solved here, and hidden from the lanes: their springs are as firm as the load
// needs; those in the lanes are as firm as the light body needs. Their passes repeat until they change little.
// Tried and lost: paths along tangents, too. Crates of 1000 times the mass then stood on slopes of 0.5 rad, but of 400
// random heaps of light bodies under heavy ones, 20 burst. With at most 8 passes, 6 of 3000 burst.
// Tests: "a crate that falls on a loose plank stops there", "a large box on two small ones comes to rest level"
#pragma once
#include <plumb/dynamics/loads/load_path_finder.h>

namespace plumb {

class LoadPaths {
public:
    /// Finds the paths of this step. solved: the bodies that the solver moves.

    LoadPaths(ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies, std::span<const BodyIndex> solved,
              const ContactPasses& passes);

    /// Before ContactSolver::solve or relax: hides the contacts from it.
    void begin();
    /// After ContactSolver::solve.
    void solve();
    /// After ContactSolver::relax.
    void relax();
    /// At the step's end: impulses of a hit are not a first guess for the next step.
    void end();

private:
    /// A step along a path.
    struct Change {
        float wanted = 0, least = 0;  ///< [N s]
    };
    /// What lanes must not see of a contact.
    struct Hidden {
        float normalMass[2], tangentMass[2], separation[2];
        float rollMass;
    };

    void hide(std::size_t contact);
    void show(std::size_t contact, bool isRelax);
    template <class SolveContact>
    void repeat(bool isRelax, SolveContact&& solveContact);
    template <class SolveContact>
    bool pass(const LoadGroup& group, bool isRelax, SolveContact&& solveContact);
    const ContactPass& passOf(const LoadedContact& contact) const;
    float complianceOf(const LoadedContact& contact) const;
    ContactPass firmPassOf(const LoadedContact& contact) const;
    bool correct(LoadPath& path, bool isRelax);
    Change changeToSolve(const LoadPath& path, float inverseMass) const;
    Change changeToRelax(const LoadPath& path, float inverseMass) const;
    float speedAlong(const LoadPath& path) const;
    float impulseAt(const LoadRow& row, bool isRelax) const;
    void push(const LoadPath& path, float load, bool isRelax);

    BodyStore& bodies_;
    ContactPasses passes_;
    LoadPathList list_;
    LoadPathFinder finder_;
    StepList<Hidden> hidden_;  ///< parallel to the list's contacts
};

}  // namespace plumb
