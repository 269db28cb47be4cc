// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/pair_collider.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/detail/for_lanes.h>
#include <plumb/math/vec2.h>

namespace plumb {

namespace {

float nearestOf(const Manifold& m) {
    return m.count > 1 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

/// How far two bodies may move relative to each other in the step, if nothing touches them. margin is what the shapes
/// must be collided with: less would miss what meets late in the step, more would collide pairs that stay apart.
struct Approach {
    float margin = 0;   ///< in any direction, plus the contact margin [m]
    float turn = 0;     ///< the part of margin that is due to rotation [m]
    Vec2f shift{0, 0};  ///< displacement of B relative to A, in A's frame [m]
};

Approach approachOf(const BodyStore& bodies, const ShapePair& pair) {
    const BodyPlace& a = bodies.place[pair.bodyA];
    const BodyPlace& b = bodies.place[pair.bodyB];
    const float x = b.shiftX - a.shiftX, y = b.shiftY - a.shiftY;
    const float turn = a.turn + b.turn;
    return {std::sqrt(x * x + y * y) + turn + contactMargin, turn, {a.cos * x + a.sin * y, a.cos * y - a.sin * x}};
}

bool isAny(const Lanes<std::int32_t>& lanes, std::size_t count) {
    return std::any_of(lanes, lanes + count, [](std::int32_t lane) { return lane != 0; });
}

bool isPolygons(std::int32_t kernel) {
    return kernel == asPolygons || kernel == onChain;
}

bool isDisc(std::int32_t kernel) {
    return kernel == discFirst || kernel == discSecond;
}

}  // namespace

PairCollider::PairCollider(ContactStore& contacts, const BodyStore& bodies, const Space& space, int lanes, double dt)
    : contacts_(contacts),
      bodies_(bodies),
      space_(space),
      lanes_(lanes),
      dt_(dt),
      corners_{contacts.corners.data(), contacts.moreCorners.data()} {}

const LaneCollider& PairCollider::colliderFor(const PairBatch& batch) const {
    return laneCollider(lanesFor(batch.count, lanes_));
}

/// The boxes of boxes are the shapes themselves: one kernel for all lanes, and a search only where it is uncertain.
void PairCollider::collideBoxes(const PairBatch& batch, FreshLanes& fresh) const {
    setPeriodicOffsets(batch.contacts, batch.count, fresh);
    colliderFor(batch).collideBoxes(batch.pairs, bodies_.place.data(), fresh, batch.count);
    resolveUncertain(batch, fresh);
}

/// Collides the batch if there is a disc in each lane, and returns whether that is so.
bool PairCollider::collideDiscsOnly(const PairBatch& batch, FreshLanes& fresh) const {
    const auto& kernel = batch.pairs.kernel;
    if (!std::all_of(kernel, kernel + batch.count, isDisc)) return false;
    colliderFor(batch).collideDiscs(batch.pairs, bodies_.place.data(), corners_, fresh, batch.count);
    resolveUncertain(batch, fresh);
    return true;
}

/// The bounding boxes of all lanes are collided first: pairs whose boxes cannot meet in this step are done.
/// Tried: not to collide pairs before their bodies have moved as far as they were apart. In heaps that leaves out half
/// of the lanes, but hardly ever all of a batch.
void PairCollider::collideNear(const PairBatch& batch, FreshLanes& fresh) const {
    setPeriodicOffsets(batch.contacts, batch.count, fresh);
    if (collideDiscsOnly(batch, fresh)) return;
    colliderFor(batch).collideBoxes(batch.pairs, bodies_.place.data(), fresh, batch.count);
    Wanted wanted;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        const bool used = lane < batch.count;
        if (!used) fresh.count[lane] = 0;
        wanted[lane] = used && fresh.count[lane] > 0 ? 1 : 0;
        fresh.uncertain[lane] = 0;
    }
    collideLanes(batch, wanted, fresh);
}

/// What has hardly moved since it was collided keeps its manifold (lanes/reuse_lanes.h): in a heap at rest that is
/// most of them. The other lanes are collided, and what they find is noted for the steps to come.
void PairCollider::collideSolved(const PairBatch& batch, const ManifoldLanes& manifolds, KeptLanes& kept,
                                 FreshLanes& fresh) const {
    setPeriodicOffsets(batch.contacts, batch.count, fresh);
    if (collideDiscsOnly(batch, fresh)) return;
    PoseLanes now;
    Wanted again;
    colliderFor(batch).reuse(batch.pairs, bodies_.place.data(), manifolds, kept, fresh, now, again, batch.count);
    for (std::size_t lane = batch.count; lane < batchLanes; ++lane) again[lane] = 0;
    collideLanes(batch, again, fresh);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        if (again[lane] == 0) continue;
        const bool touches = fresh.count[lane] > 0 && nearestOf(fresh, lane) <= contactMargin;
        // A disc rolls: its point of contact does not keep its place.
        // A predicted manifold is that of the place where the two will meet; and what is farther than the margin may
        // change its features at any time.
        const bool stays = touches && fresh.uncertain[lane] == 0 && !hasDisc(batch.pairs, lane);
        kept.pose.x[lane] = now.x[lane];
        kept.pose.y[lane] = now.y[lane];
        // Cosine and sine 0 say that it must not be used again, see KeptLanes.
        kept.pose.cos[lane] = stays ? now.cos[lane] : 0;
        kept.pose.sin[lane] = stays ? now.sin[lane] : 0;
        for (std::size_t p = 0; p < 2; ++p) kept.separations[p][lane] = fresh.points[p].separation[lane];
        kept.faces[lane] = unknownFaces;
        kept.open[lane] = 0;
    }
}

/// Collides the lanes that are wanted, each as its shapes need it; the others stay as they are.
void PairCollider::collideLanes(const PairBatch& batch, const Wanted& wanted, FreshLanes& fresh) const {
    const auto& kernel = batch.pairs.kernel;
    Wanted polygons;
    bool discs = false, some = false;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        polygons[lane] = wanted[lane] != 0 && isPolygons(kernel[lane]) ? 1 : 0;
        some = some || polygons[lane] != 0;
        discs = discs || (isDisc(kernel[lane]) && wanted[lane] != 0);
    }
    if (discs) colliderFor(batch).collideDiscs(batch.pairs, bodies_.place.data(), corners_, fresh, batch.count);
    if (some)
        colliderFor(batch).collidePolygons(batch.pairs, bodies_.place.data(), corners_, polygons, fresh, batch.count);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const bool near = kernel[lane] == noKernel || (kernel[lane] == onChain && fresh.count[lane] > 0);
        if (wanted[lane] != 0 && near) collideOne(batch, lane, fresh);
    }
    resolveUncertain(batch, fresh);
}

/// Computes the predicted manifold for the lanes in which it is uncertain whether and how the shapes meet, and for
/// those that spin, unless they touch.
void PairCollider::resolveUncertain(const PairBatch& batch, FreshLanes& fresh) const {
    if (!bodies_.someSpin && !isAny(fresh.uncertain, batch.count)) return;
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const bool uncertain = fresh.uncertain[lane] != 0;
        if (!uncertain && !(bodies_.someSpin && mayMeetSpinning(batch, lane, fresh))) continue;
        const Manifold met = predict(batch.contacts[lane], pairOf(batch, lane));
        if (!uncertain && met.count == 0) continue;
        setFresh(fresh, lane, met);
        fresh.uncertain[lane] = 1;
    }
}

/// In a world that wraps, sets the distances between bodies whose contact is with a periodic image. Does nothing in
/// other worlds.
void PairCollider::setPeriodicOffsets(const ContactIndex* contacts, std::size_t count, FreshLanes& fresh) const {
    fresh.around = false;
    if (!bodies_.wrap.any()) return;
    for (std::size_t lane = 0; lane < count; ++lane)
        fresh.around = fresh.around || !contacts_[contacts[lane]].shift.isZero(0);
    if (!fresh.around) return;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        Vec2 apart(0, 0);
        if (lane < count) {
            const ContactRecord& contact = contacts_[contacts[lane]];
            const Vec2 b = bodies_.motion[contact.bodyB].center + contact.shift;
            apart = b - bodies_.motion[contact.bodyA].center;
        }
        fresh.apartX[lane] = static_cast<float>(apart.x());
        fresh.apartY[lane] = static_cast<float>(apart.y());
    }
}

ShapePair PairCollider::pairOf(const PairBatch& batch, std::size_t lane) const {
    ShapePair pair = pairAt(batch.pairs, lane);
    if (!bodies_.wrap.any()) return pair;
    pair.shiftX = contacts_[batch.contacts[lane]].shift.x();
    pair.shiftY = contacts_[batch.contacts[lane]].shift.y();
    return pair;
}

/// Collides any two shapes. A pair that cannot meet along its normal in this step gets no points.
void PairCollider::collideOne(const PairBatch& batch, std::size_t lane, FreshLanes& fresh) const {
    const ShapePair pair = pairOf(batch, lane);
    const Approach approach = approachOf(bodies_, pair);
    const BodyMotion b = shifted(bodies_.motion[pair.bodyB], {pair.shiftX, pair.shiftY});
    const RelativePose pose = relativePose(bodies_.motion[pair.bodyA], b);
    const Manifold m = manifold(space_[pair.proxyA].convex, space_[pair.proxyB].convex, pose, approach.margin);
    setFresh(fresh, lane, m);
    if (m.count == 0 || nearestOf(m) <= contactMargin) return;
    // A gap is closed along its normal at most by the turn and by the shift against it. Whether they meet is only sure
    // after a search for the time.
    const bool never = nearestOf(m) > approach.turn - approach.shift.dot(m.normal);
    fresh.count[lane] = never ? 0 : m.count;
    fresh.uncertain[lane] = never ? 0 : 1;
}

/// The predicted manifold. Of bodies that spin, the contact is noted.
Manifold PairCollider::predict(ContactIndex index, const ShapePair& pair) const {
    const Manifold m = predictedManifold(bodies_, space_, pair, marginOf(pair), dt_);
    if (m.count > 0 && spins(pair)) contacts_.predicted.push_back(index);
    return m;
}

float PairCollider::marginOf(const ShapePair& pair) const {
    return approachOf(bodies_, pair).margin;
}

/// Two that spin, and do not touch. A disc is the same at any angle.
bool PairCollider::mayMeetSpinning(const PairBatch& batch, std::size_t lane, const FreshLanes& fresh) const {
    return fresh.count[lane] > 0 && nearestOf(fresh, lane) > 0 && !isDisc(batch.pairs.kernel[lane]) &&
           spins(pairAt(batch.pairs, lane)) && !contacts_[batch.contacts[lane]].touching;
}

/// Two dynamic bodies, one of which spins. Reads only what colliding has just read.
bool PairCollider::spins(const ShapePair& pair) const {
    const auto turns = [this](BodyIndex body) {
        const double turn = static_cast<double>(bodies_.velocity[body].w * bodies_.place[body].inverseGyration) * dt_;
        return std::fabs(turn) > spinningTurn;
    };
    const auto moves = [this](BodyIndex body) { return bodies_.velocity[body].inverseMass > 0; };
    return (turns(pair.bodyA) || turns(pair.bodyB)) && moves(pair.bodyA) && moves(pair.bodyB);
}

}  // namespace plumb
