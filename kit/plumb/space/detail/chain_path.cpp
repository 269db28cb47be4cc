// SPDX-License-Identifier: MIT
#include <plumb/space/detail/chain_path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <plumb/impact/detail/bounces.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

/// Vertices that turn by more than 14.5 degrees are corners [sine of the angle]: the closed form is for curves, and a
/// disc that comes to a corner is left to the solver. Test: "a disc keeps its energy over an edge of 14.4 degrees, and
/// loses more than 5 % over one of 14.6"
constexpr double cornerSine = 0.25;
/// Vertices that turn by less are straight: it may be rounding.
constexpr double straightSine = 1e-9;
/// The path may turn by this much in a step: the contacts were found for a path that is almost straight [rad].
constexpr double mostTurn = 1;
/// A flight from a vertex that is not higher is none: at this distance, the world counts a contact as touching [m].
constexpr double lowFlight = 0.005;
/// Slower discs are left to the solver, which brings them to rest [m/s].
constexpr double slowest = 1e-3;
/// More vertices in one step are left to the solver [-]: the work of a step must be bounded, for any length of
/// segments.
constexpr int mostVertices = 20'000;

/// The turn at a vertex; positive if it turns towards the disc, so that it is concave.
struct VertexTurn {
    bool exists = false;
    double sine = 0, cosine = 1;

    /// By how much a concave vertex shortens the path along each of its segments: offset tan(turn / 2) [m].
    double shortening(double offset) const { return sine > 0 ? offset * sine / (1 + cosine) : 0; }
    double angle() const { return arcTangent(sine, cosine); }
    /// Half of the arc around a convex vertex, which the path has in addition [m].
    double halfArc(double offset) const { return sine < 0 ? -0.5 * angle() * offset : 0; }
};

/// A segment and its two vertices.
struct EdgeView {
    ChainEdge edge;
    Vec2 normal;  ///< on the disc's side
    VertexTurn before, after;
    double low = 0, high = 0;  ///< ends of the path along the segment, from its start [m]
    double curvature = 0;      ///< mean curvature of the path; positive if it is concave [1/m]
    double length = 0;         ///< of the path from the middle of one vertex to the middle of the next [m]
};

const Segment& segmentOf(const ChainSide& chain, std::size_t edge) {
    return std::get<Segment>((*chain.space)[chain.pieces[edge]].def.shape);
}

VertexTurn turnBetween(const ChainSide& chain, const Vec2& along, const Vec2& next) {
    return {true, chain.side * cross(along, next), along.dot(next)};
}

/// The curvature is that of the curve for which the vertices stand: half of the turns at both ends, over the length of
/// the path between their middles. So the force that holds a disc on the chain does not jump from 0 to endless at each
/// vertex.
EdgeView viewOf(const ChainSide& chain, std::size_t edge) {
    const Segment& segment = segmentOf(chain, edge);
    EdgeView view;
    view.edge = chainEdge(chain, edge);
    view.normal = chain.side * perp(view.edge.along);
    const Rot& rotation = chain.pose.rotation;
    if (segment.before)
        view.before =
            turnBetween(chain, rotation * Vec2((segment.start - *segment.before).normalized()), view.edge.along);
    if (segment.after)
        view.after = turnBetween(chain, view.edge.along, rotation * Vec2((*segment.after - segment.end).normalized()));
    view.low = view.before.shortening(chain.offset);
    view.high = view.edge.length - view.after.shortening(chain.offset);
    view.length = view.high - view.low + view.before.halfArc(chain.offset) + view.after.halfArc(chain.offset);
    view.curvature = 0.5 * (view.before.angle() + view.after.angle()) / view.length;
    return view;
}

/// The time until something at distance d ahead is reached, from d = v t + a t^2 / 2; infinite if it never is. In the
/// form 2 d / (v + v') nothing cancels, and a of 0 needs no case of its own. d [m], v speed towards it [m/s], a
/// acceleration towards it [m/s^2]
double timeTo(double d, double v, double a) {
    const double squared = v * v + 2 * a * d;
    if (v > 0 && squared >= 0) return 2 * d / (v + std::sqrt(squared));
    if (v <= 0 && a > 0) return (std::sqrt(squared) - v) / a;
    return std::numeric_limits<double>::infinity();
}

/// Follows one disc through the time of a step: along a segment to its end, past its vertex, and around an arc if the
/// vertex is convex. Ends early, without a result, at everything that is not a slide. O(vertices on the way).
class ChainSlide {
public:
    ChainSlide(const ChainSide& chain, const ChainPlace& from, const ChainLaw& law, double time)
        : chain_(chain),
          law_(law),
          place_(from),
          left_(time),
          share_(1 / (1 + law.inertia)),
          view_(viewOf(chain, from.edge)) {
        place_.first = place_.last = from.edge;
        place_.distance = 0;
        noteCurve();
    }

    bool run() {
        if (place_.onArc && !goAround()) return false;
        for (int vertices = 0; left_ > 0; ++vertices)
            if (vertices > mostVertices || !goAlong()) return false;
        return true;
    }

    const ChainPlace& place() const { return place_; }

private:
    /// Does the disc stay on the chain?
    /// press = v^2 / R - a.n: the force per mass with which the chain holds it, 1/R the mean curvature of the path. On
    /// a curve, its vertices together push as the curve does that they stand for.
    /// needed = k / (1 + k) |a.t|: the friction per mass that keeps it rolling, at most friction times press.
    /// Between two vertices under a ceiling it leaves the chord by a.n (length / v)^2 / 8; that must be less than
    /// lowFlight.
    bool stays() const {
        const double pull = law_.acceleration.dot(view_.normal), v2 = place_.speed * place_.speed;
        const double press = v2 * view_.curvature - pull;
        const double needed = law_.inertia * share_ * std::abs(law_.acceleration.dot(view_.edge.along));
        if (press <= 0 || needed > law_.friction * press) return false;
        return pull <= 0 || pull * view_.length * view_.length <= 8 * lowFlight * v2;
    }

    void noteCurve() {
        for (const VertexTurn& turn : {view_.before, view_.after})
            place_.onCurve =
                place_.onCurve || (std::abs(turn.sine) > straightSine && std::abs(turn.sine) <= cornerSine);
    }

    /// Moves along the segment to its next vertex, or to the end of the time. A disc may turn round on the way, on a
    /// slope: then it comes to the vertex behind it. The speed at a vertex is taken from v^2 + 2 a s, not from v + a t:
    /// so the energy is exact, whatever rounding does to the time.
    bool goAlong() {
        if (view_.low >= view_.high || !stays()) return false;
        const Vec2& along = view_.edge.along;
        const Vec2 start = view_.edge.start + view_.normal * chain_.offset;
        const double a = share_ * law_.acceleration.dot(along), v = place_.speed;
        const double s = std::clamp((place_.position - start).dot(along), view_.low, view_.high);
        const double up = timeTo(view_.high - s, v, a), down = timeTo(s - view_.low, -v, -a);
        const double time = std::min(up, down);
        place_.direction = along;
        if (time >= left_) {
            const double at = std::clamp(s + (v + 0.5 * a * left_) * left_, view_.low, view_.high);
            place_.distance += at - s;
            place_.position = start + along * at;
            place_.speed = v + a * left_;
            left_ = 0;
            return true;
        }
        left_ -= time;
        const bool forwards = up <= down;
        const double end = forwards ? view_.high : view_.low;
        place_.distance += end - s;
        place_.position = start + along * end;
        place_.speed = (forwards ? 1 : -1) * std::sqrt(std::max(0.0, v * v + 2 * a * (end - s)));
        return passVertex(forwards);
    }

    /// What happens at a vertex. A straight one, nothing. A concave one is an impact: it is left to the solver if it
    /// would bounce, or slip: a disc that rolls on needs a tangential impulse of k sin / ((1 + k) (1 + cos)) times the
    /// normal one. A convex one is followed if the disc would fly no higher than lowFlight above it: it leaves the old
    /// segment's plane at the speed v sin.
    bool passVertex(bool forwards) {
        const VertexTurn turn = forwards ? view_.after : view_.before;
        const double speed = std::abs(place_.speed);
        if (!turn.exists || std::abs(turn.sine) > cornerSine || turn.cosine < 0 || speed < slowest) return false;
        turned_ += std::abs(turn.sine);
        if (turned_ > mostTurn) return false;
        const std::size_t count = chain_.pieces.size();
        place_.edge = forwards ? (place_.edge + 1) % count : (place_.edge + count - 1) % count;
        place_.first = std::min(place_.first, place_.edge);
        place_.last = std::max(place_.last, place_.edge);
        const Vec2 normal = view_.normal;
        view_ = viewOf(chain_, place_.edge);
        noteCurve();
        if (turn.sine > 0) {
            if (bounces(law_.restitution, speed * turn.sine, law_.restingSpeed)) return false;
            if (law_.inertia * share_ * turn.sine > law_.friction * (1 + turn.cosine)) return false;
            place_.speed *= (law_.inertia + turn.cosine) * share_;
            return true;
        }
        if (turn.sine == 0) return true;
        const double rise = speed * turn.sine;
        return rise * rise <= -2 * lowFlight * law_.acceleration.dot(normal) && goAround();
    }

    /// Moves on an arc around a vertex to the present edge. The acceleration is constant, so its work depends only on
    /// both ends of the arc, and the speed is exact; the time takes the mean of both speeds (see the header on its
    /// error).
    bool goAround() {
        const bool forwards = place_.speed > 0;
        const Vec2 corner = forwards ? view_.edge.start : view_.edge.end;
        const Vec2 from = chain_.side * perp(place_.direction);
        const double angle = arcTangent(cross(from, view_.normal), from.dot(view_.normal));
        const Vec2 end = corner + view_.normal * chain_.offset;
        const double v = std::abs(place_.speed), arc = std::abs(angle) * chain_.offset;
        const double squared = v * v + 2 * share_ * law_.acceleration.dot(end - place_.position);
        if (!stays() || squared <= slowest * slowest) return false;
        const double after = std::sqrt(squared), time = 2 * arc / (v + after);
        if (time > left_) return stopOnArc(corner, angle, v + (after - v) / time * 0.5 * left_);
        left_ -= time;
        place_.distance += forwards ? arc : -arc;
        place_.position = end;
        place_.direction = view_.edge.along;
        place_.speed = forwards ? after : -after;
        place_.onArc = false;
        return true;
    }

    /// Ends the time on an arc, which the disc follows at this mean speed.
    bool stopOnArc(const Vec2& corner, double angle, double meanSpeed) {
        const double turned = std::copysign(std::min(meanSpeed * left_ / chain_.offset, std::abs(angle)), angle);
        const Rot turn = Rot::fromAngle(turned);
        place_.distance += std::copysign(std::abs(turned) * chain_.offset, place_.speed);
        const Vec2 before = place_.position;
        place_.direction = turn * place_.direction;
        place_.position = corner + chain_.side * perp(place_.direction) * chain_.offset;
        const double squared =
            place_.speed * place_.speed + 2 * share_ * law_.acceleration.dot(place_.position - before);
        if (squared <= 0) return false;
        place_.speed = std::copysign(std::sqrt(squared), place_.speed);
        place_.onArc = true;
        left_ = 0;
        return true;
    }

    const ChainSide& chain_;
    const ChainLaw& law_;
    ChainPlace place_;
    double left_;   ///< [s]
    double share_;  ///< of the acceleration that changes the speed [-]
    EdgeView view_;
    double turned_ = 0;  ///< [rad]
};

}  // namespace

ChainEdge chainEdge(const ChainSide& chain, std::size_t edge) {
    const Segment& segment = segmentOf(chain, edge);
    const Vec2 along = segment.end - segment.start;
    const double length = along.norm();
    return {chain.pose * segment.start, chain.pose * segment.end, chain.pose.rotation * Vec2(along / length), length};
}

std::optional<ChainPlace> slideAlong(const ChainSide& chain, const ChainPlace& from, const ChainLaw& law, double time) {
    ChainSlide slide(chain, from, law, time);
    if (!slide.run()) return std::nullopt;
    return slide.place();
}

}  // namespace plumb
