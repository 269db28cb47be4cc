// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/chain_slides.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/impact/detail/bounces.h>
#include <plumb/space/detail/chain_path.h>

namespace plumb {

namespace {

/// Slower discs are left to the solver: it loses (v dt / R)^2 of the energy, which is little there, and many of them
/// are at rest, and would be searched in each step for nothing [m/s].
constexpr double slowSlide = 0.05;
/// A disc slides if its distance from the chain is in this range [m]. The solver may leave it a little above a curve.
/// What bounces may be there on its way up or down: for that, the range ends at bouncing.
constexpr double deepestSlide = 2e-3, highestSlide = 1e-3, bouncing = 1e-5;
/// It is moved all the way to the chain if it is nearer than this, else half of it [m].
constexpr double nearEnough = 1e-4;
/// It arrives at the chain with no more than this share of its speed: steeper arrivals are impacts [-].
constexpr double steepArrival = 0.25;
/// What bounces parts from the chain with no more than this share of its speed [-], plus a speed [m/s].
constexpr double partingShare = 1e-3, partingSpeed = 1e-4;
/// It may overlap with other segments at the end by no more than this, plus its depth at the start [m].
constexpr double overlapAllowed = 2e-5;

/// A disc that may slide, and the chain below it.
struct SlidingDisc {
    BodyIndex body = noBody;
    double radius = 0;
    BodyIndex ground = noBody;
    std::uint32_t number = 0;  ///< of the chain among the ground's shapes
    double restitution = 0, friction = 0;
    StepList<ProxyId> met;  ///< segments that it may touch in the step
};

Vec2 nearestOn(const Vec2& start, const Vec2& end, const Vec2& point) {
    const Vec2 along = end - start;
    return start + std::clamp((point - start).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

/// Does the line from a to b cross that from c to d?
bool waysCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 ab = b - a, cd = d - c;
    return cross(ab, Vec2(c - a)) * cross(ab, Vec2(d - a)) < 0 && cross(cd, Vec2(a - c)) * cross(cd, Vec2(b - c)) < 0;
}

/// The radius of a body that is nothing but a disc around its centre, moves fast, and is moved by nothing but constant
/// forces and contacts with fixed bodies. All other bodies, nearly all of a world, end at one of these tests. Damping
/// and fields have no place in the closed form of a slide.
std::optional<double> freeDiscOf(const BodyStore& bodies, const Space& space, BodyIndex body) {
    if (!(bodies.motion[body].velocity.squaredNorm() > slowSlide * slowSlide)) return std::nullopt;
    const BodyLinks& links = bodies.links[body];
    const BodyRecord& record = bodies.record[body];
    if (links.solverContacts == 0 || (links.colours & looseColours) != 0 || links.proxies.size() != 1 ||
        !links.joints.empty())
        return std::nullopt;
    if (!bodies.canMove(body) || record.linearDamping != 0 || record.angularDamping != 0) return std::nullopt;
    if (!bodies.isMovedBy(body, MovedBy::ClosedForm) || bodies.step[body].flight != none) return std::nullopt;
    const Circle* circle = std::get_if<Circle>(&space[links.proxies.front()].def.shape);
    if (circle == nullptr || circle->center != record.localCenter) return std::nullopt;
    return circle->radius;
}

/// Is a disc on a chain, and where is it after the step? One object for all discs: its lists keep their memory.
class SlideSearch {
public:
    SlideSearch(const BodyStore& bodies, const ContactStore& contacts, const Space& space, double dt)
        : bodies_(bodies), contacts_(contacts), space_(space), dt_(dt) {}

    /// The chain below the disc, the disc's place on its path, and the place after dt; empty as soon as one of these
    /// finds something that the closed form does not cover.
    std::optional<BodyMotion> slideOf(BodyIndex body) {
        const std::optional<double> radius = freeDiscOf(bodies_, space_, body);
        if (!radius || !findGround(body)) return std::nullopt;
        disc_.radius = *radius;
        findChain();
        if (!findPlace()) return std::nullopt;
        const BodyMotion& from = bodies_.motion[body];
        // Where the chain is straight, the solver is exact.
        const std::optional<ChainPlace> end = slideAlong(chain_, place_, law_, dt_);
        if (!end || !end->onCurve || isHindered(*end)) return std::nullopt;
        BodyMotion motion = moveFreely(from, flightLawOf(bodies_, body), dt_);
        motion.center = end->position;
        motion.velocity = end->direction * end->speed;
        if (law_.inertia == 0) return motion;
        motion.angularVelocity = -chain_.side * end->speed / disc_.radius;
        motion.angle = from.angle - chain_.side * end->distance / disc_.radius;
        motion.rotation = Rot::fromAngle(motion.angle);
        return motion;
    }

private:
    /// Finds the chain on which the body is, if all of its contacts in the solver are with that chain.
    bool findGround(BodyIndex body) {
        disc_ = {};
        disc_.body = body;
        const bool hindered = anyContact(bodies_, contacts_, body, [&](ContactIndex index) {
            return contacts_[index].isSolved() && !addContact(contacts_[index]);
        });
        if (hindered || disc_.met.empty()) return false;
        addNear();
        return true;
    }

    /// Adds the segments of the chain that are near and have no contact in the solver.
    void addNear() {
        forEachContact(bodies_, contacts_, disc_.body, [&](ContactIndex index) {
            const ContactRecord& contact = contacts_[index];
            const ProxyId id = contact.bodyA == disc_.ground ? contact.proxyA : contact.proxyB;
            if (!contact.isSolved() && space_[id].owner == disc_.ground && space_[id].number == disc_.number)
                disc_.met.push_back(id);
        });
    }

    /// Is it a contact with a segment of the one chain, at rest and without belts, rules or sides? Any other contact
    /// pushes the disc, too, so that its path is no longer that along the chain.
    bool addContact(const ContactRecord& contact) {
        const BodyIndex ground = otherOf(contact, disc_.body);
        const ProxyId id = contact.bodyA == ground ? contact.proxyA : contact.proxyB;
        if (contact.surfaceSpeed != 0 || contact.rollingArm != 0 || contact.ruled) return false;
        if (bodies_.record[ground].type != BodyType::Static) return false;
        const Proxy& piece = space_[id];
        if (!piece.piece || piece.convex.oneSided || !std::holds_alternative<Segment>(piece.def.shape)) return false;
        if (!disc_.met.empty() && (ground != disc_.ground || piece.number != disc_.number)) return false;
        disc_.ground = ground;
        disc_.number = piece.number;
        disc_.restitution = contact.restitution;
        disc_.friction = contact.friction;
        disc_.met.push_back(id);
        return true;
    }

    /// A body's proxies are in the order of their shapes' numbers, so those of one shape are found in O(log n).
    void findChain() {
        const std::vector<ProxyId>& all = bodies_.links[disc_.ground].proxies;
        const auto isBefore = [this](ProxyId id, std::uint32_t number) { return space_[id].number < number; };
        const auto first = std::lower_bound(all.begin(), all.end(), disc_.number, isBefore),
                   last = std::lower_bound(first, all.end(), disc_.number + 1, isBefore);
        chain_.space = &space_;
        chain_.pieces = {first, last};
        chain_.pose = bodies_.pose(disc_.ground);
    }

    std::size_t edgeOf(ProxyId id) const {
        const std::size_t guess = id - chain_.pieces.front();  // they are made one after the other
        if (guess < chain_.pieces.size() && chain_.pieces[guess] == id) return guess;
        return static_cast<std::size_t>(std::find(chain_.pieces.begin(), chain_.pieces.end(), id) -
                                        chain_.pieces.begin());
    }

    /// Finds the nearest point of the chain, and whether the disc touches it and moves along it. If the nearest point
    /// is a vertex, the disc is on the arc around it. restingSpeed is the speed that the acceleration along the normal
    /// makes in half a step: as in the solver, slower bounces are none.
    bool findPlace() {
        const BodyMotion& from = bodies_.motion[disc_.body];
        double nearest = std::numeric_limits<double>::infinity();
        Vec2 foot(0, 0);
        ProxyId best = 0;
        for (const ProxyId id : disc_.met) {
            const Segment& segment = std::get<Segment>(space_[id].def.shape);
            const Vec2 point = nearestOn(chain_.pose * segment.start, chain_.pose * segment.end, from.center);
            const double distance = (from.center - point).norm();
            // Of two that meet at the nearest point, the first of the chain: the order of contacts does not matter.
            if (distance > nearest || (distance == nearest && id > best)) continue;
            nearest = distance;
            best = id;
            foot = point;
            place_.edge = edgeOf(id);
        }
        const double height = nearest - disc_.radius;
        if (height < -deepestSlide || height > (disc_.restitution > 0 ? bouncing : highestSlide)) return false;
        const ChainEdge edge = chainEdge(chain_, place_.edge);
        const Vec2 normal = (from.center - foot) / nearest;
        place_.position = from.center;
        place_.onArc = std::abs(normal.dot(edge.along)) > 1e-9;
        place_.direction = edge.along;
        chain_.side = cross(edge.along, normal) > 0 ? 1 : -1;
        if (place_.onArc) place_.direction = perp(normal) * -chain_.side;
        place_.speed = from.velocity.dot(place_.direction);
        law_ = {};
        law_.acceleration = flightLawOf(bodies_, disc_.body).acceleration.linear;
        law_.restitution = disc_.restitution;
        law_.restingSpeed = restingSpeed(bodies_, disc_.body, disc_.ground, normal);
        return (disc_.friction == 0 || startRolling()) && settle(height, normal);
    }

    /// Does the disc roll, up to a slip that friction would end within the step: slip < mu a dt? The angular momentum
    /// about its contact point stays: v = (v0 + k w r) / (1 + k), where w r is the speed of its rim.
    bool startRolling() {
        const BodyRecord& record = bodies_.record[disc_.body];
        const FlightLaw law = flightLawOf(bodies_, disc_.body);
        if (record.inverseInertia == 0 || law.acceleration.angular != 0) return false;
        law_.inertia = record.inertia / (record.mass * disc_.radius * disc_.radius);
        law_.friction = disc_.friction;
        const double rolling = -chain_.side * bodies_.motion[disc_.body].angularVelocity * disc_.radius;
        const double slip = std::abs(place_.speed - rolling);
        if (slip > disc_.friction * 2 * law_.restingSpeed) return false;
        place_.speed = (place_.speed + law_.inertia * rolling) / (1 + law_.inertia);
        return true;
    }

    /// Moves the place towards the chain, without a change of energy, and takes the velocity along the normal. The
    /// solver leaves small gaps and overlaps; larger ones are halved in each step, so that nothing jumps.
    bool settle(double height, const Vec2& normal) {
        const double speed = std::abs(place_.speed), parting = bodies_.motion[disc_.body].velocity.dot(normal);
        // What does not bounce, and falls back within the step, goes on as if it had not parted.
        const double fall = -law_.acceleration.dot(normal) * 0.5 * dt_, least = partingShare * speed + partingSpeed;
        const double mostParting = law_.restitution > 0 ? least : std::max(fall, least);
        if (parting > mostParting || -parting > steepArrival * speed) return false;
        if (bounces(law_.restitution, -parting, law_.restingSpeed)) return false;
        const double kept = std::abs(height) < nearEnough ? 0 : 0.5 * height;
        chain_.offset = disc_.radius + kept;
        const Vec2 shift = normal * (kept - height);
        const double squared = speed * speed + 2 * law_.acceleration.dot(shift) / (1 + law_.inertia);
        if (squared <= 0) return false;
        place_.position += shift;
        place_.speed = std::copysign(std::sqrt(squared), place_.speed);
        if (place_.onArc) return leaveForEdge(normal);
        return true;
    }

    /// On an arc, the place's edge is the one to which the disc moves.
    bool leaveForEdge(const Vec2& normal) {
        const ChainEdge edge = chainEdge(chain_, place_.edge);
        const bool atEnd = normal.dot(edge.along) > 0, forwards = place_.speed > 0;
        if (atEnd != forwards) return true;
        const std::size_t count = chain_.pieces.size();
        const Segment& segment = std::get<Segment>(space_[chain_.pieces[place_.edge]].def.shape);
        if (!(atEnd ? segment.after : segment.before)) return false;
        place_.edge = atEnd ? (place_.edge + 1) % count : (place_.edge + count - 1) % count;
        return true;
    }

    /// Does the disc meet the chain elsewhere, where it comes back to itself? At the end of the slide it must not
    /// overlap with a segment, and the straight way there must not cross one that is not on its path.
    bool isHindered(const ChainPlace& end) const {
        const Vec2& start = bodies_.motion[disc_.body].center;
        const double least = std::min(disc_.radius, chain_.offset) - overlapAllowed;
        for (const ProxyId id : disc_.met) {
            const Segment& segment = std::get<Segment>(space_[id].def.shape);
            const Vec2 a = chain_.pose * segment.start, b = chain_.pose * segment.end;
            if ((end.position - nearestOn(a, b, end.position)).norm() < least) return true;
            if (!waysCross(start, end.position, a, b)) continue;
            const std::size_t edge = edgeOf(id);
            if (edge < end.first || edge > end.last) return true;
        }
        return false;
    }

    const BodyStore& bodies_;
    const ContactStore& contacts_;
    const Space& space_;
    double dt_;
    SlidingDisc disc_;
    ChainSide chain_;
    ChainPlace place_;
    ChainLaw law_;
};

/// Enters what the vertices took from the energy, as impacts, and the ground's push: what changed the momentum besides
/// the acceleration. The ledger leaves the disc's contacts in the solver out (StepAudit::isAlongChain), or both would
/// count.
void noteSlide(const BodyStore& bodies, const ChainSlideEnd& slide, double dt, StepObserver& observer) {
    const BodyMotion &from = bodies.motion[slide.body], &to = slide.motion;
    const BodyRecord& record = bodies.record[slide.body];
    const Acceleration acceleration = flightLawOf(bodies, slide.body).acceleration;
    observer.noteFlight(slide.body, from, to, dt);
    const double spins = to.angularVelocity * to.angularVelocity - from.angularVelocity * from.angularVelocity;
    const double kinetic =
        0.5 * record.mass * (to.velocity.squaredNorm() - from.velocity.squaredNorm()) + 0.5 * record.inertia * spins;
    const double work = record.mass * acceleration.linear.dot(to.center - from.center) +
                        record.inertia * acceleration.angular * (to.angle - from.angle);
    observer.noteImpact(0, 0, kinetic - work, record.mass * (to.velocity - from.velocity - acceleration.linear * dt));
}

}  // namespace

/// MovedBy::Chain keeps the solver from moving the discs, while it solves their contacts. Worlds that wrap are left
/// out: distances to the chain do not look for its nearest image. O(awake bodies), and nearly all end at the first
/// test.
StepList<ChainSlideEnd> findChainSlides(BodyStore& bodies, const ContactStore& contacts, const Space& space,
                                        double dt) {
    StepList<ChainSlideEnd> slides;
    if (bodies.wrap.any()) return slides;
    SlideSearch search(bodies, contacts, space, dt);
    for (const BodyIndex body : bodies.awake)
        if (const std::optional<BodyMotion> motion = search.slideOf(body)) slides.push_back({body, *motion});
    for (const ChainSlideEnd& slide : slides) bodies.step[slide.body].movedBy = MovedBy::Chain;
    return slides;
}

/// After the solver. MovedBy::Solver, so that what follows, as sensors and sleep, treats a disc like any body in
/// contact.
void moveAlongChains(BodyStore& bodies, const StepList<ChainSlideEnd>& slides, double dt, StepObserver* observer) {
    for (const ChainSlideEnd& slide : slides) {
        if (observer != nullptr) noteSlide(bodies, slide, dt, *observer);
        bodies.step[slide.body].movedBy = MovedBy::Solver;
        storeMotion(bodies, slide.body, slide.motion);
    }
}

}  // namespace plumb
