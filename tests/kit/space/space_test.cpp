// SPDX-License-Identifier: MIT
#include <plumb/space/detail/space.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <plumb/math/random.h>

#include "catch.h"

using namespace plumb;

namespace {

constexpr double margin = 0.02;
const int laneCounts[] = {1, 4, 8, 16};

Aabb around(const Vec2& center, double half) {
    return {center - Vec2(half, half), center + Vec2(half, half)};
}

ShapeDef shapeOf(const Filter& filter) {
    return {.filter = filter};
}

/// What a twin knows of a shape; the rule is worked out from this for each two.
struct Known {
    bool alive = false, fixed = false, driven = false, sensor = false, old = false;
    std::uint32_t owner = 0;
    Filter filter;
    Vec2 center{0, 0};
    double half = 0;
    Aabb now, before;
};

bool accepted(const Known& a, const Known& b) {
    if (a.owner == b.owner) return false;
    if ((a.fixed && b.fixed) || (a.sensor && b.sensor)) return false;
    const bool bothUnpushed = (a.fixed || a.driven) && (b.fixed || b.driven);
    if (bothUnpushed && !a.sensor && !b.sensor) return false;
    if (a.filter.group == b.filter.group && a.filter.group > 0) return true;
    if (a.filter.group == b.filter.group && a.filter.group < 0) return false;
    return (a.filter.mask & b.filter.category) && (b.filter.mask & a.filter.category);
}

/// A kind of world: where a shape appears, how large, and how far it goes in a step.
struct Kind {
    const char* name;
    Vec2 (*place)(Random& random);
    double (*half)(Random& random);
    double speed;
};

double even(Random& r) {
    return r.uniform(0.2, 0.4);
}
Vec2 within(Random& r, double size) {
    return {r.uniform(-size, size), r.uniform(-size, size)};
}

const Kind kinds[] = {
    {"a crowd", [](Random& r) { return within(r, 4); }, even, 0.3},
    {"hardly moving", [](Random& r) { return within(r, 4); }, even, 0.004},
    {"a grid whose cells touch", [](Random& r) { return Vec2(r.integer(0, 7), r.integer(0, 7)); },
     [](Random&) { return 0.5 - margin; }, 0},
    {"sizes of 1 : 100", [](Random& r) { return within(r, 6); }, [](Random& r) { return std::exp(r.uniform(-4, 0.6)); },
     0.2},
    {"a column", [](Random& r) { return Vec2(0, r.uniform(0, 30)); }, even, 0.1},
    {"one point", [](Random&) { return Vec2(1, 2); }, even, 0.5},
    {"clusters 100 km apart",
     [](Random& r) { return Vec2(within(r, 2) + 1e5 * Vec2(r.integer(-1, 1), r.integer(-1, 1))); }, even, 0.3},
    {"at 1e9 m", [](Random& r) { return Vec2(within(r, 4) + Vec2(1e9, -3e9)); }, even, 0.3},
    {"one at 1e300 m", [](Random& r) { return r.integer(0, 20) ? within(r, 4) : Vec2(1e300, -1e300); }, even, 0.3},
    {"on the way from 0 to 1e6 m", [](Random& r) { return within(r, 3); }, even, 5e3},
    {"not everywhere a number",
     [](Random& r) { return r.integer(0, 9) ? within(r, 4) : Vec2(std::nan(""), r.uniform(-4, 4)); }, even, 0.3},
    {"some as wide as the world", [](Random& r) { return within(r, 4); },
     [](Random& r) { return r.integer(0, 9) ? 0.3 : std::numeric_limits<double>::infinity(); }, 0.3},
};

/// The same calls to a space for each number of lanes, and to a twin that asks each two.
class Twins {
public:
    Twins(const Kind& kind, std::uint64_t seed) : kind_(kind), random_(seed) {
        for (const int lanes : laneCounts) spaces_.push_back(std::make_unique<Space>(lanes));
    }

    void add() {
        Known known;
        known.alive = true;
        known.fixed = random_.integer(0, 4) == 0;
        known.driven = random_.integer(0, 3) == 0;
        known.sensor = random_.integer(0, 9) == 0;
        known.owner = static_cast<std::uint32_t>(random_.integer(0, 300));
        known.filter.group = random_.integer(-6, 2) / 2;
        known.filter.category = std::uint64_t{1} << random_.integer(0, 2);
        if (random_.integer(0, 3) == 0) known.filter.mask = static_cast<std::uint64_t>(random_.integer(0, 7));
        known.center = kind_.place(random_);
        known.half = kind_.half(random_);
        const Aabb tight = around(known.center, known.half);
        ShapeDef shape = shapeOf(known.filter);
        shape.sensor = known.sensor;
        ProxyId id = 0;
        for (const auto& space : spaces_) {
            id = space->add(shape, known.owner, known.fixed, {0, 0}, tight);
            space->setDriven(id, known.driven);
        }
        if (id >= known_.size()) known_.resize(id + 1);
        REQUIRE_FALSE(known_[id].alive);
        known_[id] = known;
        place(id);
    }
    void remove(ProxyId id) {
        for (const auto& space : spaces_) space->remove(id);
        known_[id].alive = false;
    }
    void renew(ProxyId id) {
        for (const auto& space : spaces_) space->markNew(id);
        known_[id].old = false;
    }
    void move(ProxyId id) {
        Known& known = known_[id];
        known.center += Vec2(random_.uniform(-1, 1), random_.uniform(-1, 1.5)) * kind_.speed;
        if (random_.integer(0, 400) == 0) known.center = kind_.place(random_);
        place(id);
    }
    /// One step in which one in so many moves; 0: none.
    void step(int movers) {
        for (ProxyId id = 0; id < known_.size(); ++id) {
            if (!known_[id].alive) continue;
            if (movers > 0 && random_.integer(1, movers) == 1) move(id);
            const int chance = random_.integer(0, 999);
            if (chance < 3) remove(id);
            if (chance >= 3 && chance < 6) renew(id);
        }
        for (int i = random_.integer(0, 60) - 57; i > 0; --i) add();
    }
    /// Counts what differs, and lets the twin take this look as the last.
    int compare() {
        const SortedPairs expected = newPairs();
        int wrong = 0;
        for (const auto& space : spaces_)
            if (space->findNewPairs() != expected) ++wrong;
        for (const auto& space : spaces_)
            if (space->work().blockTests != spaces_[0]->work().blockTests ||
                space->work().boxTests != spaces_[0]->work().boxTests)
                ++wrong;
        found_ += expected.size();
        return wrong;
    }
    /// Asks for what overlaps some boxes, of these kinds and where shapes are, before a look and after.
    int compareQueries() {
        int wrong = 0;
        for (int i = 0; i < 3; ++i) {
            const Aabb asked = around(kind_.place(random_), kind_.half(random_));
            std::vector<ProxyId> expected;
            for (ProxyId id = 0; id < known_.size(); ++id)
                if (known_[id].alive && overlap(known_[id].now, asked)) expected.push_back(id);
            for (const auto& space : spaces_) {
                std::vector<ProxyId> found;
                space->query(asked, [&](ProxyId id, const Vec2&) { found.push_back(id); });
                std::sort(found.begin(), found.end());
                if (found != expected) ++wrong;
            }
        }
        return wrong;
    }
    Random& random() { return random_; }
    std::size_t found() const { return found_; }

private:
    void place(ProxyId id) {
        const Aabb tight = around(known_[id].center, known_[id].half);
        for (const auto& space : spaces_) space->place(id, tight, margin);
        known_[id].now = spaces_[0]->box(id);
    }
    SortedPairs newPairs() {
        SortedPairs pairs;
        for (std::uint32_t a = 0; a < known_.size(); ++a)
            for (std::uint32_t b = a + 1; b < known_.size(); ++b) {
                const Known& first = known_[a];
                const Known& second = known_[b];
                if (!first.alive || !second.alive || !overlap(first.now, second.now)) continue;
                if (first.old && second.old && overlap(first.before, second.before)) continue;
                if (accepted(first, second)) pairs.push_back({a, b});
            }
        for (Known& known : known_) {
            known.before = known.now;
            known.old = true;
        }
        return pairs;
    }

    const Kind& kind_;
    Random random_;
    std::vector<std::unique_ptr<Space>> spaces_;
    std::vector<Known> known_;
    std::size_t found_ = 0;
};

std::uint64_t testsOf(const Space& space) {
    return space.work().blockTests + space.work().boxTests;
}

/// Boxes of 0.6 m, a metre apart, in a square; moving ones unless fixed.
std::vector<ProxyId> addSquare(Space& space, int side, const Vec2& corner, bool fixed = false) {
    std::vector<ProxyId> ids;
    for (int i = 0; i < side * side; ++i) {
        const Aabb box = around(corner + Vec2(i % side, i / side), 0.3);
        ids.push_back(space.add(circle(0.3), static_cast<std::uint32_t>(1'000'000 * fixed + i), fixed, {0, 0}, box));
    }
    return ids;
}

void lookAndShake(Space& space, ProxyId shaken, int looks) {
    for (int i = 0; i < looks; ++i) {
        space.place(shaken, around({-10, i % 2 ? 0.0 : 1.0}, 0.3), margin);
        space.findNewPairs();
    }
}

}  // namespace

TEST_CASE("the new pairs of 2,400 small worlds equal those of a twin that asks each two", "[space]") {
    int wrong = 0;
    std::size_t found = 0;
    for (const Kind& kind : kinds)
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            Twins twins(kind, seed);
            for (int i = twins.random().integer(0, 50); i > 0; --i) twins.add();
            for (int look = 0; look < 8; ++look) {
                wrong += twins.compare();
                twins.step(twins.random().integer(0, 8));
            }
            found += twins.found();
        }
    CHECK(wrong == 0);
    CHECK(found > 50'000);
}

TEST_CASE("new pairs and queries of 12 worlds equal those of a twin for 400 steps, through sleep and waking",
          "[space]") {
    for (const Kind& kind : kinds) {
        Twins twins(kind, 1);
        for (int i = 0; i < 200; ++i) twins.add();
        int wrong = 0;
        for (int look = 0; look < 400; ++look) {
            wrong += twins.compareQueries() + twins.compare() + twins.compareQueries();
            // All awake; then few, while the others rest; none; and all again.
            twins.step(look < 60 || look > 330 ? 1 : look < 300 ? 40 : look < 320 ? 0 : 3);
        }
        INFO(kind.name);
        CHECK(wrong == 0);
        CHECK(twins.found() > 100);
    }
}

TEST_CASE("a box is renewed when a shape leaves it or needs far less, and else stays", "[space]") {
    Space space;
    const ProxyId id = space.add(circle(0.3), 1, false, {0, 0}, around({0, 0}, 0.3));
    space.place(id, around({0, 0}, 0.3), 0.02);
    CHECK(space.box(id).upper.x() == 0.3);  // it still holds the shape
    space.place(id, around({0.001, 0}, 0.3), 0.02);
    CHECK(space.box(id).upper.x() == 0.001 + 0.3 + 0.02);
    const Aabb before = space.box(id);
    for (double x = 0.001; x < 0.02; x += 0.001) space.place(id, around({x, 0}, 0.3), 0.02);
    CHECK(space.box(id).upper == before.upper);
    space.place(id, around({0, 0}, 1), 0.02);
    CHECK(space.box(id).upper.x() == 1.02);
    space.place(id, around({0, 0}, 0.9), 0.02);  // 0.12 m to spare: more than four margins
    CHECK(space.box(id).upper.x() == 0.92);
}

TEST_CASE("boxes overlap now, or did at the last look, as the accessors tell", "[space]") {
    Space space;
    const ProxyId a = space.add(circle(1), 1, false, {0, 0}, around({0, 0}, 1));
    const ProxyId b = space.add(circle(1), 2, false, {0, 0}, around({1, 0}, 1));
    CHECK(space.boxesOverlap(a, b));
    CHECK_FALSE(space.previousBoxesOverlap(a, b));
    CHECK(space.findNewPairs() == SortedPairs{{a, b}});
    CHECK(space.previousBoxesOverlap(a, b));
    space.place(b, around({5, 0}, 1), margin);
    CHECK_FALSE(space.boxesOverlap(a, b));
    CHECK(space.previousBoxesOverlap(a, b));
    CHECK(space.findNewPairs().empty());
    CHECK_FALSE(space.previousBoxesOverlap(a, b));
}

TEST_CASE("of one group shapes collide always or never, else category and mask decide", "[space]") {
    const auto pairs = [](const Filter& a, const Filter& b) {
        Space space;
        space.add(shapeOf(a), 1, false, {0, 0}, around({0, 0}, 1));
        space.add(shapeOf(b), 2, false, {0, 0}, around({1, 0}, 1));
        const bool may = mayPair(space[0], space[1]);
        CHECK(may == (space.findNewPairs().size() == 1));
        return may;
    };
    CHECK(pairs({}, {}));
    CHECK_FALSE(pairs({.category = 2}, {.mask = 1}));
    CHECK_FALSE(pairs({.mask = 1}, {.category = 2}));
    CHECK(pairs({.category = 2, .group = 7}, {.mask = 1, .group = 7}));
    CHECK_FALSE(pairs({.category = 2, .group = 7}, {.mask = 1, .group = 8}));
    CHECK_FALSE(pairs({.group = -3}, {.group = -3}));
    CHECK(pairs({.group = -3}, {.group = -4}));
    CHECK(pairs({.group = -3}, {.group = 3}));
    CHECK_FALSE(pairs({.category = std::uint64_t{1} << 63}, {.mask = ~(std::uint64_t{1} << 63)}));
}

TEST_CASE("a look costs nothing while 10,000 shapes rest", "[space][work]") {
    Space space;
    addSquare(space, 100, {0, 0});
    space.findNewPairs();
    for (int i = 0; i < 10; ++i) space.findNewPairs();
    CHECK(space.work().placed == 0);
    CHECK(testsOf(space) == 0);
    CHECK(space.work().sorted == 0);
}

TEST_CASE("a shape that moves alone costs fewer than 100 tests among 10,000 that rest", "[space][work]") {
    Space space;
    addSquare(space, 100, {0, 0});
    addSquare(space, 100, {0, -200}, true);
    const ProxyId mover = space.add(circle(0.3), 2'000'000, false, {0, 0}, around({-10, 0}, 0.3));
    lookAndShake(space, mover, 200);
    std::uint64_t most = 0;
    std::size_t met = 0;
    for (int i = 0; i < 100; ++i) {
        space.place(mover, around({0.5 + i, 50.5}, 0.15), margin);
        met += space.findNewPairs().size();
        most = std::max(most, testsOf(space));
        CHECK(space.work().placed == 1);
        CHECK(space.work().sorted <= 1);
    }
    // Two hierarchies of 625 blocks, three levels above the boxes, and on each few blocks near; all of them are 1,250.
    CHECK(most < 100);
    CHECK(met == 0);  // it goes between them
}

TEST_CASE("what rests is not put in order again while a hundred shapes move for 300 steps", "[space][work]") {
    Space space;
    addSquare(space, 100, {0, 0});
    std::vector<ProxyId> movers;
    for (std::uint32_t i = 0; i < 100; ++i)
        movers.push_back(space.add(circle(0.3), 2'000'000 + i, false, {0, 0}, around({0, 0}, 0.3)));
    Random random(5);
    std::uint64_t tests = 0;
    for (int step = 0; step < 400; ++step) {
        for (const ProxyId id : movers) space.place(id, around(within(random, 100), 0.3), margin);
        space.findNewPairs();
        if (step < 100) continue;  // by then the others have come to rest
        CHECK(space.work().sorted <= 100);
        tests += testsOf(space);
    }
    // 100 boxes that ask one by one go down two hierarchies of four levels at most, a few blocks on each level; asked
    // for all together they would have met all of the 625 blocks that rest, seven times.
    CHECK(tests / 300 < 100 * 2 * 4 * 4);
}

TEST_CASE("shapes that are woken by the thousand are found again", "[space]") {
    Space space;
    const std::vector<ProxyId> ids = addSquare(space, 40, {0, 0});
    const ProxyId mover = space.add(circle(0.3), 2'000'000, false, {0, 0}, around({-10, 0}, 0.3));
    lookAndShake(space, mover, 200);
    for (std::size_t i = 0; i < ids.size(); ++i)
        space.place(ids[i], around(Vec2(0.7 * static_cast<double>(i % 40 + 1), static_cast<double>(i / 40)), 0.3),
                    0.06);
    // Rows drawn together to 0.7 m, boxes 0.72 m wide: each meets the next one of its row.
    CHECK(space.findNewPairs().size() == 40 * 39);
}

TEST_CASE("a hidden shape is met by nothing until it is placed and marked as new", "[space]") {
    Space space;
    const ProxyId a = space.add(shapeOf({}), 1, false, {0, 0}, around({0, 0}, 1));
    const ProxyId b = space.add(shapeOf({}), 2, false, {0, 0}, around({1, 0}, 1));
    const auto found = [&] {
        int count = 0;
        space.query(around({0, 0}, 5), [&](ProxyId) { ++count; });
        return count;
    };
    CHECK(space.findNewPairs().size() == 1);
    for (const bool looked : {true, false}) {
        space.hide(b);
        CHECK(found() == 1);
        if (looked) CHECK(space.findNewPairs().empty());
        space.place(b, around({1, 1}, 1), margin);
        space.markNew(b);
        CHECK(found() == 2);
        CHECK(space.findNewPairs() == SortedPairs{{a, b}});
    }
    space.hide(b);
    space.remove(b);
    CHECK(space.add(shapeOf({}), 3, false, {0, 0}, around({1, 0}, 1)) == b);
    CHECK(space.findNewPairs() == SortedPairs{{a, b}});
}

TEST_CASE("shapes that nothing pushes pair with nothing until one comes that is free, or a sensor", "[space]") {
    for (const bool sensor : {false, true}) {
        Space space;
        const ProxyId wall = space.add(shapeOf({}), 1, true, {0, 0}, around({0, 0}, 1));
        const ProxyId lift = space.add(shapeOf({}), 2, false, {0, 0}, around({1, 0}, 1));
        space.setDriven(lift, true);
        CHECK(space.findNewPairs().empty());
        ShapeDef shape = shapeOf({});
        shape.sensor = sensor;
        const ProxyId ball = space.add(shape, 3, false, {0, 0}, around({1, 1}, 1));
        space.setDriven(ball, sensor);
        CHECK(space.findNewPairs() == SortedPairs{{wall, ball}, {lift, ball}});
        space.remove(ball);
        space.markNew(lift);
        CHECK(space.findNewPairs().empty());
    }
}

TEST_CASE("a shape that is fixed from now on pairs with what moves, and no more with what is fixed", "[space]") {
    Space space;
    const ProxyId a = space.add(shapeOf({}), 1, false, {0, 0}, around({0, 0}, 1));
    const ProxyId b = space.add(shapeOf({}), 2, true, {0, 0}, around({1, 0}, 1));
    const ProxyId c = space.add(shapeOf({}), 3, false, {0, 0}, around({0, 1}, 1));
    CHECK(space.findNewPairs().size() == 3);
    space.change(a, true, {0, 0});
    space.markNew(a);
    CHECK(space.findNewPairs() == SortedPairs{{a, c}});
    space.change(a, false, {0, 0});
    space.markNew(a);
    CHECK(space.findNewPairs() == SortedPairs{{a, b}, {a, c}});
}

TEST_CASE("a sensor pairs with a shape, and not with a sensor", "[space]") {
    Space space;
    ShapeDef sensor = shapeOf({});
    sensor.sensor = true;
    const ProxyId a = space.add(sensor, 1, false, {0, 0}, around({0, 0}, 1));
    const ProxyId b = space.add(sensor, 2, false, {0, 0}, around({1, 0}, 1));
    const ProxyId c = space.add(shapeOf({}), 3, false, {0, 0}, around({0, 1}, 1));
    CHECK(space.findNewPairs() == SortedPairs{{a, c}, {b, c}});
}
