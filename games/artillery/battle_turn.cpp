// SPDX-License-Identifier: MIT
// The phases of a turn: ready, aim, flight, settle; then the next turn.
#include <games/artillery/battle.h>

#include <algorithm>
#include <cmath>

#include <games/frame/game.h>

namespace plumb::games::artillery {
namespace {

constexpr int calmTicks = 12;        ///< after this time without motion, everything counts as at rest
constexpr int mournTicks = 45;       ///< from a death to the next turn
constexpr int turnOnSpot = 8;        ///< the gunner walks when the button is held longer than this
constexpr double stillSpeed = 0.25;  ///< [m/s]

}  // namespace

void Battle::update(const Orders& orders) {
    ++phaseTicks_;
    if (phase_ == Phase::Ready && phaseTicks_ >= readyTicks) enter(Phase::Aim);
    if (phase_ == Phase::Aim) obey(orders);
    before_ = orders;
    world_.step(tickSeconds);
    feelHits();
    if (phase_ == Phase::Flight) flyShell();
    burnKegs();
    meetTheSea();
    if (phase_ == Phase::Settle) {
        clearAway();
        calm_ = isCalm() ? calm_ + 1 : 0;
        if (calm_ >= calmTicks || phaseTicks_ >= settleTicks) endTurn();
    }
}

void Battle::enter(Phase phase) {
    phase_ = phase;
    phaseTicks_ = 0;
    calm_ = 0;
}

void Battle::beginTurn() {
    ++turn_;
    int& last = lastOfCrew_[static_cast<std::size_t>(crew())];
    const int count = static_cast<int>(gunners_.size());
    for (int step = 1; step <= count; ++step) {
        const int next = (last + step + count) % count;
        const Gunner& one = gunners_[static_cast<std::size_t>(next)];
        if (one.crew != crew() || !one.alive) continue;
        active_ = last = next;
        break;
    }
    setWind(random_.uniform(-setup_.wind, setup_.wind));
    if (turn_ >= setup_.tideTurn) {
        setSea(sea_ + tideRise);
        tell({.kind = Happening::Kind::Tide});
    }
    charging_ = false;
    aimHeld_ = walkHeld_ = 0;
    walkLeft_ = walkTicks;
    enter(Phase::Ready);
    tell({.kind = Happening::Kind::TurnBegan, .at = middleOf(gunner()), .crew = crew()});
}

void Battle::obey(const Orders& orders) {
    Gunner& gunner = gunners_[static_cast<std::size_t>(active_)];
    if (!gunner.alive || gunner.health == 0) return enter(Phase::Settle);
    turnBarrel(gunner, orders);
    if (!charging_) walk(gunner, orders);
    if (orders.weapon && !before_.weapon && !charging_) changeWeapon(gunner);
    const int left = turnTicks - phaseTicks_;
    if (left > 0 && left <= hurryTicks && left % 60 == 0) tell({.kind = Happening::Kind::Hurry});
    const bool late = left <= 0;
    if (charging_) {
        if (orders.fire && gunner.aim.charge < fullCharge) ++gunner.aim.charge;
        if (gunner.aim.charge % 5 == 0)
            tell({.kind = Happening::Kind::Charged, .size = double(gunner.aim.charge) / fullCharge});
        if (!orders.fire || gunner.aim.charge == fullCharge || late) fire();
    } else if (orders.fire && !before_.fire) {
        charging_ = true;
        gunner.aim.charge = 0;
    } else if (late) {
        enter(Phase::Settle);
    }
}

void Battle::turnBarrel(Gunner& gunner, const Orders& orders) {
    if (orders.up == orders.down || (aimHeld_ > 0 && orders.up != before_.up)) aimHeld_ = 0;
    if (orders.up == orders.down) return;
    int& elevation = gunner.aim.elevation;
    elevation = std::clamp(elevation + (orders.up ? 1 : -1) * aimStep(aimHeld_++), lowestAim, highestAim);
    if (aimHeld_ % 4 == 1) tell({.kind = Happening::Kind::Turned});
}

void Battle::walk(Gunner& gunner, const Orders& orders) {
    walkHeld_ = orders.left != orders.right ? walkHeld_ + 1 : 0;
    if (walkHeld_ == 0) return;
    const int facing = orders.right ? 1 : -1;
    if (gunner.aim.facing != facing) walkHeld_ = 1;
    gunner.aim.facing = facing;
    if (walkHeld_ <= turnOnSpot || walkLeft_ == 0) return;
    Body body = world_.body(gunner.body);
    const auto holds = [&](const Contact& contact) {
        return std::abs(contact.normal.y()) > 0.4 && !contact.points.empty();
    };
    const std::vector<Contact> contacts = body.contacts();
    if (std::none_of(contacts.begin(), contacts.end(), holds)) return;
    body.setVelocity({facing * walkSpeed, body.velocity().y()});
    if (--walkLeft_ % 14 == 0) tell({.kind = Happening::Kind::Walked, .at = body.position()});
}

void Battle::changeWeapon(Gunner& gunner) {
    do gunner.weapon = (gunner.weapon + 1) % static_cast<int>(weapons.size());
    while (roundsLeft(gunner.crew, gunner.weapon) == 0);
    tell({.kind = Happening::Kind::Turned});
}

void Battle::fire() {
    Gunner& gunner = gunners_[static_cast<std::size_t>(active_)];
    charging_ = false;
    gunner.mark = gunner.aim.charge;
    const BodyDef def = shellDef(middleOf(gunner), gunner.aim, weapons[static_cast<std::size_t>(gunner.weapon)]);
    shell_ = Shell{world_.add(def), gunner.weapon};
    tell({.kind = Happening::Kind::Fired, .at = def.position, .crew = gunner.crew, .along = directionOf(gunner.aim)});
    int& rounds = rounds_[static_cast<std::size_t>(gunner.crew)][static_cast<std::size_t>(gunner.weapon)];
    if (rounds > 0 && --rounds == 0) gunner.weapon = 0;
    for (Gunner& one : gunners_)
        if (roundsLeft(one.crew, one.weapon) == 0) one.weapon = 0;
    enter(Phase::Flight);
}

bool Battle::isCalm() const {
    for (const Prop& prop : props_) {
        if (prop.fuse >= 0) return false;
        const BodyView body = world_.body(prop.body);
        if (prop.kind == PieceKind::Hat || !body.awake() || body.position().y() < sea_ + 0.3) continue;
        if (body.velocity().norm() > stillSpeed) return false;
    }
    for (const Gunner& one : gunners_)
        if (one.alive && world_.body(one.body).velocity().norm() > stillSpeed) return false;
    return true;
}

void Battle::endTurn() {
    const auto isDying = [](const Gunner& one) { return one.alive && one.health == 0; };
    if (std::any_of(gunners_.begin(), gunners_.end(), isDying)) {
        buryTheDead();
        phaseTicks_ = std::max(0, settleTicks - mournTicks);
        calm_ = calmTicks - mournTicks;
        return;
    }
    if (healthOf(0) > 0 && healthOf(1) > 0) return beginTurn();
    winner_ = healthOf(0) > 0 ? 0 : healthOf(1) > 0 ? 1 : -1;
    enter(Phase::Over);
    tell({.kind = Happening::Kind::Over, .crew = winner_});
}

}  // namespace plumb::games::artillery
