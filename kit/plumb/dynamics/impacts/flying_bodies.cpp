// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/flying_bodies.h>

#include <algorithm>
#include <utility>

namespace plumb {

FlyingBodies::FlyingBodies(ImpactStores& stores, double dt)
    : stores_(stores), dt_(dt), numberOf_(stores.bodies.record.size(), none) {}

/// The table from bodies to numbers is as long as the world has bodies, but only bodies with a pair get a record: in
/// most steps these are few. An obstacle is seen at rest where the step found it: what the solver will do with it is
/// not known yet.
FlyingIndex FlyingBodies::find(BodyIndex body, bool isObstacle) {
    if (numberOf_[body] != none) return numberOf_[body];
    const FlyingIndex number = numberOf_[body] = static_cast<FlyingIndex>(bodies_.size());
    const BodyStore& store = stores_.bodies;
    FlyingBody& added = bodies_.emplace_back();
    added.body = body;
    added.parent = number;
    added.isDynamic = store.isDynamic(body);
    added.isStopped = isObstacle;
    added.flight.localCenter = store.record[body].localCenter;
    added.flight.boundingRadius = store.record[body].boundingRadius;
    added.flight.from = store.motion[body];
    if (isObstacle) {
        added.flight.from.velocity.setZero();
        added.flight.from.angularVelocity = 0;
        return number;
    }
    // Fields that vary in space have no closed form. Their flight was predicted for the whole step, and is predicted
    // again from each impact on.
    added.flight.law = flightLawOf(store, body);
    const std::uint32_t flight = store.step[body].flight;
    if (flight != none && !store.flights[flight].steady) {
        added.fields = static_cast<std::uint32_t>(fields_.size());
        fields_.push_back({{store.flights[flight], stores_.fields.accounts[flight].account}, {}});
    }
    return number;
}

/// The place at the impact needs no correction: the pair meets where the predicted path says. The velocity does,
/// because the impulse is in proportion to it. The flight up to here is integrated again for that, and its part of the
/// energy is entered in the account.
void FlyingBodies::addFieldsAt(FlyingIndex number, BodyMotion& motion, double time) {
    const FlyingBody& body = bodies_[number];
    FlyingFields* fields = fieldsOf(body);
    if (fields == nullptr) return;
    const double duration = time - body.flight.time;
    const FieldFlight done =
        stores_.fields.solver->flightFrom(stores_.fields, stores_.bodies, stores_.space, fields->flight.flight,
                                          body.flight.from, body.flight.time, duration);
    const BodyMotion end = moveFreely(body.flight.from, done.flight.law, duration);
    motion.velocity = end.velocity + done.flight.rest.velocity;
    motion.angularVelocity = end.angularVelocity + done.flight.rest.spin;
    fields->account += done.account;
}

/// From here on, the body's closed form starts at the impact. Predictions made before are void; the queue knows them by
/// their numbers (ImpactPair::prediction).
void FlyingBodies::depart(FlyingIndex number, const BodyMotion& arrived, const BodyMotion& departing, double time) {
    FlyingBody& body = bodies_[number];
    if (!body.isDynamic) return;
    segments_.push_back({body.body, body.flight.from, arrived, body.flight.time, time});
    body.flight.from = departing;
    body.flight.time = time;
    body.isHit = true;
    renewFields(body);
}

/// Predicts the effect of fields again, from the body's present state on.
void FlyingBodies::renewFields(FlyingBody& body) {
    FlyingFields* fields = fieldsOf(body);
    if (fields == nullptr) return;
    fields->flight =
        stores_.fields.solver->flightFrom(stores_.fields, stores_.bodies, stores_.space, fields->flight.flight,
                                          body.flight.from, body.flight.time, dt_ - body.flight.time);
    body.flight.law = fields->flight.flight.law;
}

/// The waiting body is an obstacle at rest for others, so its velocity is kept apart, in waiting_, until the step's
/// end. Its time at rest becomes a segment of its own if walls may move: stopFlights then sees a wall that sweeps over
/// it.
void FlyingBodies::stop(FlyingIndex number, double time) {
    FlyingBody& body = bodies_[number];
    BodyMotion arrived = moveFreely(body.flight.from, body.flight.law, time - body.flight.time);
    addFieldsAt(number, arrived, time);
    segments_.push_back({body.body, body.flight.from, arrived, body.flight.time, time});
    if (!stores_.bodies.kinematic.empty()) segments_.push_back({body.body, arrived, arrived, time, dt_});
    if (FlyingFields* fields = fieldsOf(body)) {
        fields->flight.flight.rest = {};
        fields->flight.account = {};
    }
    body.isHit = body.isStopped = true;
    waiting_.emplace_back(number, arrived);
    body.flight.from = arrived;
    body.flight.from.velocity.setZero();
    body.flight.from.angularVelocity = 0;
    body.flight.time = time;
    body.flight.law = {};
}

bool FlyingBodies::canFly(FlyingIndex number) const {
    const FlyingBody& body = bodies_[number];
    return body.isDynamic && !body.isStopped && !isLeft(number);
}

/// Groups are a union-find: the root is always the lowest number, so that it does not depend on the order of impacts.
FlyingIndex FlyingBodies::first(FlyingIndex number) const {
    while (bodies_[number].parent != number) number = bodies_[number].parent;
    return number;
}

/// Two bodies that hit each other belong together: if one is left to the solver, the other's motion after the impact is
/// void, too. Their work counts together from here on. Fixed bodies do not join groups, or all that meets one floor
/// would.
void FlyingBodies::unite(FlyingIndex a, FlyingIndex b) {
    if (!bodies_[a].isDynamic || !bodies_[b].isDynamic) return;
    const FlyingIndex firstA = first(a), firstB = first(b);
    const FlyingIndex one = std::min(firstA, firstB), other = std::max(firstA, firstB);
    if (one != other) {
        bodies_[one].work.pairs += bodies_[other].work.pairs;
        bodies_[one].work.predictions += bodies_[other].work.predictions;
    }
    bodies_[other].parent = one;
    bodies_[one].isLeft = bodies_[one].isLeft || bodies_[other].isLeft;
    for (FlyingIndex number : {a, b})  // a short path for the next search
        while (bodies_[number].parent != one) number = std::exchange(bodies_[number].parent, one);
}

/// The only place where states are written: until here the world is as it was at the step's start, so a group that is
/// left to the solver needs no undo. Its segments are dropped.
void FlyingBodies::store(Trajectories& trajectories) {
    for (FlyingIndex number = 0; number < bodies_.size(); ++number)
        if (bodies_[number].isHit && !bodies_[number].isStopped && !isLeft(number)) flyToEnd(bodies_[number]);
    for (const auto& [number, end] : waiting_)
        if (!isLeft(number)) storeBody(bodies_[number], end);
    std::erase_if(segments_, [this](const TrajectorySegment& s) { return isLeft(numberOf_[s.body]); });
    if (stores_.observer != nullptr)
        for (const TrajectorySegment& s : segments_)
            if (!isStay(s)) stores_.observer->noteFlight(s.body, s.from, s.to, s.end - s.start);
    trajectories.insert(trajectories.end(), segments_.begin(), segments_.end());
}

void FlyingBodies::flyToEnd(FlyingBody& body) {
    BodyMotion end = moveFreely(body.flight.from, body.flight.law, dt_ - body.flight.time);
    if (const FlyingFields* fields = fieldsOf(body)) {
        end.velocity += fields->flight.flight.rest.velocity;
        end.angularVelocity += fields->flight.flight.rest.spin;
    }
    segments_.push_back({body.body, body.flight.from, end, body.flight.time, dt_});
    storeBody(body, end);
}

/// MovedBy::Impacts tells the solver and free motion not to move the body again.
void FlyingBodies::storeBody(FlyingBody& body, const BodyMotion& end) {
    BodyStore& store = stores_.bodies;
    if (const FlyingFields* fields = fieldsOf(body)) {
        const std::uint32_t flight = store.step[body.body].flight;
        store.flights[flight] = fields->flight.flight;
        FieldAccount& account = stores_.fields.accounts[flight].account;
        account = fields->account;
        account += fields->flight.account;
        if (stores_.observer != nullptr) stores_.observer->noteFieldFlight(flight);
    }
    storeMotion(store, body.body, end);
    store.step[body.body].movedBy = MovedBy::Impacts;
}

}  // namespace plumb
