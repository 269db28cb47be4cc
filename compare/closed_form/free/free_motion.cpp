// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/free_motion.h>

#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/first_descent.h>
#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/free/meetings.h>
#include <compare/closed_form/free/one_formula.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {
namespace {

constexpr double touching = 1e-6;  // a body nearer than this to a face at the start lies on it [m]
constexpr double resting = 1e-9;   // below this speed it does not leave a face, or slip [m/s]
constexpr double together = 1e-9;  // impacts closer in time than this are at the same time [s]
constexpr int mostMeetings = 20000;

class FreeFlight {
public:
    FreeFlight(std::vector<FreeBody> bodies, const Scene& scene) : bodies_(std::move(bodies)), scene_(scene) {}

    void run() {
        for (FreeBody& body : bodies_) {
            rest(body);
            goOn(body);
        }
        for (FreeBody& body : bodies_) refuseLeaning(body);
        int meetings = 0;
        while (const std::optional<Meeting> meeting = nextMeeting(bodies_, scene_.wrap, scene_.duration)) {
            if (++meetings > mostMeetings) notKnown(bodies_[meeting->body].scene->name, "it meets things without end");
            meet(*meeting);
        }
    }

    const std::vector<FreeBody>& bodies() const { return bodies_; }

private:
    void meet(const Meeting& meeting) {
        FreeBody& body = bodies_[meeting.body];
        body.flight = flightAt(body.flight, meeting.time);
        switch (meeting.kind) {
            case Meeting::Kind::Unknown: notKnown(body.scene->name, meeting.why);
            case Meeting::Kind::FaceEnd:
                notKnown(body.scene->name, "it comes to the end of what it lies on, " + nameOf(body.face->surface));
            case Meeting::Kind::SlipEnd: stopSlipping(body); break;
            case Meeting::Kind::Face: land(body, *meeting.face); break;
            case Meeting::Kind::Corner: hitCorner(body, *meeting.corner); break;
            case Meeting::Kind::Other: hitOther(body, meeting); return;
        }
        goOn(body);
        refuseLeaning(body);
    }

    const std::string& nameOf(const Surface& surface) const { return scene_.bodies[surface.body].name; }

    /// Newton's law does not tell how a body moves on after impacts with two things at once.
    void noteImpact(const FreeBody& body, double time) {
        for (const auto& [name, last] : impacts_)
            if (name == &body && time - last < together) notKnown(body.scene->name, "it meets two things at once");
        impacts_.emplace_back(&body, time);
        if (!body.simple) notKnown(body.scene->name, "it is made of several shapes, and meets something");
    }

    /// Sets the motion from now on, on its face or free, and records it as a flight.
    void goOn(FreeBody& body) {
        setAcceleration(body);
        if (!body.flights.empty() && body.flights.back().start == body.flight.start) body.flights.pop_back();
        body.flights.push_back(body.flight);
    }

    static double gapTo(const FreeBody& body, const Face& face) {
        const Vec2 place = body.flight.position - face.velocity * body.flight.start;
        double lowest = body.radius ? -*body.radius : 0;
        if (!body.radius)
            for (const Vec2& corner : body.hull) lowest = std::min(lowest, face.normal.dot(corner) - body.skin);
        return face.normal.dot(place) + lowest - face.offset;
    }
    static bool isOver(const FreeBody& body, const Face& face) {
        const double at = tangentOf(face.normal).dot(body.flight.position - face.velocity * body.flight.start);
        return at >= face.low && at <= face.high;
    }

    /// Looks for the face that carries it now.
    void rest(FreeBody& body) {
        const Face* before = body.face;
        body.face = nullptr;
        if (!body.radius && body.flight.angularVelocity != 0) {
            refuseTurningOn(body);
            return;
        }
        for (const Face& face : body.obstacles.faces) {
            const double leaving = face.normal.dot(body.flight.velocity - face.velocity);
            if (std::abs(gapTo(body, face)) > touching || std::abs(leaving) > resting || !isOver(body, face)) continue;
            if (body.gravity.dot(face.normal) > -resting) continue;
            if (body.face) notKnown(body.scene->name, "it lies on two faces at once");
            if (face.turns) notKnown(body.scene->name, "it lies on " + nameOf(face.surface) + ", which does not stay");
            if (!body.simple) notKnown(body.scene->name, "it is made of several shapes, and lies on something");
            if (rollsWithResistance(body, face)) notKnown(body.scene->name, "it rolls with resistance");
            body.face = &face;
        }
        if (before && before->normal.dot(body.flight.velocity - before->velocity) < -resting)
            notKnown(body.scene->name, "it is pushed into what it lies on, " + nameOf(before->surface));
        if (body.face) lieStill(body);
    }

    /// A turning body that is not a disc has no formula if a face is within its reach.
    void refuseTurningOn(const FreeBody& body) const {
        for (const Face& face : body.obstacles.faces) {
            const Vec2 place = body.flight.position - face.velocity * body.flight.start;
            const double above = face.normal.dot(place) - face.offset, at = tangentOf(face.normal).dot(place);
            if (std::abs(above) < body.reach && at > face.low - body.reach && at < face.high + body.reach)
                notKnown(body.scene->name, "it turns beside " + nameOf(face.surface));
        }
    }

    static bool rollsWithResistance(const FreeBody& body, const Face& face) {
        return body.radius &&
               (body.surface.def->material.rollingResistance > 0 || face.surface.def->material.rollingResistance > 0);
    }

    /// Removes the speed away from the face.
    static void lieStill(FreeBody& body) {
        const Face& face = *body.face;
        body.flight.velocity -= face.normal.dot(body.flight.velocity - face.velocity) * face.normal;
    }

    void stopSlipping(FreeBody& body) {
        const double slip = slipOf(body, body.flight);
        const Vec2 along = tangentOf(body.face->normal);
        if (!body.radius)
            body.flight.velocity -= slip * along;
        else if (body.inverseInertia > 0)
            body.flight.angularVelocity -= slip / *body.radius;
        else
            body.flight.velocity -= slip * along;
    }

    void land(FreeBody& body, const Face& face) {
        noteImpact(body, body.flight.start);
        const PairLaw law = lawOf(*face.surface.def, *body.surface.def);
        if (!body.radius) refuseUneven(body, face, law);
        collide(body, nullptr, face.velocity, face.normal, law);
        const double leaving = face.normal.dot(body.flight.velocity - face.velocity);
        const double fall = -face.normal.dot(body.gravity);
        if (fall > 0 && 2 * leaving / fall <= body.shortestFlight) {
            body.flight.velocity -= leaving * face.normal;
            body.flight.position -= gapTo(body, face) * face.normal;
        }
        refusePressing(body, face);
        rest(body);
    }

    /// A block turns if it does not land flat, over its middle and without friction.
    void refuseUneven(const FreeBody& body, const Face& face, const PairLaw& law) const {
        const Vec2 along = tangentOf(face.normal);
        double lowest = 0, from = 0, to = 0;
        for (const Vec2& corner : body.hull) lowest = std::min(lowest, face.normal.dot(corner));
        for (const Vec2& corner : body.hull) {
            if (face.normal.dot(corner) > lowest + touching) continue;
            from = std::min(from, along.dot(corner));
            to = std::max(to, along.dot(corner));
        }
        const double slip = along.dot(body.flight.velocity - face.velocity) - law.belts;
        const bool rubs = law.friction > 0 && std::abs(slip) > resting;
        if (body.inverseInertia > 0 && (from >= 0 || to <= 0 || rubs))
            notKnown(body.scene->name, "it turns as it lands");
    }

    /// An impact that pushes it into the face on which it lies is an impact with two things.
    void refusePressing(const FreeBody& body, const Face& hit) const {
        if (!body.face || body.face == &hit) return;
        const Face& face = *body.face;
        if (face.normal.dot(body.flight.velocity - face.velocity) < -resting)
            notKnown(body.scene->name,
                     "it touches " + nameOf(face.surface) + " and " + nameOf(hit.surface) + " at once");
    }

    void hitCorner(FreeBody& body, const Corner& corner) {
        noteImpact(body, body.flight.start);
        const Vec2 place = corner.position + corner.velocity * body.flight.start;
        const Vec2 normal = (body.flight.position - place).normalized();
        collide(body, nullptr, corner.velocity, normal, lawOf(*corner.surface.def, *body.surface.def));
        rest(body);
    }

    void hitOther(FreeBody& body, const Meeting& meeting) {
        FreeBody& other = bodies_[meeting.other];
        other.flight = flightAt(other.flight, meeting.time);
        noteImpact(body, meeting.time);
        noteImpact(other, meeting.time);
        const Vec2 normal = (other.flight.position + meeting.shift - body.flight.position).normalized();
        collide(other, &body, {0, 0}, normal, lawOf(*body.surface.def, *other.surface.def));
        for (FreeBody* one : {&body, &other}) {
            rest(*one);
            goOn(*one);
        }
        refuseLeaning(body);
        refuseLeaning(other);
    }

    /// Discs that lie against each other and are pressed together share forces.
    void refuseLeaning(const FreeBody& body) const {
        for (const FreeBody& other : bodies_) {
            if (&other == &body || !mayTouch(body.scene->def, other.scene->def)) continue;
            const double time = body.flight.start;
            const Flight now = flightAt(other.flight, time);
            const Vec2 apart = now.position - body.flight.position;
            const double gap = apart.norm() - body.radius.value_or(body.reach) - other.radius.value_or(other.reach);
            const Vec2 normal = apart.normalized(), slide = now.velocity - body.flight.velocity;
            if (std::abs(gap) > touching || std::abs(normal.dot(slide)) > resting) continue;
            const double parting = normal.dot(now.acceleration - body.flight.acceleration) +
                                   (slide.squaredNorm() - std::pow(normal.dot(slide), 2)) / apart.norm();
            if (parting < -resting) notKnown(body.scene->name, "it leans on " + other.scene->name);
        }
    }

    std::vector<FreeBody> bodies_;
    const Scene& scene_;
    std::vector<std::pair<const FreeBody*, double>> impacts_;
};

/// The flights, cut where the body leaves a world that wraps on one side and enters on the other.
std::vector<Flight> wrapped(const std::vector<Flight>& flights, const Wrap& wrap, double end) {
    std::vector<Flight> cut;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const double until = i + 1 < flights.size() ? flights[i + 1].start : end;
        Flight part = flights[i];
        part.position = wrap.place(part.position);
        cut.push_back(part);
        while (true) {
            std::optional<double> first;
            Vec2 shift(0, 0);
            for (const auto& [side, period] : {std::pair(Vec2(1, 0), wrap.width), std::pair(Vec2(0, 1), wrap.height)}) {
                if (!period) continue;
                for (const double way : {1.0, -1.0}) {
                    const std::vector<double> left{
                        way > 0 ? part.position.dot(side) : *period - part.position.dot(side),
                        way * part.velocity.dot(side), way * part.acceleration.dot(side) / 2};
                    const std::optional<double> s = firstDescent(left, first.value_or(until - part.start));
                    if (!s || part.start + *s >= until) continue;
                    first = s;
                    shift = way * *period * side;
                }
            }
            if (!first) break;
            part = flightAt(part, part.start + *first);
            part.position += shift;
            cut.push_back(part);
        }
    }
    return cut;
}

/// The motion of the body's origin.
PiecewiseMotion motionOf(const FreeBody& body, const Scene& scene) {
    PiecewiseMotion motion{body.scene->name, body.flights};
    for (Flight& flight : motion.flights) {
        const bool spins = flight.angularVelocity != 0 || flight.angularAcceleration != 0;
        if (spins && body.scene->def.angularDamping > 0) notKnown(body.scene->name, "its turning is damped");
        if (body.center == Vec2(0, 0)) continue;
        if (spins) notKnown(body.scene->name, "its origin turns about its centre of mass");
        flight.position -= startPose({.angle = flight.angle}) * body.center;
    }
    if (scene.wrap.any()) motion.flights = wrapped(motion.flights, scene.wrap, scene.duration);
    return motion;
}

}  // namespace

std::vector<WorkedMotion> freeMotions(const Scene& scene) {
    std::vector<FreeBody> flying;
    std::vector<std::optional<WorkedMotion>> alone;
    for (const BodyMotion& motion : scene.closedForm->bodies) {
        const auto* free = std::get_if<FreeMotion>(&motion);
        if (!free) continue;
        FreeBody body = freeBodyOf(scene, *free);
        if (scene.wrap.any() && (!body.obstacles.faces.empty() || !body.obstacles.corners.empty()))
            notKnown(free->body, "it may meet what does not move in a world that wraps");
        alone.push_back(motionInAir(scene, body));
        if (!alone.back()) alone.back() = tippingMotion(scene, body);
        if (!alone.back()) flying.push_back(std::move(body));
    }
    FreeFlight flight(std::move(flying), scene);
    flight.run();
    std::vector<WorkedMotion> result;
    std::size_t next = 0;
    for (const std::optional<WorkedMotion>& motion : alone)
        result.push_back(motion ? *motion : WorkedMotion{motionOf(flight.bodies()[next++], scene)});
    return result;
}

}  // namespace plumb::compare
