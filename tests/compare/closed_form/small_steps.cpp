// SPDX-License-Identifier: MIT
#include "compare/closed_form/small_steps.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <plumb/shapes/mass.h>

namespace plumb::compare {
namespace {

using Numbers = std::vector<double>;
using Slope = std::function<Numbers(const Numbers&)>;

Numbers plus(const Numbers& a, const Numbers& b, double share) {
    Numbers sum = a;
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += share * b[i];
    return sum;
}

Numbers stepOn(const Slope& slope, const Numbers& y, double h) {
    const Numbers k1 = slope(y), k2 = slope(plus(y, k1, h / 2)), k3 = slope(plus(y, k2, h / 2)),
                  k4 = slope(plus(y, k3, h));
    return plus(plus(plus(plus(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
}

constexpr double longestStep = 4e-3;  // [s]

/// The half plane in which a body starts, or that it may come back to.
struct HalfPlane {
    Vec2 point{0, 0}, normal{0, 1};
    const ShapeDef* shape = nullptr;
    std::size_t body = 0;
    double from = 0, to = 0;  ///< the side of it that is there, along (n.y, -n.x)
};

struct Mover {
    std::size_t body = 0;
    double m = 1, inertia = 1;
    double radius = -1;           ///< of a disc; < 0: a block
    std::vector<Vec2> corners{};  ///< of a block, from its middle
    const HalfPlane* lies = nullptr;
};

double mixOf(Mix rule, double a, double b) {
    if (rule == Mix::Maximum) return std::max(a, b);
    if (rule == Mix::GeometricMean) return std::sqrt(a * b);
    throw std::logic_error("a rule that no built-in scene has");
}

/// Of each body x, y, vx, vy, angle, w.
class Contacts {
public:
    explicit Contacts(const Scene& scene) : scene_(scene) {
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const BodyDef& def = scene.bodies[i].def;
            for (const double number : {def.position.x(), def.position.y(), def.velocity.x(), def.velocity.y(),
                                        def.angle, def.angularVelocity})
                y_.push_back(number);
            if (def.type == BodyType::Dynamic)
                addMover(i);
            else
                addPlanes(i);
        }
        for (Mover& mover : movers_) settle(mover);
    }

    void goTo(double time) {
        while (time_ < time - 1e-13) {
            double h = std::min(longestStep, time - time_);
            const Numbers before = y_;
            Numbers after = stepped(h);
            if (happens(before, after)) {
                double low = 0, high = h;
                for (int i = 0; i < 60; ++i) {
                    const double middle = (low + high) / 2;
                    (happens(before, stepped(middle)) ? high : low) = middle;
                }
                h = high;
                after = stepped(h);
                y_ = after;
                time_ += h;
                happen(before);
                continue;
            }
            y_ = after;
            time_ += h;
        }
    }

    std::vector<BodyState> states() const {
        std::vector<BodyState> states;
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
            states.push_back({scene_.wrap.place(placeOf(y_, i)), y_[6 * i + 4], velocityOf(y_, i), y_[6 * i + 5]});
        return states;
    }

private:
    static Vec2 placeOf(const Numbers& y, std::size_t i) { return {y[6 * i], y[6 * i + 1]}; }
    static Vec2 velocityOf(const Numbers& y, std::size_t i) { return {y[6 * i + 2], y[6 * i + 3]}; }
    void setVelocity(std::size_t i, const Vec2& v) { y_[6 * i + 2] = v.x(), y_[6 * i + 3] = v.y(); }

    void addMover(std::size_t i) {
        const BodyDef& def = scene_.bodies[i].def;
        const Mass mass = massOf(def);
        Mover mover{.body = i, .m = mass.mass, .inertia = mass.inertia};
        const Shape& shape = def.shapes.at(0).shape;
        if (const auto* circle = std::get_if<Circle>(&shape)) mover.radius = circle->radius;
        const double c = std::cos(def.angle), s = std::sin(def.angle);
        const auto turned = [&](const Vec2& v) { return Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y()); };
        if (const auto* polygon = std::get_if<Polygon>(&shape))
            for (const Vec2& corner : polygon->vertices) mover.corners.push_back(turned(corner));
        if (const auto* capsule = std::get_if<Capsule>(&shape))
            for (const Vec2& end : {capsule->start, capsule->end})
                for (const Vec2& out : {Vec2(0, -capsule->radius), Vec2(0, capsule->radius)})
                    mover.corners.push_back(turned(end + out));
        movers_.push_back(mover);
    }

    void addPlanes(std::size_t i) {
        const BodyDef& def = scene_.bodies[i].def;
        for (const ShapeDef& shape : def.shapes) {
            if (shape.sensor || shape.filter.mask == 0) continue;
            std::vector<Vec2> ring;
            if (const auto* polygon = std::get_if<Polygon>(&shape.shape)) ring = polygon->vertices;
            if (const auto* line = std::get_if<Segment>(&shape.shape)) ring = {line->start, line->end};
            if (const auto* map = std::get_if<TileMap>(&shape.shape)) {
                const double w = map->columns() * map->size(), h = map->rows() * map->size();
                ring = {{0, 0}, {w, 0}, {w, h}, {0, h}};
            }
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const double c = std::cos(def.angle), s = std::sin(def.angle);
                const auto there = [&](const Vec2& v) {
                    return Vec2(def.position + Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y()));
                };
                const Vec2 a = there(ring[k]), b = there(ring[(k + 1) % ring.size()]);
                const Vec2 way = (b - a).normalized(), out(way.y(), -way.x());
                if (shape.oneWay && shape.oneWay->dot(out) < 0.5) continue;
                const Vec2 along(out.y(), -out.x());
                planes_.push_back(
                    {a, out, &shape, i, std::min(along.dot(a), along.dot(b)), std::max(along.dot(a), along.dot(b))});
            }
        }
    }

    Vec2 fall(std::size_t body) const { return scene_.gravity * scene_.bodies[body].def.gravityScale; }

    double gap(const Numbers& y, const Mover& mover, const HalfPlane& plane) const {
        const double center = plane.normal.dot(placeOf(y, mover.body) - plane.point);
        if (mover.radius >= 0) return center - mover.radius;
        double least = 1e9;
        for (const Vec2& corner : mover.corners) least = std::min(least, center + plane.normal.dot(corner));
        return least;
    }
    bool over(const Numbers& y, const Mover& mover, const HalfPlane& plane) const {
        const double at = Vec2(plane.normal.y(), -plane.normal.x()).dot(placeOf(y, mover.body));
        return at > plane.from && at < plane.to;
    }

    /// Does a face carry it from now on?
    void settle(Mover& mover) {
        mover.lies = nullptr;
        for (const HalfPlane& plane : planes_) {
            const Vec2 v = velocityOf(y_, mover.body);
            if (std::abs(gap(y_, mover, plane)) < 1e-7 && std::abs(plane.normal.dot(v)) < 1e-7 &&
                over(y_, mover, plane) && fall(mover.body).dot(plane.normal) < 0)
                mover.lies = &plane;
        }
    }

    double slip(const Numbers& y, const Mover& mover) const {
        const HalfPlane& plane = *mover.lies;
        const double rim = std::max(0.0, mover.radius) * y[6 * mover.body + 5];
        return Vec2(plane.normal.y(), -plane.normal.x()).dot(velocityOf(y, mover.body)) + rim -
               plane.shape->material.surfaceSpeed;
    }

    Numbers slopes(const Numbers& y) const {
        Numbers dy(y.size(), 0);
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            dy[6 * i] = y[6 * i + 2], dy[6 * i + 1] = y[6 * i + 3], dy[6 * i + 4] = y[6 * i + 5];
        }
        for (const Mover& mover : movers_) {
            const std::size_t i = mover.body;
            Vec2 force = mover.m * fall(i) - mover.m * scene_.bodies[i].def.linearDamping * velocityOf(y, i);
            for (const SceneField& field : scene_.fields)
                if (const auto* air = std::get_if<Drag>(&field.def.law)) {
                    const Vec2 v = velocityOf(y, i) - air->wind;
                    force -= (air->linear + air->quadratic * v.norm()) * v;
                }
            double torque = 0;
            if (mover.lies) {
                const Vec2 n = mover.lies->normal, along(n.y(), -n.x());
                const double press = -force.dot(n);
                const Material &a = mover.lies->shape->material, &b = scene_.bodies[i].def.shapes[0].material;
                const double most = mixOf(a.frictionMix, a.friction, b.friction) * press, s = slipNow_[i];
                // What it takes to go on without a slip: (F + pull) / m + F r^2 / I = 0.
                const double hold =
                    mover.radius >= 0 ? -force.dot(along) / (1 + mover.m * mover.radius * mover.radius / mover.inertia)
                                      : -force.dot(along);
                double rub = std::min(std::max(hold, -most), most);
                if (s > 0) rub = -most;
                if (s < 0) rub = most;
                force += press * n + rub * along;
                torque += std::max(0.0, mover.radius) * rub;
            }
            dy[6 * i + 2] = force.x() / mover.m, dy[6 * i + 3] = force.y() / mover.m;
            dy[6 * i + 5] = torque / mover.inertia;
        }
        return dy;
    }

    /// With the directions of friction that hold at its start.
    Numbers stepped(double h) {
        slipNow_.assign(scene_.bodies.size(), 0);
        for (const Mover& mover : movers_)
            if (mover.lies && std::abs(slip(y_, mover)) > 1e-10) slipNow_[mover.body] = slip(y_, mover) > 0 ? 1 : -1;
        return stepOn([this](const Numbers& y) { return slopes(y); }, y_, h);
    }

    double discGap(const Numbers& y, const Mover& a, const Mover& b) const {
        const Vec2 apart =
            scene_.wrap.shortest(scene_.wrap.place(placeOf(y, a.body)), scene_.wrap.place(placeOf(y, b.body)));
        return apart.norm() - a.radius - b.radius;
    }
    bool meet(const Mover& a, const Mover& b) const {
        const Filter &f = scene_.bodies[a.body].def.shapes[0].filter, &g = scene_.bodies[b.body].def.shapes[0].filter;
        return a.radius >= 0 && b.radius >= 0 && !(f.group < 0 && f.group == g.group);
    }

    bool fallsThrough(double before, double after) const { return before > after && after < 0 && before > -1e-9; }

    bool happens(const Numbers& before, const Numbers& after) const {
        for (const Mover& mover : movers_) {
            for (const HalfPlane& plane : planes_)
                if (mover.lies != &plane && over(before, mover, plane) && !touches(before, mover, plane) &&
                    fallsThrough(gap(before, mover, plane), gap(after, mover, plane)))
                    return true;
            if (mover.lies && slipNow_[mover.body] != 0 && slip(after, mover) * slipNow_[mover.body] < 0) return true;
        }
        for (std::size_t i = 0; i < movers_.size(); ++i)
            for (std::size_t k = i + 1; k < movers_.size(); ++k)
                if (meet(movers_[i], movers_[k]) && comes(before, movers_[i], movers_[k]) &&
                    fallsThrough(discGap(before, movers_[i], movers_[k]), discGap(after, movers_[i], movers_[k])))
                    return true;
        return false;
    }
    bool touches(const Numbers& y, const Mover& mover, const HalfPlane& plane) const {
        return std::abs(gap(y, mover, plane)) < 1e-9 && plane.normal.dot(velocityOf(y, mover.body)) > -1e-9;
    }
    bool comes(const Numbers& y, const Mover& a, const Mover& b) const {
        const Vec2 apart =
            scene_.wrap.shortest(scene_.wrap.place(placeOf(y, a.body)), scene_.wrap.place(placeOf(y, b.body)));
        return apart.dot(velocityOf(y, b.body) - velocityOf(y, a.body)) < -1e-9;
    }

    void happen(const Numbers& before) {
        for (Mover& mover : movers_) {
            if (mover.lies && slipNow_[mover.body] != 0 && slip(y_, mover) * slipNow_[mover.body] <= 0) endSlip(mover);
            for (const HalfPlane& plane : planes_)
                if (mover.lies != &plane && over(before, mover, plane) && !touches(before, mover, plane) &&
                    fallsThrough(gap(before, mover, plane), gap(y_, mover, plane)))
                    bounce(mover, plane);
        }
        for (std::size_t i = 0; i < movers_.size(); ++i)
            for (std::size_t k = i + 1; k < movers_.size(); ++k)
                if (meet(movers_[i], movers_[k]) && comes(before, movers_[i], movers_[k]) &&
                    fallsThrough(discGap(before, movers_[i], movers_[k]), discGap(y_, movers_[i], movers_[k])))
                    knock(movers_[i], movers_[k]);
        for (Mover& mover : movers_) settle(mover);
    }

    void endSlip(const Mover& mover) {
        const double left = slip(y_, mover);
        if (mover.radius >= 0)
            y_[6 * mover.body + 5] -= left / mover.radius;
        else
            setVelocity(mover.body,
                        velocityOf(y_, mover.body) - left * Vec2(mover.lies->normal.y(), -mover.lies->normal.x()));
    }

    void bounce(Mover& mover, const HalfPlane& plane) {
        const std::size_t i = mover.body;
        const Vec2 n = plane.normal, along(n.y(), -n.x());
        const Material &a = plane.shape->material, &b = scene_.bodies[i].def.shapes[0].material;
        const double e = std::max(a.restitution, b.restitution), mu = std::sqrt(a.friction * b.friction);
        const Vec2 v = velocityOf(y_, i);
        const double into = -v.dot(n), push = mover.m * (1 + e) * into, r = std::max(0.0, mover.radius);
        const double s = v.dot(along) + r * y_[6 * i + 5];
        const double stop = -s / (1 / mover.m + r * r / mover.inertia);
        const double rub = std::abs(stop) <= mu * push ? stop : std::copysign(mu * push, stop);
        Vec2 after = v + (push * n + rub * along) / mover.m;
        const double g = -fall(i).dot(n);
        if (g > 0 && 2 * after.dot(n) / g <= 1.0 / 30) after -= after.dot(n) * n;  // as the scenes' closed forms count
        setVelocity(i, after);
        y_[6 * i + 5] += r * rub / mover.inertia;
        const Vec2 lift = -gap(y_, mover, plane) * n;
        y_[6 * i] += lift.x(), y_[6 * i + 1] += lift.y();
    }

    void knock(const Mover& a, const Mover& b) {
        const Vec2 n =
            scene_.wrap.shortest(scene_.wrap.place(placeOf(y_, a.body)), scene_.wrap.place(placeOf(y_, b.body)))
                .normalized();
        const Material &one = scene_.bodies[a.body].def.shapes[0].material,
                       &other = scene_.bodies[b.body].def.shapes[0].material;
        if (one.friction * other.friction > 0) throw std::logic_error("rough discs are in no built-in scene");
        const double e = std::max(one.restitution, other.restitution);
        const double into = (velocityOf(y_, a.body) - velocityOf(y_, b.body)).dot(n);
        const double push = (1 + e) * into * a.m * b.m / (a.m + b.m);
        setVelocity(a.body, velocityOf(y_, a.body) - push / a.m * n);
        setVelocity(b.body, velocityOf(y_, b.body) + push / b.m * n);
    }

    const Scene& scene_;
    Numbers y_, slipNow_;
    std::vector<HalfPlane> planes_;
    std::vector<Mover> movers_;
    double time_ = 0;
};

}  // namespace

std::vector<std::vector<BodyState>> smallSteps(const Scene& scene, const std::vector<double>& times) {
    Contacts contacts(scene);
    std::vector<std::vector<BodyState>> rows;
    for (const double time : times) {
        contacts.goTo(time);
        rows.push_back(contacts.states());
    }
    return rows;
}

}  // namespace plumb::compare
