// SPDX-License-Identifier: MIT
#include <compare/scene/random/random_scene.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <compare/command/scene_choice.h>
#include <compare/engine/engine.h>
#include <compare/metric/geometry.h>
#include <compare/scene/json.h>
#include <plumb/shapes/aabb.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr std::uint64_t seeds = 80;

/// FNV-1a over the bytes of its JSON.
std::uint64_t hashOf(const Scene& scene) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : toJson(scene)) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return hash;
}

std::vector<BodyState> startOf(const Scene& scene) {
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({body.def.position, body.def.angle});
    return states;
}

bool isDynamic(const SceneBody& body) {
    return body.def.type == BodyType::Dynamic;
}

/// Around all that keeps the bodies in.
Aabb boundsOf(const Scene& scene) {
    const BodyDef& world = scene.bodies.front().def;
    Aabb bounds = aabbOf(world.shapes.front().shape, {world.position, {}});
    for (const ShapeDef& shape : world.shapes) {
        const Aabb part = aabbOf(shape.shape, {world.position, {}});
        bounds = {bounds.lower.cwiseMin(part.lower), bounds.upper.cwiseMax(part.upper)};
    }
    return bounds;
}

/// Of seed 1, 2, and so on. A benchmark goes by them: they do not change.
constexpr std::uint64_t hashes[] = {
    0x54B33D04BC3B493A, 0x55E338C86DDD5F4C, 0xBC745F7919D4D726, 0x6B34A13AD3764B5B, 0x8294E824B9D6ED4B,
    0x3840116606FC8C44, 0x1AC737D2B93F9009, 0xE7EFC219394ED7B9, 0x00BD95E3D548D92C, 0xD076735D4B892146,
    0xDFF80DC03FC979AE, 0xC8EEC9C5F03FE491, 0xB95936AC52B216CA, 0x537390C04CBDC440, 0x8992A239028F4DDD,
    0x93E49AE5C6C9434D, 0x5C956B0A4261678B, 0x7BC5A4BEE138E272, 0x0DD6F92586D220D6, 0x9BA4B726EFA569F2,
    0x27BC23213E2A0B37, 0x83F75F4977B7B7FA, 0x42E526A5A1F597F7, 0xEA5BB345C3E72C0B, 0x1D66CDCD10BDA127,
    0x3115E52DC92934CA, 0x49145B4E8B354ABA, 0xE079EF85B5ECAF29, 0x5A27E442E7FFB21A, 0x338D37C83E8F9574,
    0x78D5EDF956BD923E, 0x164D2EE3EDBF1BBC, 0xC90FD77251E3CE6C, 0x855DD8E5F087C6E2, 0x580B478563616F10,
    0xC8DBED37C9F06480, 0x93B935A467740559, 0x4A3F25D0EEE6615C, 0x9F99120D95DEBF6C, 0x99573584291B3F83,
    0xB0AC31AE1404B48B, 0x88B74E09C223E594, 0x3BD97536AE26B05D, 0x655B8C3BB9AE0618, 0x090FDCA36EF03A8C,
    0x0EF3C4FDFEFEC43A, 0x7D68516810B18DA0, 0x4212D20BF1AB9B5F, 0xADA6DB691F7109C0, 0xEB8BAD59A85DAC84,
    0x838A0F751CF25F17, 0xEB85748DC33FEA0B, 0x342EFFBC67686BA0, 0x9AF60301C70660B5, 0xB2C71BC2AA1F5D8C,
    0xCB36A2B4E00A072A, 0x4E1DA07BEC307BB7, 0x20F1FFDA3BD4EA89, 0x010C76EFBCDC5715, 0x14F26C6849A756B2,
    0x894608CF2D372AF2, 0x66126B6F2BA1B6F1, 0xDE4637FB5ACF557C, 0x703C7BDEA9A574DF, 0xEB9A13E18164B721,
    0xA1611ACB4F189B21, 0x5A13E6706F7CB027, 0x85021204A0F25CFC, 0x9C85CAFBFB13250D, 0x8F2197FA3402BB84,
    0x70CB3AEAFCD4CB50, 0xA1C15F7DE4967B54, 0x46F3C7AF6B4D8F6F, 0xE17B704FBBF9807C, 0x6F39CA63466EAE18,
    0x444B4AA5E8E4AB63, 0x4AE4239C0FC5D4F8, 0x014B9669F6E399C0, 0x1BA7A88EA99D0F14, 0x99FD6B9789852C11};

}  // namespace

TEST_CASE("the scenes of seeds 1 to 80 are those they have been", "[compare][scene][random][slow]") {
    REQUIRE(std::size(hashes) == seeds);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        INFO("seed " << seed);
        CHECK(hashOf(randomScene(seed)) == hashes[seed - 1]);
    }
}

TEST_CASE("80 random scenes are valid, of 20 to 3,000 bodies and 300 steps, and 10 to 24 of them have joints",
          "[compare][scene][random]") {
    int jointed = 0, sleeping = 0, small = 0, large = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Scene scene = randomScene(seed);
        INFO(scene.name);
        CHECK(scene.name == "random_" + std::to_string(seed));
        CHECK_NOTHROW(validate(scene));
        CHECK(stepCount(scene) == 300);
        const auto bodies = std::ranges::count_if(scene.bodies, isDynamic);
        CHECK(bodies >= 20);
        CHECK(bodies <= 3000);
        jointed += scene.joints.empty() ? 0 : 1;
        sleeping += scene.sleeping ? 1 : 0;
        small += bodies < 100 ? 1 : 0;
        large += bodies > 600 ? 1 : 0;
    }
    CHECK(jointed >= 10);
    CHECK(jointed <= 24);
    // half of 80 have 40 +- 4.5; of a number's logarithm, which spans ln 150 = 5.0, a third is below 100 and above 600
    CHECK(std::abs(sleeping - 40) <= 14);
    CHECK(small >= 14);
    CHECK(large >= 14);
}

TEST_CASE("80 random scenes start without overlap, within walls that are 10 m higher than they",
          "[compare][scene][random]") {
    constexpr double rounding = 1e-9;  // of positions up to 1 km, in what measures overlap
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Scene scene = randomScene(seed);
        INFO(scene.name);
        const Geometry geometry(scene);
        CHECK(geometry.penetration(startOf(scene)).value() <= rounding);
        CHECK(geometry.jointError(startOf(scene)).value() <= rounding);
        const Aabb bounds = boundsOf(scene);
        const bool isClosed = scene.bodies.front().def.type == BodyType::Kinematic || scene.gravity.y() == 0;
        for (const SceneBody& body : scene.bodies) {
            const Vec2& place = body.def.position;
            if (!isDynamic(body)) continue;
            REQUIRE((place - bounds.lower).minCoeff() > 0);
            REQUIRE((bounds.upper - place).minCoeff() > 0);
            if (!isClosed) REQUIRE(place.y() + 10 < bounds.upper.y());
        }
    }
}

TEST_CASE("every kind of shape, body and world is in one of 80 random scenes", "[compare][scene][random]") {
    std::set<std::string> seen;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Scene scene = randomScene(seed);
        if (scene.gravity.y() == 0) seen.insert("no weight");
        for (const SceneBody& body : scene.bodies) {
            if (body.def.type == BodyType::Kinematic) seen.insert("kinematic");
            if (isDynamic(body) && body.def.shapes.size() > 1) seen.insert("compound");
            if (!body.def.awake) seen.insert(scene.sleeping ? "asleep" : "asleep where none may");
            for (const ShapeDef& def : body.def.shapes) {
                if (def.material.surfaceSpeed != 0) seen.insert("belt");
                if (std::holds_alternative<Circle>(def.shape)) seen.insert("circle");
                if (std::holds_alternative<Capsule>(def.shape)) seen.insert("capsule");
                if (std::holds_alternative<Chain>(def.shape)) seen.insert("hills");
                if (std::holds_alternative<TileMap>(def.shape)) seen.insert("tiles");
                const auto* polygon = std::get_if<Polygon>(&def.shape);
                if (polygon && polygon->radius > 0) seen.insert("rounded");
                if (polygon) seen.insert(std::to_string(polygon->vertices.size()));
            }
        }
        for (const SceneJoint& joint : scene.joints)
            seen.insert(std::holds_alternative<WheelJointDef>(joint.def) ? "wheel" : "hinge");
    }
    const std::set<std::string> all{"no weight", "kinematic", "compound", "asleep",  "belt",  "circle",
                                    "capsule",   "hills",     "tiles",    "rounded", "3",     "4",
                                    "5",         "6",         "7",        "8",       "wheel", "hinge"};
    CHECK(seen == all);
}

TEST_CASE("80 random scenes are built by Plumb and by Box2D 3, and step to finite states", "[compare][scene][random]") {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Scene scene = randomScene(seed);
        for (const Engine& engine : engines()) {
            if (engine.role != Role::Subject && !engine.isRival) continue;
            INFO(scene.name << " in " << engine.name);
            const std::unique_ptr<Simulation> simulation = engine.build(scene);
            for (int i = 0; i < 2; ++i) simulation->step(scene.dt);
            const std::vector<BodyState> states = simulation->states();
            REQUIRE(states.size() == scene.bodies.size());
            CHECK(std::ranges::all_of(states, [](const BodyState& s) {
                return std::isfinite(s.position.norm() + s.velocity.norm() + s.angle + s.angularVelocity);
            }));
        }
    }
}

TEST_CASE("random:7 is the scene of seed 7, and random:3..5 three scenes, to check and to bench",
          "[compare][scene][random][slow]") {
    const std::vector<std::string> one{"random:7"}, three{"random:3..5"}, twice{"random:3..5", "random:4"};
    REQUIRE(chooseScenes(one).size() == 1);
    CHECK(toJson(chooseScenes(one)[0]) == toJson(randomScene(7)));
    const std::vector<Scene> scenes = chooseScenesAndLabs(three).scenes;
    const std::vector<BenchScene> benches = chooseBenchScenes(three);
    REQUIRE(scenes.size() == 3);
    REQUIRE(benches.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(scenes[i].name == "random_" + std::to_string(3 + i));
        CHECK(benches[i].name == scenes[i].name);
        CHECK(toJson(benches[i].build()) == toJson(scenes[i]));
    }
    CHECK_THROWS_WITH(chooseBenchScenes(twice), test::containsText("both called \"random_4\""));
}

TEST_CASE("what is no seed after random: is refused, and what was wanted is said", "[compare][scene][random]") {
    const auto refused = [](const std::string& name, const std::string& message) {
        const std::vector<std::string> given{name};
        CHECK_THROWS_WITH(chooseScenes(given), test::containsText(message));
        CHECK_THROWS_WITH(chooseBenchScenes(given), test::containsText(message));
    };
    const std::string wanted = "is not a whole number of 0 or more, wanted random:SEED or random:A..B";
    refused("random:x", "random:x: \"x\" " + wanted);
    refused("random:", "random:: \"\" " + wanted);
    refused("random:-1", "random:-1: \"-1\" " + wanted);
    refused("random:3..", "random:3..: \"\" " + wanted);
    refused("random:5..3", "random:5..3: 3 is less than 5, wanted random:A..B with the smaller first");
    refused("random:0..10000", "random:0..10000: wanted at most 10000 scenes");
}

}  // namespace plumb::compare
