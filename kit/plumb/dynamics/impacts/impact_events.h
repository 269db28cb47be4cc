// SPDX-License-Identifier: MIT
// What happens in a step to bodies that fly about and hit each other? All impacts in the order of time.
//
// Every pair of bodies that may meet has a prediction of its next impact, in a queue. The earliest one is solved, and
// the pairs of its two bodies are predicted again. So the work grows with the number of impacts and with the pairs that
// a body has, not with the size of the crowd.
// Source: Alder and Wainwright, "Studies in molecular dynamics", J. Chem. Phys. 31 (1959) 459; Mirtich, "Impulse-based
// dynamic simulation of rigid body systems", 1996, ch. 2.
//
// The work of a step is bounded: by the number of impacts of one pair, and by the number of predictions for the pairs
// of a group of bodies that have hit each other. A group that needs more is left to the solver, from the start of the
// step: its bodies come to rest on each other, and would bounce infinitely often in a finite time. Each group has a
// bound of its own, so that what happens elsewhere in the world does not change its motion.
#pragma once
#include <queue>

#include <plumb/dynamics/impacts/impact_candidates.h>
#include <plumb/dynamics/impacts/impact_pair.h>
#include <plumb/dynamics/impacts/reach.h>

namespace plumb {

class ImpactEvents {
public:
    ImpactEvents(const ImpactStores& stores, const ImpactCandidates& candidates, double dt);

    /// Solves impact after impact to the end of the step.
    void run();
    /// Is this body moved through the step here, because it was hit, or is it left to the solver?
    bool isMoved(BodyIndex body) const;
    bool isLeft(BodyIndex body) const;
    const std::vector<ImpactPair>& pairs() const { return pairs_; }
    /// Of a pair with impacts.
    const ImpactOutcome& outcomeOf(const ImpactPair& pair) const { return outcomes_[pair.outcome]; }
    /// Stores the bodies' states at the step's end, and adds their trajectories.
    void storeBodies(Trajectories& trajectories) { bodies_.store(trajectories); }

private:
    struct Event {
        double time = 0;
        std::uint32_t pair = 0, prediction = 0;
    };
    /// The order of a queue whose top is the earliest event.
    struct Later {
        bool operator()(const Event& a, const Event& b) const {
            return a.time != b.time ? a.time > b.time : a.pair > b.pair;
        }
    };

    FlyingIndex find(BodyIndex body);
    void addPair(ContactIndex contact);
    void addPairsOf(FlyingIndex body);
    void predict(std::uint32_t pair);
    void predictAll(FlyingIndex body);
    void handle(const Event& event);
    bool solve(ImpactPair& pair, double time);
    void stop(FlyingIndex body, double time);
    /// The body whose group is charged with the work for a pair.
    FlyingIndex payerOf(const ImpactPair& pair) const { return bodies_[pair.a].isDynamic ? pair.a : pair.b; }
    bool spins(const ImpactPair& pair) const;
    bool isSpent(const ImpactPair& pair) const;

    const ImpactStores& stores_;
    const ImpactCandidates& candidates_;
    double dt_;
    FlyingBodies bodies_;
    std::vector<ImpactPair> pairs_;
    std::vector<ImpactOutcome> outcomes_;
    std::vector<bool> hasPair_;  ///< for each contact
    std::priority_queue<Event, std::vector<Event>, Later> queue_;
    Reach reach_;
};

}  // namespace plumb
