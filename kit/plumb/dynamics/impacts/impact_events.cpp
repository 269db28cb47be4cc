// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/impact_events.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/math/logarithm.h>

namespace plumb {

namespace {

/// A pair has at most this many impacts in a step. Each leaves the share e of the speed, the restitution: after n of
/// them, with e^n < lostSpeed, the two rest on each other.
constexpr double lostSpeed = 1e-3, fewestImpacts = 4, mostImpacts = 64;
/// The most predictions in a step of a group of bodies, for each of its pairs, and in addition for a small group.
constexpr std::size_t predictionsPerPair = 32, freePredictions = 2000;

}  // namespace

ImpactEvents::ImpactEvents(const ImpactStores& stores, const ImpactCandidates& candidates, double dt)
    : stores_(stores),
      candidates_(candidates),
      dt_(dt),
      bodies_(stores, dt),
      hasPair_(stores.contacts.records.size(), false),
      reach_(stores, dt) {
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

FlyingIndex ImpactEvents::find(BodyIndex body) {
    const BodyStore& bodies = stores_.bodies;
    const bool sleeps = bodies.isDynamic(body) && !bodies.record[body].awake;
    return bodies_.find(body, sleeps || candidates_.isConstrained(bodies, body));
}

void ImpactEvents::addPair(ContactIndex contact) {
    if (hasPair_.size() <= contact) hasPair_.resize(stores_.contacts.records.size(), false);
    if (hasPair_[contact]) return;
    hasPair_[contact] = true;
    const std::uint32_t number = static_cast<std::uint32_t>(pairs_.size());
    ImpactPair& pair = pairs_.emplace_back();
    pair.contact = contact;
    pair.a = find(stores_.contacts[contact].bodyA);
    pair.b = find(stores_.contacts[contact].bodyB);
    pair.next = {bodies_[pair.a].firstPair, bodies_[pair.b].firstPair};
    bodies_[pair.a].firstPair = bodies_[pair.b].firstPair = number;
    ++bodies_.workOf(payerOf(pair)).pairs;
}

/// Adds all pairs that a body may meet after an impact.
void ImpactEvents::addPairsOf(FlyingIndex number) {
    std::vector<ContactIndex> contacts;
    reach_.extend(bodies_[number], contacts);
    const BodyIndex body = bodies_[number].body;
    forEachContact(stores_.bodies, stores_.contacts, body, [&](ContactIndex contact) {
        if (!letsPass(stores_.contacts[contact].verdict)) addPair(contact);
    });
}

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

bool ImpactEvents::isSpent(const ImpactPair& pair) const {
    const double e = stores_.contacts[pair.contact].restitution;
    double most = e < 1 ? fewestImpacts : mostImpacts;
    if (e > 0 && e < 1) most = std::clamp(logarithm(lostSpeed) / logarithm(e), fewestImpacts, mostImpacts);
    const ImpactWork& work = bodies_.workOf(payerOf(pair));
    return pair.impacts >= most || work.predictions > predictionsPerPair * work.pairs + freePredictions;
}

}  // namespace plumb
