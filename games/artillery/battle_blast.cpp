// SPDX-License-Identifier: MIT
// The effects of shells, kegs, falls and the sea.
#include <games/artillery/battle.h>

#include <algorithm>
#include <cmath>

#include <games/frame/game.h>

namespace plumb::games::artillery {
namespace {

using Kind = Happening::Kind;

constexpr double fallSpeed = 9.5;   ///< a gunner lands unharmed up to this speed [m/s]
constexpr double crushSpeed = 5.5;  ///< an object hits a gunner without harm up to this speed [m/s]
constexpr double kegSpeed = 9;      ///< a hit at this speed or more lights a keg [m/s]
constexpr int mostBlow = 20;        ///< highest damage of one hit [points]
constexpr int knockedFuse = 24;     ///< of a keg that a hit has lit [ticks]

}  // namespace

void Battle::flyShell() {
    const Weapon& weapon = weapons[static_cast<std::size_t>(shell_->weapon)];
    const BodyView body = world_.body(shell_->body);
    const Vec2 at = body.position();
    ++shell_->age;
    if (!shell_->falling && body.velocity().y() < -2) {
        shell_->falling = true;
        tell({.kind = Kind::Falling, .at = at});
    }
    // When the muzzle is inside the ground, the shell explodes there.
    bool goesOff = (weapon.fuse > 0 && shell_->age >= weapon.fuse) || at.y() < terrain_.heightAt(at.x()) - shellRadius;
    for (const ContactBegin& touch : world_.contactBegins()) {
        if (touch.shapeA.body != shell_->body && touch.shapeB.body != shell_->body) continue;
        if (weapon.fuse == 0) goesOff = true;
        tell({.kind = Kind::Bounced, .at = touch.point, .size = touch.approachSpeed});
    }
    const bool wet = at.y()<sea_, lost = std::abs(at.x())> worldEdge || at.y() < worldFloor || body.quarantined();
    if (!goesOff && !wet && !lost) return;
    world_.remove(shell_->body);
    shell_.reset();
    if (goesOff)
        blast(at, weapon);
    else if (wet)
        tell({.kind = Kind::Splashed, .at = {at.x(), sea_}, .size = 1.5});
    enter(Phase::Settle);
}

void Battle::blast(const Vec2& center, const Weapon& weapon) {
    tell({.kind = Kind::Exploded, .at = center, .size = weapon.blast});
    for (Gunner& gunner : gunners_) {
        if (!gunner.alive) continue;
        const double share = 1 - distanceToGunner(middleOf(gunner), center) / weapon.blast;
        if (share > 0) hurt(gunner, static_cast<int>(std::lround(weapon.damage * share)));
    }
    for (Prop& prop : props_) {
        const double distance = (world_.body(prop.body).position() - center).norm();
        if (prop.kind == PieceKind::Keg && prop.fuse < 0 && distance < weapon.blast * 0.9)
            prop.fuse = 6 + static_cast<int>(3 * distance);
    }
    // So that objects fly upwards, the push starts a little below the blast, or at the ground if that is near.
    const double above = std::clamp(center.y() - terrain_.heightAt(center.x()), 0.0, 1.4);
    const Vec2 below = center - Vec2(0, above + 0.5);
    // The new chain wakes the bodies that stood on the old outline, and they fall.
    terrain_.carve(center, weapon.crater);
    world_.shape(ground_).set(terrain_.shape());
    world_.explode({.center = below,
                    .radius = weapon.crater * 0.7,
                    .falloff = weapon.blast - weapon.crater * 0.4,
                    .impulsePerLength = weapon.push},
                   {.category = Blast, .mask = Thing | Person});
}

void Battle::hurt(Gunner& gunner, int damage) {
    const int harm = std::min(damage, gunner.health);
    if (harm <= 0) return;
    gunner.health -= harm;
    tell({.kind = Kind::Hurt, .at = middleOf(gunner), .crew = gunner.crew, .amount = harm});
}

void Battle::burnKegs() {
    for (std::size_t i = 0; i < props_.size(); ++i) {
        if (props_[i].fuse < 0 || props_[i].fuse-- > 0) continue;
        const Vec2 at = world_.body(props_[i].body).position();
        world_.remove(props_[i].body);
        props_.erase(props_.begin() + static_cast<std::ptrdiff_t>(i--));
        blast(at, kegBlast);
    }
}

/// Falls, hits by falling objects, and kegs that a hit lights.
void Battle::feelHits() {
    for (const ContactHit& hit : world_.contactHits()) {
        const BodyId a = hit.shapeA.body, b = hit.shapeB.body;
        if (shell_ && (a == shell_->body || b == shell_->body)) continue;
        tell({.kind = Kind::Thud, .at = hit.point, .size = hit.approachSpeed});
        const bool onGround = a == ground_.body || b == ground_.body;
        const double excess = hit.approachSpeed - (onGround ? fallSpeed : crushSpeed);
        for (const BodyId body : {a, b}) {
            Gunner* gunner = gunnerOf(body);
            if (gunner && excess > 0) hurt(*gunner, std::min(mostBlow, static_cast<int>(std::lround(2.5 * excess))));
            if (hit.approachSpeed < kegSpeed) continue;
            for (Prop& prop : props_)
                if (prop.body == body && prop.kind == PieceKind::Keg && prop.fuse < 0) prop.fuse = knockedFuse;
        }
    }
}

void Battle::meetTheSea() {
    for (Gunner& gunner : gunners_) {
        if (!gunner.alive) continue;
        const Vec2 at = middleOf(gunner);
        gunner.last = at;
        if (at.y() > sea_ && std::abs(at.x()) < worldEdge) continue;
        hurt(gunner, fullHealth);
        gunner.alive = false;
        world_.remove(gunner.body);
        tell({.kind = Kind::Splashed, .at = {at.x(), sea_}, .size = 2.5});
        tell({.kind = Kind::Died, .at = at, .crew = gunner.crew});
    }
}

void Battle::buryTheDead() {
    for (Gunner& gunner : gunners_) {
        if (!gunner.alive || gunner.health > 0) continue;
        const Vec2 at = middleOf(gunner);
        gunner.alive = false;
        world_.remove(gunner.body);
        // Only the hat is left.
        props_.push_back({world_.add(pieceDef(PieceKind::Hat, at + Vec2(0, 0.5))), PieceKind::Hat, -1, gunner.crew});
        world_.body(props_.back().body).setVelocity({0, 3});
        tell({.kind = Kind::Died, .at = at, .crew = gunner.crew});
    }
}

/// Removes props that have sunk or left the world.
void Battle::clearAway() {
    std::erase_if(props_, [this](const Prop& prop) {
        const BodyView body = world_.body(prop.body);
        const Vec2 at = body.position();
        const bool lost = at.y() < sea_ - 4 || std::abs(at.x()) > worldEdge || body.quarantined();
        if (lost) world_.remove(prop.body);
        return lost;
    });
}

}  // namespace plumb::games::artillery
