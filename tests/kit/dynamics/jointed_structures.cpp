// SPDX-License-Identifier: MIT
#include "kit/dynamics/jointed_structures.h"

#include <numbers>

namespace plumb::test {

namespace {

std::string sized(const std::string& kind, int columns, int rows) {
    return kind + " of " + std::to_string(columns) + " x " + std::to_string(rows);
}

/// Places on a ring about a centre; the first is at the top. All in links.
std::vector<Vec2> ringOf(const Vec2& centre, int corners, double radius) {
    std::vector<Vec2> places;
    for (int i = 0; i < corners; ++i) {
        const double angle = std::numbers::pi * (0.5 + 2.0 * i / corners);
        places.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return places;
}

/// Of a ring whose neighbours are a link apart.
double radiusOf(int corners) {
    return 0.5 / std::sin(std::numbers::pi / corners);
}

/// Discs in a grid. Those of the upper row for which isHeld(column) are fixed.
template <class IsHeld>
std::vector<BodyId> gridOf(Structure& s, int columns, int rows, IsHeld&& isHeld) {
    std::vector<BodyId> discs;
    for (int i = 0; i < columns * rows; ++i)
        discs.push_back(s.disc(Vec2(i % columns, -(i / columns)), i < columns && isHeld(i)));
    return discs;
}

/// Calls tie(a, b) for each two neighbours, of which not both are fixed.
template <class Tie>
void tieGrid(const std::vector<BodyId>& discs, int columns, int held, Tie&& tie) {
    const int count = static_cast<int>(discs.size());
    const auto disc = [&](int i) { return discs[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < count; ++i) {
        if (i % columns > 0 && i >= held) tie(disc(i - 1), disc(i));
        if (i >= columns) tie(disc(i - columns), disc(i));
    }
}

void hangLoad(Structure& s, BodyId from, double mass) {
    if (mass == 0) return;
    const Vec2 at = s.world.body(from).position() / s.link;
    s.tie(LinkKind::Rod, from, s.load(at - Vec2(0, 1), mass));
}

}  // namespace

Structure truss(double link, int bays, double load) {
    Structure s("a truss of " + std::to_string(bays) + " bays under " + std::to_string(load) + " kg", link);
    std::vector<BodyId> lower, upper;
    for (int i = 0; i <= bays; ++i) lower.push_back(s.disc(Vec2(i, 0), i == 0 || i == bays));
    for (int i = 0; i < bays; ++i) upper.push_back(s.disc(Vec2(i + 0.5, 0.75)));
    for (std::size_t i = 0; i < upper.size(); ++i) {
        s.tie(LinkKind::Rod, lower[i], lower[i + 1]);
        s.tie(LinkKind::Rod, lower[i], upper[i]);
        s.tie(LinkKind::Rod, upper[i], lower[i + 1]);
        if (i + 1 < upper.size()) s.tie(LinkKind::Rod, upper[i], upper[i + 1]);
    }
    hangLoad(s, lower[lower.size() / 2], load);
    return s;
}

Structure crossedBridge(double link, int planks, double load) {
    Structure s("a bridge of " + std::to_string(planks) + " crossed planks under " + std::to_string(load) + " kg",
                link);
    const auto sag = [&](double x) { return -0.2 * x * (planks - x) / planks; };  // no straight line of planks
    const BodyId banks = s.disc(Vec2(0, 3), true);
    std::vector<BodyId> row[2];
    for (int i = 0; i < 2; ++i) {
        const auto place = [&](int k) { return Vec2(k, sag(k) - i); };
        for (int k = 0; k < planks; ++k) row[i].push_back(s.bar(place(k), place(k + 1)));
        s.hinge(banks, row[i].front(), place(0));
        for (int k = 1; k < planks; ++k)
            s.hinge(row[i][static_cast<std::size_t>(k - 1)], row[i][static_cast<std::size_t>(k)], place(k));
        s.hinge(row[i].back(), banks, place(planks));
    }
    for (std::size_t k = 0; k + 1 < row[0].size(); ++k) s.tie(LinkKind::Rod, row[0][k], row[1][k + 1]);
    hangLoad(s, row[0][row[0].size() / 2], load);
    return s;
}

Structure spokedWheel(double link, int spokes, bool hangs) {
    Structure s(std::string(hangs ? "a hanging" : "a") + " wheel of " + std::to_string(spokes) + " spokes", link);
    const double radius = radiusOf(spokes);
    const BodyId hub = s.disc({0, 0}), beam = s.disc({0, radius + 1}, true);
    std::vector<BodyId> rim;
    for (const Vec2& place : ringOf({0, 0}, spokes, radius)) rim.push_back(s.disc(place));
    for (std::size_t i = 0; i < rim.size(); ++i) {
        s.tie(LinkKind::Rod, hub, rim[i]);
        s.tie(LinkKind::Rod, rim[i], rim[(i + 1) % rim.size()]);
    }
    hangs ? s.tie(LinkKind::Rod, beam, rim.front()) : s.hinge(beam, hub, {0, 0});
    return s;
}

Structure cloth(double link, LinkKind kind, int columns, int rows) {
    const char* const names[] = {"stopped hinges", "rods", "ropes", "welds"};
    Structure s(sized(std::string("a cloth of ") + names[static_cast<int>(kind)], columns, rows), link);
    tieGrid(gridOf(s, columns, rows, [](int) { return true; }), columns, columns,
            [&](BodyId a, BodyId b) { s.tie(kind, a, b); });
    return s;
}

Structure hingedNet(double link, int columns, int rows, int hooks) {
    Structure s(sized("a net", columns, rows) + " on " + std::to_string(hooks) + " hooks", link);
    const std::vector<BodyId> discs = gridOf(s, columns, rows, [](int) { return false; });
    tieGrid(discs, columns, 0, [&](BodyId a, BodyId b) { s.tie(LinkKind::Hinge, a, b); });
    const BodyId beam = s.disc(Vec2(0, 2), true);
    for (int i = 0; i < hooks; ++i) {
        const int column = (columns - hooks) / 2 + i;
        s.hinge(beam, discs[static_cast<std::size_t>(column)], Vec2(column, 0.5));
    }
    return s;
}

Structure chainMail(double link, int columns, int rows, int sides) {
    Structure s(sized("chain mail of rings of " + std::to_string(sides) + " bars,", columns, rows), link);
    const double radius = radiusOf(sides);
    const BodyId beam = s.disc(Vec2(0, 3), true);
    std::vector<std::vector<BodyId>> rings;
    for (int i = 0; i < columns * rows; ++i) {
        const Vec2 centre = 2 * radius * Vec2(i % columns, -(i / columns));
        const std::vector<Vec2> corners = ringOf(centre, sides, radius);
        std::vector<BodyId>& ring = rings.emplace_back();
        const auto next = [&](std::size_t k) { return corners[(k + 1) % corners.size()]; };
        for (std::size_t k = 0; k < corners.size(); ++k) ring.push_back(s.bar(corners[k], next(k)));
        for (std::size_t k = 0; k < corners.size(); ++k) s.hinge(ring[k], ring[(k + 1) % ring.size()], next(k));
        // Corner 0 is the top, corner sides / 2 the bottom, which is bar sides / 2's first end.
        const auto half = static_cast<std::size_t>(sides / 2);
        const auto before = [&](int there) -> const std::vector<BodyId>& {
            return rings[static_cast<std::size_t>(there)];
        };
        s.hinge(i < columns ? beam : before(i - columns)[half], ring[0], corners[0]);
        if (i % columns > 0 && sides % 4 == 0) s.hinge(before(i - 1)[3 * half / 2], ring[half / 2], corners[half / 2]);
    }
    return s;
}

namespace {

/// A ring of discs about a hub.
void addSoftRing(Structure& s, int size, bool welded) {
    const double radius = radiusOf(size);
    const Spring soft = springOf(5, 0.3, s.world.body(s.disc({0, 0})).mass());
    const BodyId hub = s.bodies.back(), beam = s.disc({0, radius + 1}, true);
    std::vector<BodyId> rim;
    for (const Vec2& place : ringOf({0, 0}, size, radius)) rim.push_back(s.disc(place));
    for (std::size_t i = 0; i < rim.size(); ++i) {
        s.tie(welded ? LinkKind::Weld : LinkKind::Rod, rim[i], rim[(i + 1) % rim.size()]);
        s.spring(hub, rim[i], soft);
    }
    s.tie(LinkKind::Rod, beam, rim.front());
}

void addSoftGrid(Structure& s, int size, SoftKind kind) {
    const std::vector<BodyId> discs = gridOf(s, size, size, [](int) { return false; });
    const Spring stiff = springOf(10, 0.3, s.world.body(discs.front()).mass());
    const auto tie = [&](BodyId a, BodyId b) {
        if (kind == SoftKind::SpringGrid) return s.spring(a, b, stiff);
        s.tie(kind == SoftKind::RodGrid ? LinkKind::Rod : LinkKind::Weld, a, b);
    };
    tieGrid(discs, size, 0, tie);
    for (int i = size; i < size * size; ++i) {
        const auto at = [&](int k) { return discs[static_cast<std::size_t>(k)]; };
        if (i % size > 0) tie(at(i - size - 1), at(i));
        if (i % size + 1 < size) tie(at(i - size + 1), at(i));
    }
    s.tie(LinkKind::Rod, s.disc(Vec2(size / 2, 1), true), discs[static_cast<std::size_t>(size / 2)]);
}

}  // namespace

Structure softBody(double link, SoftKind kind, int size) {
    const char* const names[] = {"ring of rods and springs", "ring of welds and springs", "grid of springs",
                                 "grid of rods", "grid of welds"};
    Structure s("a soft " + std::string(names[static_cast<int>(kind)]) + ", " + std::to_string(size), link);
    if (kind == SoftKind::SpringRing || kind == SoftKind::WeldRing)
        addSoftRing(s, size, kind == SoftKind::WeldRing);
    else
        addSoftGrid(s, size, kind);
    return s;
}

Structure randomStructure(std::uint64_t seed, bool isLarge) {
    Random random(seed);
    const double link = std::pow(2.0, random.integer(-1, 1));
    const auto from = [&](int low, int daily, int most) {
        return random.integer(isLarge ? daily : low, isLarge ? most : daily);
    };
    const auto load = [&] { return random.integer(0, 3) == 0 ? 0.0 : std::pow(10.0, random.uniform(0, 3)); };
    switch (seed % 7) {
        case 0: {
            const int bays = from(2, 40, 64);
            return truss(link, bays, load());
        }
        case 1: {
            const int planks = from(3, 20, 60);
            return crossedBridge(link, planks, load());
        }
        case 2: return spokedWheel(link, random.integer(8, 32), random.integer(0, 1) == 0);
        case 3: {
            const auto kind = static_cast<LinkKind>(random.integer(1, 3));
            const int columns = from(2, 8, 30);
            return cloth(link, kind, columns, from(2, 8, 30));
        }
        case 4: {
            const int size = from(3, 12, 60);
            return hingedNet(link, size, size, std::min(size, random.integer(1, 4)));
        }
        case 5: {
            const int columns = from(1, 3, 8), rows = from(1, 3, 8);
            return chainMail(link, columns, rows, random.integer(0, 1) == 0 ? 4 : 8);
        }
        default: {
            const auto kind = static_cast<SoftKind>(random.integer(0, 4));
            const bool isRing = kind == SoftKind::SpringRing || kind == SoftKind::WeldRing;
            return softBody(link, kind, isRing ? from(6, 20, 40) : from(2, 6, 20));
        }
    }
}

}  // namespace plumb::test
