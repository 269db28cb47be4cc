// SPDX-License-Identifier: MIT
// Lifts, walkers and moths: how they move, and what happens when the hero meets a foe.
#include <algorithm>
#include <cmath>

#include <games/runner/stage.h>

namespace plumb::games::runner {
namespace {

constexpr double walkSpeed = 1.8, burrSpeed = 1.2;  ///< [m/s]
constexpr double walkerGravity = 40;                ///< [m/s^2]
constexpr double nearEnough = 16;                   ///< walkers farther from the hero stand still [m]
constexpr double stompRise = 2, heldStompRise = 4;  ///< rise of the hero after a stomp, without and with jump held [m]
constexpr double forgiven = 0.1;   ///< a foe's box is narrower than its picture by this, at each side [m]
constexpr double squashSpeed = 3;  ///< least speed of a crate that squashes a walker [m/s]

Aabb boxAround(const Vec2& center, const Vec2& half) {
    return {center - half, center + half};
}

}  // namespace

bool Stage::isNear(const Vec2& at) const {
    return std::fabs(at.x() - heroAt().x()) < nearEnough;
}

void Stage::moveLifts() {
    for (const Lift& lift : lifts_)
        world_.body(lift.body).moveTo(lift.path.poseAfter(ticks_ + lift.phase, feel_.tick).position, 0, feel_.tick);
}

void Stage::moveWalkers() {
    for (Walker& walker : walkers_) {
        if (!walker.alive) {
            ++walker.deadTicks;
            continue;
        }
        if (isNear(world_.body(walker.body).position()))
            walk(walker);
        else
            world_.body(walker.body).setVelocity({0, 0});
    }
}

void Stage::walk(Walker& walker) {
    const Vec2 at = world_.body(walker.body).position();
    if (walker.slide.isOnFloor) {
        const Vec2 front = at + Vec2(walker.direction * walkerHalf.x(), -walkerHalf.y() + 0.1);
        const bool ledge = !world_.castRay(front, front - Vec2(0, 0.8), {.category = 4, .mask = 1});
        const bool wall = walker.slide.isOnWall && walker.slide.wallNormal.x() * walker.direction < 0;
        if (ledge || wall) walker.direction = -walker.direction;
    }
    const double fall = walker.slide.isOnFloor ? 0 : walker.slide.velocity.y() - walkerGravity * feel_.tick;
    const double speed = walker.thorny ? burrSpeed : walkSpeed;
    const Vec2 velocity(walker.direction * speed, std::max(fall, -15.0));
    walker.slide = moveAndSlide(world_, walker.body, {.velocity = velocity, .dt = feel_.tick}, {}, walker.slide);
    if (at.y() > -2) return;
    walker.alive = false;
    world_.body(walker.body).setEnabled(false);
}

void Stage::moveMoths() {
    for (Moth& moth : moths_) {
        if (moth.alive)
            world_.body(moth.body).moveTo(moth.path.poseAfter(ticks_ + moth.phase, feel_.tick).position, 0, feel_.tick);
        else
            ++moth.deadTicks;
    }
}

void Stage::meetFoes(const PlatformInput& input) {
    const Aabb hero = boxAround(heroAt(), heroHalf);
    const bool falls = hero_.fallSpeed > 1;
    const auto isOn = [&](const Vec2& at) { return falls && hero.lower.y() > at.y() - 0.05; };
    const auto end = [&](auto& foe, const Vec2& at) {
        foe.alive = false;
        world_.body(foe.body).setEnabled(false);
        stomp(at, input);
    };
    for (Walker& walker : walkers_) {
        if (!walker.alive) continue;
        const Vec2 at = world_.body(walker.body).position();
        if (!overlap(hero, boxAround(at, walkerHalf - Vec2(forgiven, 0)))) continue;
        if (!walker.thorny && isOn(at))
            end(walker, at);
        else
            hurt();
    }
    for (Moth& moth : moths_) {
        if (!moth.alive) continue;
        const Vec2 at = world_.body(moth.body).position();
        if (!overlap(hero, boxAround(at, Vec2(mothRadius - forgiven, mothRadius - forgiven)))) continue;
        if (isOn(at))
            end(moth, at);
        else
            hurt();
    }
}

void Stage::stomp(const Vec2& at, const PlatformInput& input) {
    note(EventKind::Stomped, at, ++hero_.chain);
    throwUp(input.jump ? heldStompRise : stompRise);
}

void Stage::knock(Cell cell) {
    const Vec2 top = tiles().centerOf(cell) + Vec2(0, 0.5 + walkerHalf.y());
    for (Walker& walker : walkers_) {
        const Vec2 away = world_.body(walker.body).position() - top;
        if (walker.alive && std::fabs(away.x()) < 0.9 && std::fabs(away.y()) < 0.2) squash(walker);
    }
}

void Stage::squash(Walker& walker) {
    walker.alive = false;
    world_.body(walker.body).setEnabled(false);
    note(EventKind::Squashed, world_.body(walker.body).position());
}

void Stage::squashByCrates() {
    std::vector<BodyId> hit;
    for (const ContactHit& contact : world_.contactHits()) {
        if (contact.approachSpeed < squashSpeed || std::fabs(contact.normal.y()) < 0.7) continue;
        hit.push_back(contact.shapeA.body);
        hit.push_back(contact.shapeB.body);
    }
    for (Walker& walker : walkers_)
        if (walker.alive && std::find(hit.begin(), hit.end(), walker.body) != hit.end()) squash(walker);
}

}  // namespace plumb::games::runner
