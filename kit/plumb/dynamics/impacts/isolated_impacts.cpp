// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/isolated_impacts.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/impacts/impact_candidates.h>
#include <plumb/dynamics/impacts/impact_pair.h>
#include <plumb/dynamics/impacts/reach.h>
#include <plumb/math/logarithm.h>

namespace plumb {

namespace {

/// A pair has at most this many impacts in a step. Each leaves the share e of the speed, the restitution: after n of
/// them, with e^n < lostSpeed [-], the two rest on each other. An elastic pair never comes to rest, so mostImpacts
/// bounds it. Test: "an elastic disc meets each of two walls 64 times in a step, and waits at one if there were more"
constexpr double lostSpeed = 1e-3, fewestImpacts = 4, mostImpacts = 64;
/// The most predictions in a step of a group of bodies, for each of its pairs, and in addition for a small group [-].
/// With fewer, a dense gas would lose energy at lower speeds, because it is left to the solver; with more, its worst
/// step would take longer. Test: "an elastic gas of 49 discs keeps its energy at 10 m/s, and has spent its predictions
/// at 500 m/s"
constexpr std::size_t predictionsPerPair = 32, freePredictions = 2000;

/// The queue, and the pairs and bodies that its events are about. An event is void once its pair was predicted again;
/// it is not searched for in the queue, which would cost O(n), but told by its number when it comes up. So k
/// predictions cost O(k log k).
class ImpactEvents {
public:
    ImpactEvents(ImpactStores& stores, const ImpactCandidates& candidates, double dt);

    /// Solves impact after impact to the end of the step.
    void run();
    /// Is this body moved through the step here, because it was hit, or is it left to the solver?
    bool isMoved(BodyIndex body) const;
    bool isLeft(BodyIndex body) const;
    const StepList<ImpactPair>& pairs() const { return pairs_; }
    /// Of a pair with impacts.
    const ImpactOutcome& outcomeOf(const ImpactPair& pair) const { return outcomes_[pair.outcome]; }
    /// Stores the bodies' states at the step's end, and adds their trajectories.
    void storeBodies(Trajectories& trajectories) { bodies_.store(trajectories); }

private:
    struct Event {
        double time = 0;
        std::uint32_t pair = 0, prediction = 0;
    };
    /// The order of a queue whose top is the earliest event. Of two at the same time, the pair that was made first
    /// comes first, so the result does not depend on how the queue is built.
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

    ImpactStores& stores_;
    const ImpactCandidates& candidates_;
    double dt_;
    FlyingBodies bodies_;
    StepList<ImpactPair> pairs_;
    StepList<ImpactOutcome> outcomes_;
    StepList<std::uint8_t> hasPair_;  ///< for each contact
    std::priority_queue<Event, StepList<Event>, Later> queue_;
    Reach reach_;
};

}  // namespace

ImpactEvents::ImpactEvents(ImpactStores& stores, const ImpactCandidates& candidates, double dt)
    : stores_(stores),
      candidates_(candidates),
      dt_(dt),
      bodies_(stores, dt),
      hasPair_(stores.contacts.records.size(), 0),
      reach_(stores, dt) {
    // At most two bodies for each contact; the pairs grow by those that impacts add.
    pairs_.reserve(2 * candidates.contacts.size());
    bodies_.reserve(2 * candidates.contacts.size());
    for (const ContactIndex contact : candidates.contacts) addPair(contact);
    for (std::uint32_t pair = 0; pair < pairs_.size(); ++pair) predict(pair);
}

void ImpactEvents::run() {
    while (!queue_.empty()) {
        const Event event = queue_.top();
        queue_.pop();
        if (pairs_[event.pair].prediction == event.prediction) handle(event);
    }
}

bool ImpactEvents::isMoved(BodyIndex body) const {
    const FlyingIndex number = bodies_.numberOf(body);
    return number != none && bodies_[number].isHit && !bodies_.isLeft(number);
}

bool ImpactEvents::isLeft(BodyIndex body) const {
    const FlyingIndex number = bodies_.numberOf(body);
    return number != none && bodies_.isLeft(number);
}

/// A sleeping body, and one that the solver moves, are obstacles: what would hit them stops before them, and waits for
/// the next step, in which the contact is the solver's or the sleeper is awake.
FlyingIndex ImpactEvents::find(BodyIndex body) {
    const BodyStore& bodies = stores_.bodies;
    const bool sleeps = bodies.isDynamic(body) && !bodies.record[body].awake;
    return bodies_.find(body, sleeps || candidates_.isConstrained(bodies, body));
}

/// Each contact is added once. A pair is a member of two linked lists through the array, one of each body.
void ImpactEvents::addPair(ContactIndex contact) {
    if (hasPair_.size() <= contact) hasPair_.resize(stores_.contacts.records.size(), 0);
    if (hasPair_[contact] != 0) return;
    hasPair_[contact] = 1;
    const std::uint32_t number = static_cast<std::uint32_t>(pairs_.size());
    ImpactPair& pair = pairs_.emplace_back();
    pair.contact = contact;
    pair.a = find(stores_.contacts[contact].bodyA);
    pair.b = find(stores_.contacts[contact].bodyB);
    pair.next = {bodies_[pair.a].firstPair, bodies_[pair.b].firstPair};
    bodies_[pair.a].firstPair = bodies_[pair.b].firstPair = number;
    ++bodies_.workOf(payerOf(pair)).pairs;
}

/// Adds all pairs that a body may meet after an impact: the contacts that it has, and those that its new path needs,
/// because it leaves the bounds for which contacts were searched.
void ImpactEvents::addPairsOf(FlyingIndex number) {
    StepList<ContactIndex> contacts;
    reach_.extend(bodies_[number], contacts);
    const BodyIndex body = bodies_[number].body;
    forEachContact(stores_.bodies, stores_.contacts, body, [&](ContactIndex contact) {
        if (!letsPass(stores_.contacts[contact].verdict)) addPair(contact);
    });
}

/// Makes the pair's older events void by raising its number. Also a search that finds nothing is work.
void ImpactEvents::predict(std::uint32_t number) {
    ImpactPair& pair = pairs_[number];
    ++pair.prediction;
    ++bodies_.workOf(payerOf(pair)).predictions;
    if (const std::optional<double> time = nextImpact(stores_, bodies_, pair, dt_))
        queue_.push({*time, number, pair.prediction});
}

void ImpactEvents::predictAll(FlyingIndex body) {
    for (std::uint32_t number = bodies_[body].firstPair; number != none;) {
        const ImpactPair& pair = pairs_[number];
        const std::uint32_t next = pair.next[pair.a == body ? 0 : 1];
        predict(number);
        number = next;
    }
}

/// One event: the pair passes through each other; or one of the two cannot take part, and the other stops before it; or
/// their work is spent, and their group is left to the solver; or they bounce, and all pairs of both are predicted
/// again.
void ImpactEvents::handle(const Event& event) {
    ImpactPair& pair = pairs_[event.pair];
    const FlyingIndex a = pair.a, b = pair.b;
    if (isLetThrough(stores_, bodies_, pair, event.time)) {
        pair.through = true;
        return;
    }
    const auto isBlocked = [this](FlyingIndex body) { return bodies_[body].isDynamic && !bodies_.canFly(body); };
    if (isBlocked(a) || isBlocked(b)) {
        for (const FlyingIndex body : {a, b})
            if (bodies_.canFly(body)) stop(body, event.time);
        return;
    }
    bodies_.unite(a, b);
    if (isSpent(pair) || !solve(pair, event.time)) {
        // Of 20,000 pairs of spinning bodies, 7 passed each other when such pairs were left to the solver.
        const bool stay = pair.impacts > 0 && spins(pair);  // the solver might let them pass
        for (const FlyingIndex body : {a, b}) {
            if (stay && bodies_.canFly(body)) stop(body, event.time);
            if (!stay && bodies_[body].isDynamic) bodies_.leaveGroup(body);
        }
        return;
    }
    for (const FlyingIndex body : {a, b})
        if (bodies_[body].isDynamic) addPairsOf(body);
    for (const FlyingIndex body : {a, b})
        if (bodies_[body].isDynamic) predictAll(body);
}

bool ImpactEvents::solve(ImpactPair& pair, double time) {
    if (pair.outcome == none) {
        pair.outcome = static_cast<std::uint32_t>(outcomes_.size());
        outcomes_.emplace_back();
    }
    if (!solvePair(stores_, bodies_, pair, time, outcomes_[pair.outcome])) return false;
    ++pair.impacts;
    return true;
}

/// Others may now meet the body where it waits, so its pairs are predicted as after an impact.
void ImpactEvents::stop(FlyingIndex body, double time) {
    bodies_.stop(body, time);
    addPairsOf(body);
    predictAll(body);
}

/// Is one of two dynamic bodies spinning, or was it when the step began?
bool ImpactEvents::spins(const ImpactPair& pair) const {
    const auto turns = [this](FlyingIndex number) {
        const FlyingBody& body = bodies_[number];
        const double before = stores_.bodies.motion[body.body].angularVelocity, now = body.flight.from.angularVelocity;
        return std::max(std::fabs(before), std::fabs(now)) * dt_ > spinningTurn;
    };
    return bodies_[pair.a].isDynamic && bodies_[pair.b].isDynamic && (turns(pair.a) || turns(pair.b));
}

/// From e^n < lostSpeed: n > ln(lostSpeed) / ln(e). logarithm() has the same bits on all machines.
bool ImpactEvents::isSpent(const ImpactPair& pair) const {
    const double e = stores_.contacts[pair.contact].restitution;
    double most = e < 1 ? fewestImpacts : mostImpacts;
    if (e > 0 && e < 1) most = std::clamp(logarithm(lostSpeed) / logarithm(e), fewestImpacts, mostImpacts);
    const ImpactWork& work = bodies_.workOf(payerOf(pair));
    return pair.impacts >= most || work.predictions > predictionsPerPair * work.pairs + freePredictions;
}

namespace {

/// Takes the contact from the solver for this step: impacts move its bodies, or nothing moved them towards each other.
/// Its stored impulses go, because those of a bounce are no first guess for the next step.
void takeFromSolver(ImpactStores& stores, ContactIndex index) {
    stores.graph.remove(stores.bodies, stores.contacts, index);
    stores.contacts.addNear(index);
    ContactRecord& contact = stores.contacts[index];
    contact.state = ContactState::Impact;
    contact.memory = {};
    contact.rollImpulse = 0;
    stores.contacts.impacts.push_back(index);
}

/// Makes the contacts that were isolated impacts in the last step ordinary near contacts again.
void endImpacts(ContactStore& contacts) {
    for (const ContactIndex index : contacts.impacts)
        if (contacts[index].state == ContactState::Impact) contacts[index].state = ContactState::Near;
    contacts.impacts.clear();
}

/// Does the solver keep this contact? It does if it moves one of the bodies and the other is not moved by impacts.
bool isKept(const ImpactEvents& events, const ContactRecord& contact) {
    const bool moved = events.isMoved(contact.bodyA) || events.isMoved(contact.bodyB);
    return !moved && (events.isLeft(contact.bodyA) || events.isLeft(contact.bodyB));
}

/// Two that only graze each other do not touch.
bool gaveImpulse(const ImpactOutcome& outcome) {
    return static_cast<float>(outcome.normalImpulse) > 0;
}

}  // namespace

/// Called in each step after collide and before solve. Contacts that stay in the solver's slots are solved there; those
/// of impacts that happened are taken out and get their outcome. Candidates whose bodies met nothing are taken out,
/// too: their bodies move on their closed form, and the solver would only find that nothing presses there.
TouchEvents solveIsolatedImpacts(ImpactStores& stores, Trajectories& trajectories, double dt, double hitSpeed) {
    TouchEvents touches;
    endImpacts(stores.contacts);
    const ImpactCandidates candidates = findImpactCandidates(stores.graph, stores.contacts, stores.bodies, dt);
    if (candidates.contacts.empty()) return touches;
    ImpactEvents events(stores, candidates, dt);
    events.run();
    events.storeBodies(trajectories);
    for (const ImpactPair& pair : events.pairs()) {
        const ContactRecord& contact = stores.contacts[pair.contact];
        const bool happened = pair.impacts > 0 && gaveImpulse(events.outcomeOf(pair)) &&
                              !events.isLeft(contact.bodyA) && !events.isLeft(contact.bodyB);
        if (happened || (contact.isSolved() && !isKept(events, contact))) takeFromSolver(stores, pair.contact);
        if (happened) storeOutcome(stores, pair.contact, events.outcomeOf(pair), dt, hitSpeed, touches);
    }
    return touches;
}

}  // namespace plumb
