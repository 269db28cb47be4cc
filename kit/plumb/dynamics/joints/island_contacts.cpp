// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_contacts.h>

#include <algorithm>

namespace plumb {

namespace {

/// May a body that contacts touch be held to something that is much heavier than it is? Contacts that see it as up to
/// 60 times too light rest all the same (tried), but gain or lose energy when they land. Machines with stops or springs
/// would have to be asked in each half: twice the time for a heap of dolls (tried), so they are asked later.
bool isHeavy(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane) {
    const JointIsland& island = *numbers.islands[lane];
    const double heavy = numbers.layout->someFree ? 30 : 8;
    double mass = 0, lightest = unlimited;
    for (const BodyIndex body : island.bodies) {
        mass += bodies.record[body].mass;
        if (bodies.links[body].solverContacts > 0) lightest = std::min(lightest, bodies.record[body].mass);
    }
    return island.held.empty() ? mass > heavy * lightest : lightest < unlimited;
}

/// Adds the impulse of contacts to the free velocity. change: by that impulse, in the record, at the mass that contacts
/// see.
void addImpulse(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t n, std::size_t lane,
                const SolverVelocity& change, int velocity = BodyField::FreeX) {
    const auto at = [&](int field) -> double& { return numbers.body(n, field, lane); };
    const double inverseGyration = static_cast<double>(bodies.turn[numbers.movedBody(n, lane)].inverseGyration);
    const double massRatio = at(BodyField::ContactMass) / at(BodyField::Mass);
    at(velocity) += static_cast<double>(change.x) * massRatio;
    at(velocity + 1) += static_cast<double>(change.y) * massRatio;
    if (at(BodyField::Inertia) > 0)
        at(velocity + 2) +=
            static_cast<double>(change.w) * inverseGyration * at(BodyField::ContactInertia) / at(BodyField::Inertia);
}

/// Is the row at a stop that pushes against the contacts of its bodies, or does a motor without limit hold its speed? A
/// stop that pushes the same way as they do opens if they push more.
bool isLoadedStop(const IslandNumbers& numbers, std::size_t i, std::size_t lane) {
    constexpr double target = 0, lowerStop = 3, upperStop = 4;  // see island_curve_wide.h
    const double state = numbers.row(i, RowField::State, lane);
    if (state == target) return !numbers.layout->rows[i].bounded && numbers.row(i, RowField::High, lane) == unlimited;
    if (state < lowerStop) return false;
    const double sign = state == upperStop ? -1 : 1;
    double against = 0;
    const IslandShape::Link& link = numbers.layout->links[numbers.layout->rows[i].link];
    for (const bool isB : {false, true}) {
        const std::uint32_t n = isB ? link.b : link.a;
        if (n >= numbers.layout->moved) continue;
        const double along = numbers.row(i, RowField::AxisX, lane) * numbers.body(n, BodyField::NormalX, lane) +
                             numbers.row(i, RowField::AxisY, lane) * numbers.body(n, BodyField::NormalY, lane);
        against -= (isB ? sign : -sign) * along;
    }
    return against > 0;
}

/// Do contacts push a body of the row, or must they, because it does not part from what it touches?
bool isPushed(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t i, std::size_t lane) {
    constexpr double little = 1e-6;  // of the speed at which it parts: rounding
    const IslandShape::Link& link = numbers.layout->links[numbers.layout->rows[i].link];
    const auto pushes = [&](std::uint32_t n) {
        if (n >= numbers.layout->moved) return false;
        const auto at = [&](int field) { return numbers.body(n, field, lane); };
        const SolverVelocity& warm = bodies.warm[numbers.movedBody(n, lane)];
        const double x = at(BodyField::NormalX), y = at(BodyField::NormalY);
        const double parting = at(BodyField::Vx) * x + at(BodyField::Vy) * y;
        return parting < 0 || static_cast<double>(warm.x) * x + static_cast<double>(warm.y) * y > little * parting;
    };
    return pushes(link.a) || pushes(link.b);
}

/// Are other stops loaded than those with which contacts were solved? One that has opened because nothing pushes its
/// bodies any more does not count.
bool areOthersLoaded(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane) {
    for (std::size_t i = 0; i < numbers.layout->rows.size(); ++i) {
        if (numbers.layout->rows[i].holds) continue;
        const double known = numbers.row(i, RowField::Loaded, lane);
        if (known < 0 || isLoadedStop(numbers, i, lane) == (known > 0)) continue;
        if (known == 0 || isPushed(numbers, bodies, i, lane)) return true;
    }
    return false;
}

void addBodies(std::vector<ContactBody>& found, const IslandNumbers& numbers, const BodyStore& bodies,
               std::size_t lane) {
    // A body that responds by more than this share of what it would do alone is seen as it is. None is seen as more
    // than 1 / least times as heavy: beyond that, impulses may leave the range of floats (tried).
    constexpr double share = 0.25, least = 1e-4;
    const std::size_t moved = numbers.layout->moved;
    const auto at = [&](std::size_t n, int field) -> double& { return numbers.body(n, field, lane); };
    const auto linear = [&](std::size_t n) { return at(n, BodyField::Response) * at(n, BodyField::OwnMass); };
    const auto turning = [&](std::size_t n) { return at(n, BodyField::TurnResponse) * at(n, BodyField::Inertia); };
    const auto isHeld = [&](std::size_t n) {
        return bodies.links[numbers.movedBody(n, lane)].solverContacts > 0 && std::min(linear(n), turning(n)) < share;
    };
    double count = 0;
    for (std::size_t n = 0; n < moved; ++n) count += isHeld(n) ? 1 : 0;
    count = std::max(1.0, count);
    for (std::size_t n = 0; n < moved; ++n) {
        double mass = at(n, BodyField::OwnMass), inertia = at(n, BodyField::Inertia);
        if (isHeld(n)) {
            mass /= std::clamp(count * linear(n), least, 1.0);
            inertia /= std::clamp(count * turning(n), least, 1.0);
        }
        if (mass == at(n, BodyField::ContactMass) && inertia == at(n, BodyField::ContactInertia)) continue;
        at(n, BodyField::ContactMass) = mass;
        at(n, BodyField::ContactInertia) = inertia;
        found.push_back({numbers.movedBody(n, lane), mass, inertia});
    }
}

void findBodiesIn(const LaneFlags& lanes, IslandNumbers& numbers, const BodyStore& bodies,
                  std::vector<ContactBody>& found) {
    if (lanes == LaneFlags{}) return;
    numbers.kernel().findResponses(numbers.view);
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        if (lanes[lane] != 0) addBodies(found, numbers, bodies, lane);
}

}  // namespace

void IslandContacts::find(IslandNumbers& numbers, const BodyStore& bodies) {
    touching_.clear();
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        const BodyIndex body = numbers.movedBody(n, lane);
        if (bodies.links[body].solverContacts > 0)
            touching_.push_back({static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(lane), body});
    });
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        numbers.heavy[lane] = isHeavy(numbers, bodies, lane) ? 1 : 0;
}

void IslandContacts::addFirstGuess(const IslandNumbers& numbers, const BodyStore& bodies) const {
    for (const Touching& t : touching_) addImpulse(numbers, bodies, t.node, t.lane, bodies.warm[t.body]);
}

void IslandContacts::takeImpulses(const IslandNumbers& numbers, BodyStore& bodies, LaneFlags& touched,
                                  const LaneFlags& toPresent) const {
    for (const Touching& t : touching_) {
        const SolverVelocity now = bodies.velocity[t.body], before = bodies.before[t.body];
        if (now.x == before.x && now.y == before.y && now.w == before.w) continue;
        touched[t.lane] = 1;
        const SolverVelocity change{now.x - before.x, now.y - before.y, now.w - before.w, 0};
        SolverVelocity& warm = bodies.warm[t.body];
        warm = {warm.x + change.x, warm.y + change.y, warm.w + change.w, 0};
        bodies.before[t.body] = now;
        addImpulse(numbers, bodies, t.node, t.lane, change);
        if (toPresent[t.lane] != 0) addImpulse(numbers, bodies, t.node, t.lane, change, BodyField::Vx);
    }
}

void IslandContacts::findBodies(IslandNumbers& numbers, const BodyStore& bodies, bool first,
                                std::vector<ContactBody>& found) const {
    // Without rows that may be at a stop, the masses of the step's first half stay right.
    if (numbers.heavy == LaneFlags{} || (!first && !numbers.layout->someFree)) return;
    numbers.forEachFreeRow([&](std::size_t i, std::size_t lane) {
        numbers.row(i, RowField::Loaded, lane) = isLoadedStop(numbers, i, lane) ? 1 : 0;
    });
    findBodiesIn(numbers.heavy, numbers, bodies, found);
}

void IslandContacts::findChangedBodies(IslandNumbers& numbers, const BodyStore& bodies,
                                       std::vector<ContactBody>& found) const {
    findBodiesIn(changed_, numbers, bodies, found);
}

bool IslandContacts::findChanged(const IslandNumbers& numbers, const BodyStore& bodies, const LaneFlags& touched) {
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        changed_[lane] = touched[lane] * numbers.heavy[lane] != 0 && areOthersLoaded(numbers, bodies, lane) ? 1 : 0;
    return changed_ != LaneFlags{};
}

/// A stop that is not loaded any more is not loaded again in this half: so the rounds come to an end, instead of
/// opening and closing one stop in turn.
void IslandContacts::noteLoadedStops(const IslandNumbers& numbers, bool withStops) const {
    numbers.forEachFreeRow([&](std::size_t i, std::size_t lane) {
        if (changed_[lane] == 0) return;
        double& known = numbers.row(i, RowField::Loaded, lane);
        if (!withStops || (known > 0 && !isLoadedStop(numbers, i, lane)))
            known = -1;
        else if (known == 0)
            known = isLoadedStop(numbers, i, lane) ? 1 : 0;
    });
}

}  // namespace plumb
