// SPDX-License-Identifier: MIT
// Does the kit refuse what its descriptions forbid, and nothing that they allow?
#include "catch.h"
#include "kit/dynamics/described_spoils.h"
#include "kit/dynamics/sound_defs.h"
#include "numbers.h"

namespace plumb::test {

namespace {

using NotAsSaid = std::vector<std::string>;

/// Gives take() a definition with each of its leaves wrong in each way, and tells of each that is not refused by name,
/// value and wish, or that changes the bench's world.
template <class Def, class Take>
NotAsSaid notRefused(Bench& bench, const Def& sound, Take&& take) {
    NotAsSaid faults;
    CHECK(refusalOf([&] { take(filled(sound)); }) == "");
    const std::string before = stateOf(bench.world);
    forEachSpoiled(bench, sound, [&](const Def& bad, const Wrong& wrong) {
        const std::string fault = faultOf(
            bench, [&] { take(bad); }, fullName(bad, wrong.path) + wrong.behind, wrong.complaint);
        if (!fault.empty()) faults.push_back(fault);
    });
    return faults;
}

}  // namespace

/// A definition that nobody checks.
struct Loose {
    double weight = 1;  ///< [kg]
    int count = 1;
};
void describe(OrConst<Loose> auto& def, auto&& visit) {
    visit({"weight", "kg", Allowed::positive, "of it"}, def.weight);
    visit({"count", "-", Allowed::within(1, 3), "of them"}, def.count);
}

}  // namespace plumb::test

template <>
inline constexpr plumb::DefinitionName plumb::definitionName<plumb::test::Loose>{"Loose"};

namespace plumb::test {

TEST_CASE("a joint is refused by name for each number that its description forbids, and by none that it allows",
          "[dynamics][joints][describe][errors]") {
    forEachSoundJoint([](const auto& make) {
        Bench bench;
        const auto sound = make(bench);
        CHECK(notRefused(bench, sound, [&](const auto& def) { bench.world.join(def); }) == NotAsSaid{});
        CHECK(refusedAtTheEdge(sound, [](const auto& def) { validate(JointDef(def), "joint"); }) == NotAsSaid{});
    });
}

TEST_CASE("a joint's values are checked under any name, without a world", "[dynamics][joints][describe][errors]") {
    const Bench bench;
    std::size_t asked = 0;
    forEachSoundJoint([&](const auto& make) {
        const auto sound = make(bench);
        forEachSpoiled(bench, sound, [&](const auto& bad, const Wrong& wrong) {
            if (wrong.byWorld) return;
            const std::string said = refusalOf([&] { validate(JointDef(bad), "joints[3].its"); });
            CHECK_THAT(said, containsText("joints[3].its." + wrong.path + wrong.behind + ": " + wrong.complaint));
            ++asked;
        });
    });
    CHECK(asked > 500);
}

TEST_CASE("a joint is not changed when a field is wrong, or is one that only a new joint can have",
          "[dynamics][joints][errors]") {
    forEachSoundJoint([](const auto& make) {
        Bench bench;
        const auto sound = make(bench);
        const JointId id = bench.world.join(sound);
        bench.world.step(1.0 / 60);
        const auto refuse = [&](const auto& bad, const Wrong& wrong) {
            const std::string field = fullName(bad, wrong.path) + (wrong.once ? "" : wrong.behind);
            const std::string complaint = wrong.once ? "remove it and join anew" : wrong.complaint;
            CHECK(faultOf(
                      bench, [&] { bench.world.joint(id).set(bad); }, field, complaint) == "");
        };
        forEachSpoiled(bench, sound, refuse);
        forEachWrongTogether(bench, sound, refuse);
    });
}

TEST_CASE("a body, a field, a world and a map are refused by name for each number that is forbidden, and by none else",
          "[dynamics][describe][errors]") {
    Bench bench;
    CHECK(notRefused(bench, soundBody(), [&](const BodyDef& def) { bench.world.add(def); }) == NotAsSaid{});
    for (const ShapeDef& shape : soundShapes()) {
        CHECK(notRefused(bench, shape, [&](const ShapeDef& def) { bench.world.add(bench.crate, def); }) == NotAsSaid{});
        CHECK(notRefused(bench, shape, [&](const ShapeDef& def) { bench.world.shape(bench.liftShape).set(def); }) ==
              NotAsSaid{});
        CHECK(refusedAtTheEdge(shape, [](const ShapeDef& def) { validate(def, "ShapeDef"); }) == NotAsSaid{});
    }
    for (const FieldDef& field : soundFields(bench.ball)) {
        const auto addField = [&](const FieldDef& def) { bench.world.remove(bench.world.addField(def)); };
        CHECK(notRefused(bench, field, addField) == NotAsSaid{});
        CHECK(refusedAtTheEdge(field, addField) == NotAsSaid{});
    }
    const auto makeWorld = [](const WorldDef& def) { World world(def); };
    CHECK(notRefused(bench, WorldDef{}, makeWorld) == NotAsSaid{});
    CHECK(refusedAtTheEdge(WorldDef{}, makeWorld) == NotAsSaid{});
    CHECK(notRefused(bench, TileMapDef{}, [](const TileMapDef& def) { TileMap map(def); }) == NotAsSaid{});
}

TEST_CASE("a number that is forbidden and taken, or refused by another name, is caught", "[dynamics][describe]") {
    Bench bench;
    CHECK(notRefused(bench, Loose{}, [](const Loose&) {}).size() == 8);
    const auto asWeight = [](const Loose& def) {
        requirePositive(def.weight, "Loose.weight");
        if (def.count != 1) throw std::invalid_argument("Loose.weight: " + std::to_string(def.count));
    };
    CHECK(notRefused(bench, Loose{}, asWeight).size() == 2);
    CHECK(refusedAtTheEdge(Loose{}, asWeight).size() == 1);
    const auto change = [&](const Loose& def) {
        bench.world.add(bench.crate, circle(1));
        asWeight(def);
    };
    CHECK(notRefused(bench, Loose{}, change).size() == 8);
}

}  // namespace plumb::test
