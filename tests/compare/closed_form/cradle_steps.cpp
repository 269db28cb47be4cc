// SPDX-License-Identifier: MIT
#include "compare/closed_form/cradle_steps.h"

#include <algorithm>
#include <cmath>

#include <plumb/shapes/mass.h>

namespace plumb::compare {
namespace {

/// theta'' = -rate sin theta, by the classical method of Runge and Kutta.
struct Hanging {
    double angle = 0, turning = 0, rate = 1;

    void step(double h) {
        const auto pull = [this](double a) { return -rate * std::sin(a); };
        const double k1 = pull(angle), w2 = turning + h / 2 * k1;
        const double k2 = pull(angle + h / 2 * turning), w3 = turning + h / 2 * k2;
        const double k3 = pull(angle + h / 2 * w2), w4 = turning + h * k3;
        const double k4 = pull(angle + h * w3);
        angle += h / 6 * (turning + 2 * w2 + 2 * w3 + w4);
        turning += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
};

struct Disc {
    Vec2 hinge{0, 0};
    double length = 1, radius = 1, bodyAngle = 0, startAngle = 0;
    Hanging swing{};

    Vec2 place() const { return hinge + length * Vec2(std::sin(swing.angle), -std::cos(swing.angle)); }
};

bool overlap(const std::vector<Disc>& discs) {
    for (std::size_t i = 0; i + 1 < discs.size(); ++i)
        if (discs[i].swing.turning > discs[i + 1].swing.turning + 1e-9 &&
            (discs[i + 1].place() - discs[i].place()).norm() < discs[i].radius + discs[i + 1].radius - 1e-13)
            return true;
    return false;
}

void swapSpeeds(std::vector<Disc>& discs) {
    bool again = true;
    while (again) {
        again = false;
        for (std::size_t i = 0; i + 1 < discs.size(); ++i) {
            double &left = discs[i].swing.turning, &right = discs[i + 1].swing.turning;
            const double gap = (discs[i + 1].place() - discs[i].place()).norm() - discs[i].radius - discs[i + 1].radius;
            if (gap > 1e-6 || left <= right + 1e-9) continue;
            std::swap(left, right);
            again = true;
        }
    }
}

void cradleStep(std::vector<Disc>& discs, double h) {
    const std::vector<Disc> before = discs;
    const auto moved = [&](double part) {
        std::vector<Disc> after = before;
        for (Disc& disc : after) disc.swing.step(part);
        return after;
    };
    discs = moved(h);
    if (!overlap(discs)) return;
    double low = 0, high = h;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (overlap(moved(middle)) ? high : low) = middle;
    }
    discs = moved(high);
    swapSpeeds(discs);
    for (Disc& disc : discs) disc.swing.step(h - high);
}

}  // namespace

std::vector<std::vector<BodyState>> cradleSteps(const Scene& scene, const std::vector<double>& times) {
    std::vector<Disc> discs;
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        const Vec2 hinge = std::get<RevoluteJointDef>(scene.joints[i - 1].def).anchor, arm = def.position - hinge;
        const Mass mass = massOf(def);
        const double angle = std::atan2(arm.x(), -arm.y()), l = arm.norm();
        const double rate = mass.mass * -scene.gravity.y() * l / (mass.inertia + mass.mass * l * l);
        discs.push_back({hinge, l, std::get<Circle>(def.shapes[0].shape).radius, def.angle, angle, {angle, 0, rate}});
    }
    std::vector<std::vector<BodyState>> rows;
    double now = 0;
    for (const double time : times) {
        while (now < time - 1e-12) {
            const double h = std::min(1e-3, time - now);
            cradleStep(discs, h);
            now += h;
        }
        rows.push_back({BodyState{}});
        for (const Disc& disc : discs)
            rows.back().push_back({disc.place(), disc.bodyAngle + disc.swing.angle - disc.startAngle, {0, 0}, 0});
    }
    return rows;
}

std::vector<std::vector<BodyState>> ballisticSteps(const Scene& scene, const std::vector<double>& times) {
    const BodyDef &block = scene.bodies[1].def, &bullet = scene.bodies[2].def;
    const double length = (std::get<DistanceJointDef>(scene.joints[0].def).anchorA -
                           std::get<DistanceJointDef>(scene.joints[0].def).anchorB)
                              .norm();
    const auto& front = std::get<Polygon>(block.shapes[1].shape);
    double wall = 1e9;
    for (const Vec2& corner : front.vertices) wall = std::min(wall, block.position.x() + corner.x());
    const double speed = bullet.velocity.x(), radius = std::get<Circle>(bullet.shapes[0].shape).radius;
    const double impact = (wall - radius - bullet.position.x()) / speed;
    const double m = massOf(bullet).mass, together = m * speed / (m + massOf(block).mass);
    const Vec2 hit = bullet.position + impact * bullet.velocity;
    Hanging swing{0, together / length, -scene.gravity.y() / length};
    std::vector<std::vector<BodyState>> rows;
    double now = impact;
    for (const double time : times) {
        const Vec2 flown = bullet.position + time * bullet.velocity;
        rows.push_back({BodyState{}, {block.position, 0, {0, 0}, 0}, {flown, 0, {0, 0}, 0}});
        if (time <= impact) continue;
        while (now < time - 1e-12) {
            const double h = std::min(1e-3, time - now);
            swing.step(h);
            now += h;
        }
        const Vec2 moved = length * Vec2(std::sin(swing.angle), 1 - std::cos(swing.angle));
        rows.back()[1].position = block.position + moved;
        rows.back()[2].position = hit + moved;
    }
    return rows;
}

}  // namespace plumb::compare
