// SPDX-License-Identifier: MIT
#include <plumb/broad/box_probe.h>

#include <cmath>
#include <limits>
#include <vector>

#include <plumb/broad/block_tree.h>
#include <plumb/math/random.h>

#include "catch.h"

namespace {

using namespace plumb;

constexpr int laneCounts[] = {1, 4, 8, 16};

Vec2 within(Random& random, double size) {
    const double x = random.uniform(-size, size);
    return {x, random.uniform(-size, size)};
}

/// Where a box of this half size on its way first overlaps or touches a box, by exact bounds in long double; 2:
/// nowhere.
double entryOf(const Aabb& box, const Vec2& half, const Vec2& from, const Vec2& to) {
    long double first = 0, last = 1;
    for (const int axis : {0, 1}) {
        const long double way = static_cast<long double>(to[axis]) - from[axis];
        const long double low = static_cast<long double>(box.lower[axis]) - half[axis] - from[axis];
        const long double high = static_cast<long double>(box.upper[axis]) + half[axis] - from[axis];
        if (way == 0 && (low > 0 || high < 0)) return 2;
        if (way == 0) continue;
        first = std::max(first, std::min(low / way, high / way));
        last = std::min(last, std::max(low / way, high / way));
    }
    return first <= last ? static_cast<double>(first) : 2;
}

double distanceOf(const Aabb& box, const Vec2& point) {
    const double x = std::max({box.lower.x() - point.x(), point.x() - box.upper.x(), 0.0});
    const double y = std::max({box.lower.y() - point.y(), point.y() - box.upper.y(), 0.0});
    return std::hypot(x, y);
}

/// Boxes in a tree that counts from an origin, with holes.
struct Crowd {
    Crowd(Random& random, double size, const Vec2& place) : origin(place + within(random, 100)) {
        const int count = random.integer(1, 600);
        const BoundsRounding rounded(origin);
        for (int i = 0; i < count; ++i) {
            const Vec2 center = place + within(random, size);
            const Vec2 half = within(random, random.integer(0, 9) ? 0.3 : 0.3 * size).cwiseAbs();
            boxes.push_back({center - half, center + half});
            tree.put(tree.append(static_cast<std::uint32_t>(i)), rounded(boxes.back()));
        }
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (random.integer(0, 5) == 0) tree.erase(i);
        tree.refitAll();
    }
    bool has(std::uint32_t slot) const { return tree.members()[slot] != BlockTree::noMember; }

    Vec2 origin;
    std::vector<Aabb> boxes;
    BlockTree tree;
};

struct Ray {
    Vec2 from, to, half;
};

Ray randomRay(Random& random, double size, const Vec2& place) {
    Ray ray{place + within(random, size), place + within(random, size), {0, 0}};
    switch (random.integer(0, 5)) {
        case 0: ray.to = ray.from; break;
        case 1: ray.to.x() = ray.from.x(); break;
        case 2: ray.to.y() = ray.from.y(); break;
        case 3: ray.to += 50 * (ray.to - ray.from); break;
        default: break;
    }
    if (random.integer(0, 1) == 0) ray.half = within(random, 0.5).cwiseAbs();
    return ray;
}

}  // namespace

TEST_CASE("no box of 2,000 crowds that lies in a ray's way or near a point is passed over, for any lanes", "[broad]") {
    Random random(13);
    int missed = 0, differ = 0, holes = 0;
    std::size_t met = 0, visited = 0;
    for (int i = 0; i < 2000; ++i) {
        const double size = std::exp(random.uniform(0, 6));
        const Vec2 place = within(random, random.integer(0, 3) ? 100 : 1e7);
        const Crowd crowd(random, size, place);
        const Ray ray = randomRay(random, size, place);
        const double within = random.uniform(0, size);
        std::vector<std::uint32_t> firstWay, firstNear;
        for (const int lanes : laneCounts) {
            std::vector<std::uint32_t> onWay, near;
            crowd.tree.probe(rayProbe(ray.from, ray.to, ray.half, crowd.origin, lanes), 1, [&](std::uint32_t slot) {
                onWay.push_back(slot);
                return 1.0f;
            });
            const float limit = probeLimit(within);
            crowd.tree.probe(pointProbe(ray.from, crowd.origin, lanes), limit, [&](std::uint32_t slot) {
                near.push_back(slot);
                return limit;
            });
            if (lanes == 1) firstWay = onWay, firstNear = near;
            differ += onWay != firstWay || near != firstNear;
        }
        visited += firstWay.size();
        std::vector<bool> way(crowd.boxes.size()), near(crowd.boxes.size());
        for (const std::uint32_t slot : firstWay) way[slot] = true;
        for (const std::uint32_t slot : firstNear) near[slot] = true;
        for (std::uint32_t slot = 0; slot < crowd.boxes.size(); ++slot) {
            holes += !crowd.has(slot) && (way[slot] || near[slot]);
            if (!crowd.has(slot)) continue;
            const bool inWay = entryOf(crowd.boxes[slot], ray.half, ray.from, ray.to) <= 1;
            met += inWay;
            missed += inWay && !way[slot];
            missed += distanceOf(crowd.boxes[slot], ray.from) <= within && !near[slot];
        }
    }
    CHECK(missed == 0);
    CHECK(differ == 0);
    CHECK(holes == 0);
    CHECK(met > 10'000);
    // Floats 1e7 m from their origin would see everything; from nearby they see hardly more than there is.
    CHECK(visited < met + met / 10);
}

TEST_CASE("a probe that narrows down to the nearest of 10,000 boxes looks at fewer than 20 of them", "[broad]") {
    Random random(5);
    BlockTree tree;
    std::vector<Aabb> boxes;
    const BoundsRounding rounded(Vec2(0, 0));
    for (int i = 0; i < 10'000; ++i) {  // in rows, as a curve would order them
        const Vec2 center(i % 4 + 4 * (i / 16 % 25), i / 4 % 4 + 4 * (i / 400));
        boxes.push_back({center - Vec2(0.3, 0.3), center + Vec2(0.3, 0.3)});
        tree.put(tree.append(static_cast<std::uint32_t>(i)), rounded(boxes.back()));
    }
    tree.refitAll();
    int looked = 0, wrong = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec2 from = Vec2(50, 50) + within(random, 50), to = Vec2(50, 50) + within(random, 50);
        double first = 2, brute = 2;
        tree.probe(rayProbe(from, to, {0, 0}, {0, 0}, 16), 1, [&](std::uint32_t slot) {
            ++looked;
            first = std::min(first, entryOf(boxes[slot], {0, 0}, from, to));
            return probeLimit(std::min(first, 1.0));
        });
        for (const Aabb& box : boxes) brute = std::min(brute, entryOf(box, {0, 0}, from, to));
        wrong += first != brute;
    }
    CHECK(wrong == 0);
    CHECK(looked < 20'000);
}

TEST_CASE("clipRay keeps the part of a ray in a box, its ends too, and nothing of one that passes", "[broad]") {
    const Aabb box{{-1, -1}, {1, 1}};
    const RayPart through = clipRay({-4, 0}, {4, 0}, box);
    CHECK(std::fabs(through.first - 0.375) < 1e-15);
    CHECK(std::fabs(through.last - 0.625) < 1e-15);
    const RayPart along = clipRay({-4, 1}, {4, 1}, box);
    CHECK(along.first <= along.last);
    const RayPart beside = clipRay({-4, 1.001}, {4, 1.001}, box);
    CHECK(beside.first > beside.last);
    const RayPart none = clipRay({0.5, 0.5}, {0.5, 0.5}, box);
    CHECK(none.first == 0);
    CHECK(none.last == 1);
}
