// SPDX-License-Identifier: MIT
#include <plumb/collide/manifold.h>
#include <algorithm>

#include <sstream>

#include "cases.h"
#include "catch.h"
#include "kit/collide/manifold_check.h"

namespace {

using namespace plumb;
using namespace plumb::test;

Manifold manifoldOf(const Placement& p) {
    return manifold(p.a, p.b, p.bInA, p.margin);
}

/// B's frame and A's exchanged. Rounded to float again: half a rounding of the place more.
Placement exchanged(const Placement& p) {
    Placement q = p;
    std::swap(q.a, q.b);
    const double c = p.bInA.cos, s = p.bInA.sin, x = p.bInA.position.x(), y = p.bInA.position.y();
    q.bInA = {{static_cast<float>(-c * x - s * y), static_cast<float>(s * x - c * y)}, p.bInA.cos, -p.bInA.sin};
    return q;
}

/// m, seen from B with the roles exchanged, against the manifold that B and A have.
const char* faultOfMirrorManifold(const Known& k, const Placement& p, const Manifold& m) {
    const Placement q = exchanged(p);
    const Manifold mirrored = manifoldOf(q);
    const double tolerance = 2 * k.tolerance + (k.favoured || !k.clear ? k.favour : 0);
    if ((m.count == 0) != (mirrored.count == 0))
        return std::fabs(k.gap.separation - k.margin) < tolerance ? nullptr : "B sees a contact that A does not";
    if (m.count == 0) return nullptr;
    if (std::fabs(leastSeparation(m) - leastSeparation(mirrored)) > tolerance) return "B sees another separation";
    if (!k.clear) return nullptr;
    const Vec2f n{p.bInA.cos * mirrored.normal.x() - p.bInA.sin * mirrored.normal.y(),
                  p.bInA.sin * mirrored.normal.x() + p.bInA.cos * mirrored.normal.y()};
    const double blur = 1e-6 + (isBetweenCorners(m) || isBetweenCorners(mirrored) ? 2 * k.cornerBlur : 0);
    return (n + m.normal).norm() > blur ? "B sees another normal" : nullptr;
}

std::string describePlacement(const Placement& p, int index) {
    std::ostringstream text;
    text.precision(9);
    const Known k = knownOf(p);
    text << "gap " << k.gap.separation << " along (" << k.gap.normal.x << ", " << k.gap.normal.y << "), favour "
         << k.favour << (k.favoured ? " used" : "") << ", tolerance " << k.tolerance << "; placement " << index
         << ", regime " << static_cast<int>(p.regime) << ", size " << p.size << ", margin " << p.margin << ", pose "
         << p.bInA.position.transpose() << " cos " << p.bInA.cos << " sin " << p.bInA.sin;
    for (const Convex* c : {&p.a, &p.b}) {
        text << "\n  radius " << c->radius << " corners";
        for (std::size_t i = 0; i < static_cast<std::size_t>(c->count); ++i)
            text << " (" << c->vertices[i].transpose() << ")";
    }
    for (const Placement& q : {p, exchanged(p)}) {
        const Manifold m = manifoldOf(q);
        text << "\n  count " << m.count << " normal " << m.normal.transpose();
        for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i)
            text << "\n  point " << m.points[i].position.transpose() << " separation " << m.points[i].separation
                 << " feature " << std::hex << m.points[i].feature << std::dec;
    }
    return text.str();
}

/// What 10,000 placements of one pair of kinds have shown.
struct ManifoldTally {
    int faults = 0, contacts = 0, pairsOfPoints = 0, favoured = 0;
    double worst = 0;  ///< error of the separation as a part of the size, where A's edge was not favoured
    std::string first;
};

ManifoldTally tallyOfManifolds(Kind kindA, Kind kindB) {
    Random random(1000 + 10 * static_cast<std::uint64_t>(kindA) + static_cast<std::uint64_t>(kindB));
    ManifoldTally tally;
    for (int i = 0; i < allCases(10'000); ++i) {
        const Placement p = randomPlacement(random, kindA, kindB);
        const Known known = knownOf(p);
        const Manifold m = manifoldOf(p);
        const char* fault = faultOf(known, m);
        if (!fault) fault = faultOfMirrorManifold(known, p, m);
        if (fault && tally.faults++ == 0) tally.first = fault + ("; " + describePlacement(p, i));
        if (m.count == 0) continue;
        ++tally.contacts;
        tally.pairsOfPoints += m.count == 2;
        tally.favoured += known.favoured;
        if (!known.favoured)
            tally.worst = std::max(tally.worst, std::fabs(leastSeparation(m) - known.gap.separation) / p.size);
    }
    return tally;
}

}  // namespace

TEST_CASE("manifolds of 10,000 placements of each pair of shapes agree with the Minkowski difference", "[collide]") {
    for (const Kind a : kinds) {
        for (const Kind b : kinds) {
            const ManifoldTally tally = tallyOfManifolds(a, b);
            INFO(nameOf(a) << " and " << nameOf(b) << ": " << tally.contacts << " contacts, " << tally.pairsOfPoints
                           << " of two points, " << tally.favoured << " where A's edge was favoured, worst error "
                           << tally.worst << " of the size; first fault: " << tally.first);
            CHECK(tally.faults == 0);
            CHECK(tally.contacts > allCases(4000));
        }
    }
}

TEST_CASE("a fault planted in a manifold is found, whatever it is", "[collide]") {
    Random random(3);
    int looked = 0, twoPoints = 0;
    int flipped = 0, turned = 0, deeper = 0, lifted = 0, missing = 0, beyond = 0, aside = 0, dropped = 0;
    while (looked < 2000) {
        const Kind a = randomKind(random), b = randomKind(random);
        const Placement p = randomPlacement(random, a, b);
        const Known known = knownOf(p);
        const Manifold m = manifoldOf(p);
        // Deep inside, other directions may be as good; at the margin, and between corners that touch, rounding
        // decides.
        const bool deep = p.regime == Regime::Deep || p.regime == Regime::Degenerate || p.regime == Regime::Corners;
        if (deep || m.count == 0 || known.gap.separation > known.margin - 0.01 * p.size) continue;
        ++looked;
        const auto finds = [&](auto&& plant) {
            Manifold wrong = m;
            plant(wrong);
            return faultOf(known, wrong) != nullptr;
        };
        const float size = static_cast<float>(p.size);
        flipped += finds([](Manifold& w) { w.normal = -w.normal; });
        turned += finds([](Manifold& w) { w.normal += 0.05f * perp(w.normal); });
        deeper += finds([&](Manifold& w) { w.points[0].separation -= 1e-3f * size; });
        lifted += finds([&](Manifold& w) { w.points[0].position += 1e-3f * size * w.normal; });
        missing += finds([](Manifold& w) { w.count = 0; });
        beyond += finds([&](Manifold& w) {
            w.count = 2;
            w.points[1] = w.points[0];
            w.points[1].separation = p.margin + size;
        });
        if (m.count < 2) continue;
        ++twoPoints;
        aside += finds([&](Manifold& w) { w.points[1].position += 1e-2f * size * perp(w.normal); });
        dropped += finds([](Manifold& w) { w.count = 1; });
    }
    CHECK(flipped == looked);
    CHECK(turned == looked);
    CHECK(deeper == looked);
    CHECK(lifted == looked);
    CHECK(missing == looked);
    CHECK(beyond == looked);
    // Where rounding decides which edge faces the other, or the stretch is as short as its tolerance, nobody looks.
    CHECK(twoPoints > 400);
    CHECK(aside > 0.99 * twoPoints);
    CHECK(dropped > 0.99 * twoPoints);
}
