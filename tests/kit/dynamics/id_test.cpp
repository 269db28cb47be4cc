// SPDX-License-Identifier: MIT
// Can ids be sorted, and be keys of sets and maps?
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"

using namespace plumb;

namespace {

/// Sorts ids given in reverse order with two of them equal, and puts them into a set and a map.
template <class Id>
void isOrdered(const std::vector<Id>& ids) {
    std::vector<Id> mixed(ids.rbegin(), ids.rend());
    mixed.push_back(ids.front());
    std::set<Id> set(mixed.begin(), mixed.end());
    std::map<Id, int> map;
    for (const Id& id : mixed) ++map[id];
    CHECK(std::vector<Id>(set.begin(), set.end()) == ids);
    CHECK(map.size() == ids.size());
    CHECK(map[ids.front()] == 2);
    std::sort(mixed.begin(), mixed.end());
    mixed.erase(std::unique(mixed.begin(), mixed.end()), mixed.end());
    CHECK(mixed == ids);
    for (std::size_t i = 1; i < ids.size(); ++i) {
        CHECK(ids[i - 1] < ids[i]);
        CHECK(ids[i] >= ids[i - 1]);
        CHECK(ids[i] != ids[i - 1]);
    }
}

}  // namespace

TEST_CASE("ids of bodies, joints, fields and shapes can be sorted and put into a std::set", "[dynamics]") {
    isOrdered<BodyId>({{}, {1, 0, 1}, {1, 0, 2}, {1, 1, 1}, {2, 0, 1}});
    isOrdered<JointId>({{}, {1, 0, 1}, {1, 0, 2}, {1, 1, 1}, {2, 0, 1}});
    isOrdered<FieldId>({{}, {1, 0, 1}, {1, 0, 2}, {1, 1, 1}, {2, 0, 1}});
    isOrdered<ShapeId>({{}, {{1, 0, 1}, 0}, {{1, 0, 1}, 1}, {{1, 1, 1}, 0}, {{2, 0, 1}, 0}});
}

TEST_CASE("a world lists its bodies in the order of their ids", "[dynamics]") {
    World world;
    for (int i = 0; i < 20; ++i) world.add({.position = {3.0 * i, 0}, .shapes = {circle(1)}});
    world.remove(world.bodies()[7]);
    world.add({.position = {0, 9}, .shapes = {circle(1)}});
    const std::vector<BodyId> bodies = world.bodies();
    CHECK(bodies.size() == 20);
    CHECK(std::is_sorted(bodies.begin(), bodies.end()));
}
