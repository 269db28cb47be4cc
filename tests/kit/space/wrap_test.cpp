// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <plumb/math/random.h>
#include <plumb/space/detail/space.h>

#include "cases.h"
#include "catch.h"

namespace plumb::test {

namespace {

using Found = std::tuple<ProxyId, ProxyId, double, double>;  // a, b, and rounds that b is shifted by

Aabb shifted(const Aabb& box, const Vec2& shift) {
    return {box.lower + shift, box.upper + shift};
}

/// A space that wraps, and what is known of it without one: all boxes, now and at the last look.
class Twin {
public:
    Twin(Random& random, const Wrap& around)
        : wrap(around), space(random.integer(0, 1) == 0 ? 16 : 1, around), random_(random) {}

    void add() {
        const bool fixed = random_.integer(0, 3) == 0;
        const Aabb box = anyBox();
        const ProxyId id =
            space.add(circle(0.1), static_cast<std::uint32_t>(random_.integer(0, 30)), fixed, {0, 0}, box);
        if (id >= alive.size()) {
            alive.resize(id + 1);
            was.resize(id + 1);
        }
        alive[id] = true;
        was[id].reset();
    }
    void stepOne(ProxyId id) {
        if (!alive[id]) return;
        const int what = random_.integer(0, 99);
        if (what < 4) {
            space.remove(id);
            alive[id] = false;
            return;
        }
        if (what < 8) {
            space.markNew(id);
            was[id].reset();
        }
        if (what < 50) {
            const Aabb& box = space.box(id);
            const double far = what < 12 ? 3 * size() : 0.3;
            const Vec2 by(random_.uniform(-far, far), random_.uniform(-far, far));
            space.place(id, shifted(inflate(box, -0.01), by), 0.01);
        }
    }
    Aabb anyBox() {
        const double spread = random_.integer(0, 9) == 0 ? 40 : 2;
        const Vec2 at(random_.uniform(-spread, spread) * size(), random_.uniform(-spread, spread) * size());
        const double largest = random_.integer(0, 5) == 0 ? 1.4 * size() : 0.2;
        Vec2 half(random_.uniform(0.02, largest), random_.uniform(0.02, largest));
        if (random_.integer(0, 9) == 0) half.x() = 0.5 * size();  // a floor as long as the world
        return {at - half, at + half};
    }
    double size() const { return wrap.width.value_or(wrap.height.value_or(1)); }

    /// Calls visit(rounds, shift) for all that could make a difference between boxes that lie within some rounds.
    template <class Visit>
    void forEachShift(const Aabb& still, const Aabb& box, Visit&& visit) const {
        const auto range = [](double lower, double upper, const std::optional<double>& round) {
            return round ? std::pair(std::floor(lower / *round) - 2, std::ceil(upper / *round) + 2)
                         : std::pair(0.0, 0.0);
        };
        const Vec2 lower = still.lower - box.upper, upper = still.upper - box.lower;
        const auto [x0, x1] = range(lower.x(), upper.x(), wrap.width);
        const auto [y0, y1] = range(lower.y(), upper.y(), wrap.height);
        for (double x = x0; x <= x1; ++x)
            for (double y = y0; y <= y1; ++y) {
                const Vec2 shift(x * wrap.width.value_or(0), y * wrap.height.value_or(0));
                if (overlap(still, shifted(box, shift))) visit(Vec2(x, y), shift);
            }
    }
    std::multiset<Found> newPairs() const {
        std::multiset<Found> pairs;
        for (ProxyId a = 0; a < alive.size(); ++a)
            for (ProxyId b = a + 1; b < alive.size(); ++b) {
                if (!alive[a] || !alive[b] || !mayPair(space[a], space[b])) continue;
                forEachShift(space.box(a), space.box(b), [&](const Vec2& rounds, const Vec2& shift) {
                    if (was[a] && was[b] && overlap(*was[a], shifted(*was[b], shift))) return;
                    pairs.emplace(a, b, rounds.x(), rounds.y());
                });
            }
        return pairs;
    }
    void settle() {
        for (ProxyId id = 0; id < alive.size(); ++id)
            if (alive[id]) was[id] = space.box(id);
    }
    Vec2 roundsOf(const Vec2& shift) const {
        return {wrap.width ? std::round(shift.x() / *wrap.width) : 0,
                wrap.height ? std::round(shift.y() / *wrap.height) : 0};
    }

    Wrap wrap;
    Space space;
    std::vector<bool> alive;
    std::vector<std::optional<Aabb>> was;

private:
    Random& random_;
};

Wrap anyWrap(Random& random) {
    const double width = random.uniform(0.7, 9), height = width * random.uniform(0.5, 2);
    switch (random.integer(0, 2)) {
        case 0: return {.width = width};
        case 1: return {.height = height};
        default: return {.width = width, .height = height};
    }
}

/// Of what is in a box, by shape and rounds, as the space says and as each box says.
bool answersBox(const Twin& twin, const Aabb& box) {
    std::multiset<Found> told, known;
    twin.space.query(box, [&](ProxyId id, const Vec2& shift) {
        const Vec2 rounds = twin.roundsOf(shift);
        told.emplace(id, 0, rounds.x(), rounds.y());
    });
    for (ProxyId id = 0; id < twin.alive.size(); ++id)
        if (twin.alive[id])
            twin.forEachShift(box, twin.space.box(id),
                              [&](const Vec2& rounds, const Vec2&) { known.emplace(id, 0, rounds.x(), rounds.y()); });
    return told == known;
}

/// All that a moving box meets is told of, with every shift.
bool answersCast(const Twin& twin, const Vec2& half, const Vec2& from, const Vec2& to) {
    std::set<Found> told;
    twin.space.castBox(half, from, to, [&](ProxyId id, const Vec2& shift) {
        const Vec2 rounds = twin.roundsOf(shift);
        told.emplace(id, 0, rounds.x(), rounds.y());
        return 1.0;
    });
    const Aabb way{from.cwiseMin(to) - half, from.cwiseMax(to) + half};
    bool all = true;
    for (ProxyId id = 0; id < twin.alive.size(); ++id) {
        if (!twin.alive[id]) continue;
        twin.forEachShift(way, twin.space.box(id), [&](const Vec2& rounds, const Vec2& shift) {
            const Aabb box = shifted(twin.space.box(id), shift);
            // Surely met, roundings aside.
            const RayPart met = clipRay(from, to, inflate({box.lower - half, box.upper + half}, -1e-9));
            all = all && (met.first > met.last || told.count({id, 0, rounds.x(), rounds.y()}) == 1);
        });
    }
    return all;
}

double away(const Aabb& box, const Vec2& point) {
    return (box.lower - point).cwiseMax(point - box.upper).cwiseMax(Vec2(0, 0)).norm();
}

/// The nearest box is as near as it is.
bool answersNear(const Twin& twin, const Vec2& point) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    double told = endless, known = endless;
    twin.space.findNear(point, endless, [&](ProxyId id, const Vec2& shift) {
        return told = std::min(told, away(shifted(twin.space.box(id), shift), point));
    });
    const Vec2 reach(twin.wrap.width.value_or(1e6), twin.wrap.height.value_or(1e6));
    for (ProxyId id = 0; id < twin.alive.size(); ++id)
        if (twin.alive[id])
            twin.forEachShift({point - reach, point + reach}, twin.space.box(id), [&](const Vec2&, const Vec2& shift) {
                known = std::min(known, away(shifted(twin.space.box(id), shift), point));
            });
    return told == known || std::fabs(told - known) < 1e-9;
}

}  // namespace

TEST_CASE("a space that wraps finds in 1,000 scenes the pairs that there are with any shift", "[space][wrap][tiles]") {
    Random random(20);
    int wrong = 0;
    int met = 0, around = 0;
    for (int scene = 0; scene < cases(1000); ++scene) {
        Twin twin(random, anyWrap(random));
        for (int i = random.integer(2, 25); i > 0; --i) twin.add();
        for (int look = 0; look < 8; ++look) {
            const std::multiset<Found> expected = twin.newPairs();
            std::multiset<Found> found;
            const SortedPairs& pairs = twin.space.findNewPairs();
            REQUIRE(twin.space.newPairShifts().size() == pairs.size());
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const Vec2 rounds = twin.roundsOf(twin.space.newPairShifts()[i]);
                found.emplace(pairs[i].a, pairs[i].b, rounds.x(), rounds.y());
                around += rounds.isZero(0) ? 0 : 1;
            }
            wrong += found == expected ? 0 : 1;
            met += static_cast<int>(found.size());
            twin.settle();
            for (ProxyId id = 0; id < twin.alive.size(); ++id) twin.stepOne(id);
            if (random.integer(0, 1) == 0) twin.add();
        }
    }
    CHECK(wrong == 0);
    CHECK(around > met / 4);
    CHECK(met > 10 * cases(1000));
}

TEST_CASE("10,000 boxes, casts and points are answered by a space that wraps as each box would",
          "[space][wrap][tiles]") {
    Random random(21);
    int boxes = 0, casts = 0, points = 0;
    for (int scene = 0; scene < cases(1000); ++scene) {
        Twin twin(random, anyWrap(random));
        for (int i = random.integer(1, 25); i > 0; --i) twin.add();
        for (int look = 0; look < 10; ++look) {
            const auto place = [&] {
                return Vec2(random.uniform(-4, 4) * twin.size(), random.uniform(-4, 4) * twin.size());
            };
            const double half = random.integer(0, 2) ? random.uniform(0, 1.5) : 0.0;
            const bool still = random.integer(0, 9) == 0;
            const Vec2 from = place(), to = still ? from : place();
            boxes += answersBox(twin, twin.anyBox()) ? 0 : 1;
            casts += answersCast(twin, {half, 0.5 * half}, from, to) ? 0 : 1;
            points += answersNear(twin, place()) ? 0 : 1;
            if (look % 2 == 0) {
                twin.space.findNewPairs();
                twin.settle();
            }
            for (ProxyId id = 0; id < twin.alive.size(); ++id) twin.stepOne(id);
            twin.add();
        }
    }
    CHECK(boxes == 0);
    CHECK(casts == 0);
    CHECK(points == 0);
}

TEST_CASE("what moves 1e6 worlds in a step is looked at in 16 of them, and met in the next", "[space][wrap][tiles]") {
    Space space(16, {.width = 2.0, .height = 3.0});
    const ProxyId wall = space.add(circle(0.1), 0, true, {0, 0}, {{1, 1}, {1.2, 1.2}});
    const ProxyId fast = space.add(circle(0.1), 1, false, {0, 0}, {{0, 0}, {2e6, 3e6}});
    CHECK(space.findNewPairs().size() == 256);
    CHECK_FALSE(space.hasAllImages(fast));
    space.place(fast, {{2e6 + 1, 3e6 + 1}, {2e6 + 1.1, 3e6 + 1.1}}, 0.01);
    space.findNewPairs();
    CHECK(space.hasAllImages(fast));
    std::size_t met = 0;
    space.query({{0.9, 0.9}, {1.3, 1.3}}, [&](ProxyId id, const Vec2& shift) {
        ++met;
        CHECK((id == wall ? Vec2(0, 0) : Vec2(-2e6, -3e6)) == shift);
    });
    CHECK(met == 2);
}

}  // namespace plumb::test
