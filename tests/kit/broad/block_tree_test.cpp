// SPDX-License-Identifier: MIT
#include <plumb/broad/block_tree.h>

#include <algorithm>
#include <limits>
#include <vector>

#include <plumb/math/random.h>

#include "catch.h"
#include "kit/broad/box_scenes.h"

using box_scenes::squareAround;
using namespace plumb;

namespace {

using Slots = std::vector<std::uint32_t>;

const BoundsRounding roundedOut(Vec2(0, 0));

Aabb someSquare(Random& random) {
    return squareAround({random.uniform(-20, 20), random.uniform(-20, 20)}, random.uniform(0, 1));
}

bool boundsOverlap(const Bounds& a, const Bounds& b) {
    return a.lowerX <= b.upperX && b.lowerX <= a.upperX && a.lowerY <= b.upperY && b.lowerY <= a.upperY;
}

Slots queriedSlots(const BlockTree& tree, const Bounds& box) {
    Slots found;
    tree.query(box, [&found](std::uint32_t slot) { found.push_back(slot); });
    std::sort(found.begin(), found.end());
    return found;
}

/// A tree and what its slots hold.
struct Model {
    BlockTree tree;
    std::vector<Bounds> boxes;

    void put(std::uint32_t slot, const Bounds& box) {
        boxes[slot] = box;
        tree.put(slot, box);
        tree.markDirty(slot);
    }
    void append(const Bounds& box) {
        boxes.emplace_back();
        const auto slot = static_cast<std::uint32_t>(boxes.size() - 1);
        REQUIRE(tree.append(1000 + slot) == slot);
        put(slot, box);
    }
    void erase(std::uint32_t slot) {
        constexpr float none = std::numeric_limits<float>::quiet_NaN();
        boxes[slot] = {none, none, none, none};
        tree.erase(slot);
    }
    Slots searched(const Bounds& box) const {
        Slots found;
        for (std::uint32_t slot = 0; slot < boxes.size(); ++slot)
            if (boundsOverlap(boxes[slot], box)) found.push_back(slot);
        return found;
    }
};

}  // namespace

TEST_CASE("a hierarchy that is mended 400 times answers as a search through all boxes does", "[broad]") {
    Random random(41);
    for (const int most : {1, 15, 17, 300, 5000}) {
        Model model;
        int wrong = 0;
        for (int round = 0; round < 80; ++round) {
            for (int i = random.integer(0, most / 40 + 1); i > 0; --i) model.append(roundedOut(someSquare(random)));
            for (int i = random.integer(0, most / 20 + 1); i > 0 && !model.boxes.empty(); --i) {
                const auto slot =
                    static_cast<std::uint32_t>(random.integer(0, static_cast<int>(model.boxes.size()) - 1));
                if (model.tree.members()[slot] == BlockTree::noMember) continue;
                if (random.integer(0, 9) == 0)
                    model.erase(slot);
                else
                    model.put(slot, roundedOut(someSquare(random)));
            }
            if (round % 7 == 3)
                model.tree.refitAll();
            else
                model.tree.refitDirty();
            for (int i = 0; i < 5; ++i) {
                const Bounds box = roundedOut(someSquare(random));
                if (queriedSlots(model.tree, box) != model.searched(box)) ++wrong;
            }
            model.tree.storePrevious();
        }
        INFO(most);
        CHECK(wrong == 0);
    }
}

TEST_CASE("the touched blocks are those with touched slots, each once, in order", "[broad]") {
    Model model;
    for (int i = 0; i < 1000; ++i) model.append(roundedOut(squareAround(Vec2(i, 0), 0.5)));
    model.tree.refitDirty();
    CHECK(model.tree.dirtyBlocks().size() == 63);  // 1000 / 16, rounded up
    model.tree.storePrevious();
    for (const std::uint32_t slot : {17u, 999u, 16u, 5u}) model.tree.markDirty(slot);
    model.tree.refitDirty();
    const auto blocks = model.tree.dirtyBlocks();
    CHECK(Slots(blocks.begin(), blocks.end()) == Slots{0, 1, 62});
    CHECK(model.tree.view().dirty[1] == 0b11);
    model.tree.storePrevious();
    CHECK(model.tree.dirtyBlocks().empty());
}

TEST_CASE("taking members out and in keeps count, and starting anew forgets all", "[broad]") {
    Model model;
    for (int i = 0; i < 40; ++i) model.append(roundedOut(squareAround(Vec2(i, 0), 0.5)));
    model.erase(3);
    CHECK(model.tree.memberCount() == 39);
    CHECK(model.tree.slotCount() == 40);
    CHECK(model.tree.members()[3] == BlockTree::noMember);
    CHECK(model.tree.members()[4] == 1004);
    model.tree.assign(Slots{7, 8, 9});
    CHECK(model.tree.memberCount() == 3);
    CHECK(model.tree.members()[2] == 9);
    CHECK(queriedSlots(model.tree, roundedOut(squareAround({0, 0}, 1e9))).empty());
    model.tree.assign({});
    CHECK(model.tree.slotCount() == 0);
    CHECK(queriedSlots(model.tree, roundedOut(squareAround({0, 0}, 1e9))).empty());
}

TEST_CASE("the sum of half perimeters is that of the blocks of sixteen", "[broad]") {
    Model model;
    for (int i = 0; i < 32; ++i) model.append(roundedOut(squareAround(Vec2(i, 0), 0.5)));
    model.tree.refitDirty();
    CHECK(model.tree.halfPerimeterSum() == 2 * (16 + 1));
    model.tree.storePrevious();
    model.put(31, roundedOut(squareAround({31, 10}, 0.5)));
    model.tree.refitDirty();
    CHECK(model.tree.halfPerimeterSum() == 2 * (16 + 1) + 10);
}

TEST_CASE("rounding to float keeps every overlap, and every overlap that it shows beyond an edge is one", "[broad]") {
    Random random(43);
    int lost = 0;
    int invented = 0;
    for (int i = 0; i < 100'000; ++i) {
        const BoundsRounding far(Vec2(random.uniform(-1e7, 1e7), 0));
        const double step = i % 2 == 0 ? 1e-9 : 0.3;
        const Aabb a = squareAround({1e6 + step * random.integer(0, 9), step * random.integer(0, 9)}, 2 * step);
        const Aabb b = squareAround({1e6 + step * random.integer(0, 9), step * random.integer(0, 9)}, 2 * step);
        const Bounds fa = far(a);
        const Bounds fb = far(b);
        if (overlap(a, b) && !boundsOverlap(fa, fb)) ++lost;
        const bool beyond =
            fa.lowerX < fb.upperX && fb.lowerX < fa.upperX && fa.lowerY < fb.upperY && fb.lowerY < fa.upperY;
        if (beyond && !overlap(a, b)) ++invented;
    }
    CHECK(lost == 0);
    CHECK(invented == 0);
}

TEST_CASE("boxes beyond the range of floats round to its ends", "[broad]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr float largest = std::numeric_limits<float>::max();
    const Bounds box = roundedOut({{-1e300, -infinity}, {infinity, 3}});
    CHECK(box.lowerX == -largest);
    CHECK(box.lowerY == -largest);
    CHECK(box.upperX == largest);
    CHECK(box.upperY == 3);
    CHECK(roundedOut({{std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1}}).lowerX != 0);
}
