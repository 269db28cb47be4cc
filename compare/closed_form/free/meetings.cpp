// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/meetings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <compare/closed_form/free/first_descent.h>

namespace plumb::compare {
namespace {

constexpr double approachLeast = 1e-9;  // a body slower than this touches a face, but does not approach it [m/s]
constexpr double endSlack = 1e-9;       // how exactly the end of a face is hit [m]

/// A point that moves at constant acceleration: x + v s + a s^2 / 2.
struct Path {
    Vec2 position{0, 0}, velocity{0, 0}, acceleration{0, 0};

    Vec2 at(double s) const { return position + velocity * s + acceleration * (s * s / 2); }
    Vec2 velocityAt(double s) const { return velocity + acceleration * s; }
    /// n.x - offset
    std::vector<double> along(const Vec2& n, double offset) const {
        return {n.dot(position) - offset, n.dot(velocity), n.dot(acceleration) / 2};
    }
    /// |x|^2 - reach^2
    std::vector<double> distance(double reach) const {
        return {position.squaredNorm() - reach * reach, 2 * position.dot(velocity),
                velocity.squaredNorm() + position.dot(acceleration), velocity.dot(acceleration),
                acceleration.squaredNorm() / 4};
    }
};

Path operator-(const Path& a, const Path& b) {
    return {a.position - b.position, a.velocity - b.velocity, a.acceleration - b.acceleration};
}

/// The path from a time on.
Path pathOf(const FreeBody& body, double time) {
    const Flight now = flightAt(body.flight, time);
    return {now.position, now.velocity, now.acceleration};
}

class Search {
public:
    Search(std::span<const FreeBody> bodies, const Wrap& wrap, double until)
        : bodies_(bodies), wrap_(wrap), end_(until) {
        for (const FreeBody& body : bodies) start_ = std::max(start_, body.flight.start);
    }

    std::optional<Meeting> first() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            for (const Face& face : bodies_[i].obstacles.faces) comeToFace(i, face);
            for (const Corner& corner : bodies_[i].obstacles.corners) comeToCorner(i, corner);
            for (std::size_t k = i + 1; k < bodies_.size(); ++k) comeToOther(i, k);
            stayOnFace(i);
        }
        return first_;
    }

private:
    double left() const { return end_ - start_; }

    void note(Meeting meeting, double s) {
        meeting.time = start_ + s;
        end_ = meeting.time;
        first_ = std::move(meeting);
    }

    /// Does the body spin without being a disc? Then it is treated as the disc around it, and it is not known how it
    /// lands.
    static bool tumbles(const FreeBody& body) { return !body.radius && body.flight.angularVelocity != 0; }

    void comeToFace(std::size_t i, const Face& face) {
        const FreeBody& body = bodies_[i];
        if (body.face == &face) return;
        const Path path = pathOf(body, start_) - Path{face.velocity * start_, face.velocity, {0, 0}};
        if (body.radius || tumbles(body)) {
            const double radius = body.radius.value_or(body.reach);
            touchFace(i, face, path, {0, 0}, radius);
            return;
        }
        for (const Vec2& corner : body.hull) touchFace(i, face, path, corner, body.skin);
    }

    void touchFace(std::size_t i, const Face& face, Path path, const Vec2& point, double radius) {
        path.position += point;
        const std::optional<double> s = firstDescent(path.along(face.normal, face.offset + radius), left());
        if (!s || -face.normal.dot(path.velocityAt(*s)) < approachLeast) return;
        const double along = tangentOf(face.normal).dot(path.at(*s));
        if (along < face.low - endSlack || along > face.high + endSlack) return;
        Meeting meeting{.kind = Meeting::Kind::Face, .body = i, .face = &face};
        if (tumbles(bodies_[i])) meeting = {.kind = Meeting::Kind::Unknown, .body = i, .why = "it lands turning"};
        if (face.turns) meeting = {.kind = Meeting::Kind::Unknown, .body = i, .why = "it meets what does not stay"};
        note(meeting, *s);
    }

    void comeToCorner(std::size_t i, const Corner& corner) {
        const FreeBody& body = bodies_[i];
        const Path path =
            pathOf(body, start_) - Path{corner.position + corner.velocity * start_, corner.velocity, {0, 0}};
        if (!body.radius && !tumbles(body)) {
            comeWithSide(i, corner, path);
            return;
        }
        const double reach = body.radius.value_or(body.reach) + corner.radius;
        const std::optional<double> s = firstDescent(path.distance(reach), left());
        if (!s || -path.at(*s).normalized().dot(path.velocityAt(*s)) < approachLeast) return;
        Meeting meeting{.kind = Meeting::Kind::Corner, .body = i, .corner = &corner};
        if (corner.turns || tumbles(body))
            meeting = {.kind = Meeting::Kind::Unknown, .body = i, .why = "it meets a corner, turning"};
        note(meeting, *s);
    }

    /// A corner hits one of the sides of a block. This turns the block.
    void comeWithSide(std::size_t i, const Corner& corner, const Path& path) {
        const std::vector<Vec2>& hull = bodies_[i].hull;
        for (std::size_t k = 0; k < hull.size(); ++k) {
            const Vec2 &a = hull[k], &b = hull[(k + 1) % hull.size()];
            const Vec2 out = -perp(Vec2(b - a)).normalized(), along = tangentOf(out);
            // Relative to the block, the corner moves along the opposite path.
            const Path seen = Path{} - path;
            const std::optional<double> s =
                firstDescent(seen.along(out, out.dot(a) + bodies_[i].skin + corner.radius), left());
            if (!s || -out.dot(seen.velocityAt(*s)) < approachLeast) continue;
            const double at = along.dot(seen.at(*s)), one = along.dot(a), other = along.dot(b);
            if (at <= std::min(one, other) + endSlack || at >= std::max(one, other) - endSlack) continue;
            note({.kind = Meeting::Kind::Unknown, .body = i, .why = "it meets a corner"}, *s);
        }
    }

    /// In a world that wraps, checks all images that it can reach.
    void comeToOther(std::size_t i, std::size_t k) {
        const FreeBody &a = bodies_[i], &b = bodies_[k];
        if (!mayTouch(a.scene->def, b.scene->def)) return;
        const Path path = pathOf(b, start_) - pathOf(a, start_);
        if (!wrap_.any()) {
            comeToImage(i, k, path, {0, 0});
            return;
        }
        const double way = (path.velocity.norm() + path.acceleration.norm() * left() / 2) * left();
        const auto reached = [&](const std::optional<double>& period, double apart) {
            const double reach = a.reach + b.reach + way;
            return period ? std::pair(static_cast<int>(std::floor((-reach - apart) / *period)),
                                      static_cast<int>(std::ceil((reach - apart) / *period)))
                          : std::pair(0, 0);
        };
        const auto [left, right] = reached(wrap_.width, path.position.x());
        const auto [down, up] = reached(wrap_.height, path.position.y());
        for (int x = left; x <= right; ++x)
            for (int y = down; y <= up; ++y)
                comeToImage(i, k, path, {x * wrap_.width.value_or(0), y * wrap_.height.value_or(0)});
    }

    void comeToImage(std::size_t i, std::size_t k, Path path, const Vec2& shift) {
        path.position += shift;
        const FreeBody &a = bodies_[i], &b = bodies_[k];
        const double reach = a.radius.value_or(a.reach) + b.radius.value_or(b.reach);
        const std::optional<double> s = firstDescent(path.distance(reach), left());
        if (!s) return;
        const double approach = -path.at(*s).normalized().dot(path.velocityAt(*s));
        if (approach < approachLeast) return;
        Meeting meeting{.kind = Meeting::Kind::Other, .body = i, .other = k, .shift = shift};
        if (!a.radius || !b.radius)
            meeting = {.kind = Meeting::Kind::Unknown,
                       .body = i,
                       .why = "it meets " + b.scene->name + ", and not both are discs"};
        note(meeting, *s);
    }

    void stayOnFace(std::size_t i) {
        const FreeBody& body = bodies_[i];
        if (!body.face) return;
        if (body.slipEnds && *body.slipEnds <= end_)
            note({.kind = Meeting::Kind::SlipEnd, .body = i}, std::max(0.0, *body.slipEnds - start_));
        const Face& face = *body.face;
        const Vec2 along = tangentOf(face.normal);
        const Path path =
            pathOf(body, start_) - Path{face.velocity * start_ - body.pressedAt * along, face.velocity, {0, 0}};
        for (const std::optional<double>& s :
             {firstDescent(path.along(along, face.low), left()), firstDescent(path.along(-along, -face.high), left())})
            if (s && start_ + *s <= end_) note({.kind = Meeting::Kind::FaceEnd, .body = i}, *s);
    }

    std::span<const FreeBody> bodies_;
    const Wrap& wrap_;
    double start_ = 0, end_;
    std::optional<Meeting> first_;
};

}  // namespace

std::optional<Meeting> nextMeeting(std::span<const FreeBody> bodies, const Wrap& wrap, double until) {
    return Search(bodies, wrap, until).first();
}

}  // namespace plumb::compare
