// SPDX-License-Identifier: MIT
// Does the kit refuse what its descriptions forbid, and nothing that they allow?
#include <cmath>
#include <functional>

#include <plumb/math/check.h>

#include "catch.h"
#include "kit/dynamics/bad_input.h"
#include "kit/dynamics/described_leaves.h"
#include "numbers.h"

namespace plumb::test {

namespace {

/// Numbers just beyond what is allowed, and those that never are.
std::vector<double> numbersOutside(const Allowed& allowed) {
    if (allowed.anything) return {};
    std::vector<double> bad{nan};
    if (!allowed.infinite) bad.push_back(infinity);
    if (!allowed.minusInfinite) bad.push_back(-infinity);
    if (allowed.sign == Allowed::Sign::Positive) bad.insert(bad.end(), {0, -1});
    if (allowed.sign == Allowed::Sign::NotNegative) bad.push_back(-1);
    if (allowed.isRange()) bad.insert(bad.end(), {allowed.low - 1, 2 * allowed.high});
    for (const int choice : allowed.oneOf) bad.push_back(choice + 100);
    if (allowed.beyond != nullptr) bad.insert(bad.end(), {2 * allowed.most, -2 * allowed.most});
    if (allowed.zero != nullptr) bad.push_back(0);
    return bad;
}

std::vector<double> numbersAtTheEdge(const Allowed& allowed) {
    std::vector<double> good;
    if (allowed.anything) return good;
    if (allowed.infinite) good.push_back(infinity);
    if (allowed.minusInfinite) good.push_back(-infinity);
    if (allowed.sign == Allowed::Sign::NotNegative) good.push_back(0);
    if (allowed.isRange()) good.insert(good.end(), {allowed.low, allowed.high});
    good.insert(good.end(), allowed.oneOf.begin(), allowed.oneOf.end());
    return good;
}

bool fitsInt(double number) {
    return std::fabs(number) < 2e9;
}

/// How a value can be spoiled: each way with the text by which it is then named.
template <class T>
struct Ways {
    std::vector<std::pair<std::function<void(T&)>, std::string>> all;
};

template <class T>
Ways<T> waysToSpoil(const Member& member) {
    Ways<T> ways;
    const auto add = [&](std::function<void(T&)> spoil, const std::string& text) { ways.all.push_back({spoil, text}); };
    for (const double bad : numbersOutside(member.allowed)) {
        const std::string text = std::isnan(bad) ? "nan" : std::isinf(bad) ? (bad > 0 ? "inf" : "-inf") : "";
        if constexpr (std::is_same_v<T, double>) add([bad](T& v) { v = bad; }, text);
        if constexpr (std::is_same_v<T, int>)
            if (fitsInt(bad)) add([bad](T& v) { v = static_cast<int>(bad); }, std::to_string(static_cast<int>(bad)));
        if constexpr (std::is_same_v<T, Vec2>) add([bad](T& v) { v = {0, bad}; }, "(0, " + text);
        if constexpr (std::is_same_v<T, std::vector<Vec2>>) add([bad](T& v) { v.at(1).x() = bad; }, "(" + text);
    }
    if constexpr (std::is_enum_v<T>)
        for (const int bad : {-1, static_cast<int>(tagsOf(T{}).size())})
            add([bad](T& v) { v = static_cast<T>(bad); }, std::to_string(bad) + " is none of");
    return ways;
}

/// Spoils each leaf of a sound definition in each way that its description forbids, and tells of each that
/// take(def) does not refuse with the member's name and the value.
template <class Def, class Take>
std::vector<std::string> notRefused(const Def& sound, Take&& take) {
    std::vector<std::string> faults;
    CHECK(refusalOf([&] { take(sound); }) == "");
    std::size_t leaves = 0;
    forEachLeaf(sound, [&](const auto&...) { ++leaves; });
    for (std::size_t at = 0; at < leaves; ++at) {
        bool more = true;
        for (std::size_t way = 0; more; ++way) {
            Def bad = sound;
            std::size_t leaf = 0;
            std::string name, text;
            forEachLeaf(bad, [&]<class T>(const std::string& path, const Member& member, T& value) {
                if (leaf++ != at) return;
                const Ways<T> ways = waysToSpoil<T>(member);
                more = way < ways.all.size();
                if (!more) return;
                ways.all[way].first(value);
                name = path.substr(path.rfind('.') + 1);
                text = ways.all[way].second;
            });
            if (!more) break;
            const std::string said = refusalOf([&] { take(bad); });
            if (said.find("." + name) == std::string::npos || said.find(text) == std::string::npos)
                faults.push_back(name + " = " + text + " (way " + std::to_string(way) + "): \"" + said + "\"");
        }
    }
    return faults;
}

/// Puts numbers at the edges of what is allowed into each leaf, and tells of each that is refused.
template <class Def, class Take>
std::vector<std::string> refusedAtTheEdge(const Def& sound, Take&& take) {
    std::vector<std::string> faults;
    std::size_t leaves = 0;
    forEachLeaf(sound, [&](const auto&...) { ++leaves; });
    for (std::size_t at = 0; at < leaves; ++at) {
        for (std::size_t edge = 0, edges = 1; edge < edges; ++edge) {
            Def def = sound;
            std::size_t leaf = 0;
            forEachLeaf(def, [&]<class T>(const std::string&, const Member& member, T& value) {
                if (leaf++ != at) return;
                edges = 0;
                if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
                    const std::vector<double> numbers = numbersAtTheEdge(member.allowed);
                    edges = numbers.size();
                    if (edge < edges) value = static_cast<T>(numbers[edge]);
                }
            });
            const std::string said = refusalOf([&] { take(def); });
            if (!said.empty()) faults.push_back(said);
        }
    }
    return faults;
}

/// Two bodies, one of which moves, and two joints between them.
struct JointWorld {
    World world;
    BodyId bodies[2] = {world.add({.type = BodyType::Static}), world.add({.shapes = {circle(0.5)}})};
    JointId joints[2] = {world.join(RevoluteJointDef{.bodyA = bodies[0], .bodyB = bodies[1]}),
                         world.join(PrismaticJointDef{.bodyA = bodies[0], .bodyB = bodies[1]})};
    BodyId order[2] = {bodies[1], bodies[0]};  ///< a target's only body must move

    template <class Def>
    Def sound() const {
        return soundJoint<Def>(order, joints);
    }
    void take(const JointDef& def) { world.remove(world.join(def)); }
};

/// A body with one shape of each kind.
BodyDef bodyOfEachShape() {
    BodyDef body{.shapes = {{circle(0.5), capsule({0, 0}, {1, 0}, 0.5), box({1, 1}), segment({0, 0}, {1, 0}),
                             chain({{0, 0}, {1, 0}, {2, 1}})}}};
    return filled(body);
}

std::vector<FieldDef> soundFields(BodyId carrier) {
    std::vector<FieldDef> fields;
    forEachAlternative(std::type_identity<FieldLaw>(), [&](const auto& law) {
        FieldDef def = filled(FieldDef{.law = law});
        if (auto* magnet = std::get_if<Magnet>(&def.law)) magnet->body = carrier;
        fields.push_back(def);
    });
    return fields;
}

using NotAsSaid = std::vector<std::string>;

/// A definition that nobody checks.
struct Loose {
    double weight = 1;  ///< [kg]
    int count = 1;
};
void describe(OrConst<Loose> auto& def, auto&& visit) {
    visit({"weight", "kg", Allowed::positive, "of it"}, def.weight);
    visit({"count", "-", Allowed::within(1, 3), "of them"}, def.count);
}

}  // namespace

TEST_CASE("a joint is refused by name for each number that its description forbids, and by none that it allows",
          "[dynamics][joints][describe][errors]") {
    JointWorld bench;
    const auto take = [&](const auto& def) { bench.take(def); };
    forEachAlternative(std::type_identity<JointDef>(), [&]<class Def>(const Def&) {
        INFO(definitionName<Def>.type);
        CHECK(notRefused(bench.sound<Def>(), take) == NotAsSaid{});
        CHECK(refusedAtTheEdge(bench.sound<Def>(), take) == NotAsSaid{});
    });
}

TEST_CASE("a joint's values are checked under any name, without a world", "[dynamics][joints][describe][errors]") {
    const auto take = [](const auto& def) { validate(JointDef(def), "joints[3].its"); };
    forEachAlternative(std::type_identity<JointDef>(), [&]<class Def>(const Def&) {
        const Def sound = soundJoint<Def>({{}, {}}, {{}, {}});
        CHECK(notRefused(sound, take) == NotAsSaid{});
    });
    CHECK(refusalOf([&] {
              take(RevoluteJointDef{.spring = Spring{-1, 0}});
          }) == "joints[3].its.spring.stiffness: -1 is negative");
}

TEST_CASE("a body, a field, a world and a map are refused by name for each number that is forbidden, and by none else",
          "[dynamics][describe][errors]") {
    JointWorld bench;
    const auto addBody = [&](const BodyDef& def) { bench.world.remove(bench.world.add(def)); };
    CHECK(notRefused(bodyOfEachShape(), addBody) == NotAsSaid{});
    for (const FieldDef& field : soundFields(bench.bodies[0])) {
        const auto addField = [&](const FieldDef& def) { bench.world.remove(bench.world.addField(def)); };
        CHECK(notRefused(field, addField) == NotAsSaid{});
        CHECK(refusedAtTheEdge(field, addField) == NotAsSaid{});
    }
    const auto makeWorld = [](const WorldDef& def) { World world(def); };
    CHECK(notRefused(filled(WorldDef{}), makeWorld) == NotAsSaid{});
    CHECK(refusedAtTheEdge(filled(WorldDef{}), makeWorld) == NotAsSaid{});
    CHECK(notRefused(TileMapDef{}, [](const TileMapDef& def) { TileMap map(def); }) == NotAsSaid{});
}

TEST_CASE("a number that is forbidden and taken, or refused by another name, is caught", "[dynamics][describe]") {
    CHECK(notRefused(Loose{}, [](const Loose&) {}).size() == 7);
    const auto asWeight = [](const Loose& def) {
        if (!(def.weight > 0) || def.weight > 1e300) throw std::invalid_argument("Loose.weight: " + toText(def.weight));
        if (def.count != 1) throw std::invalid_argument("Loose.weight: " + std::to_string(def.count));
    };
    CHECK(notRefused(Loose{}, asWeight).size() == 2);
    CHECK(refusedAtTheEdge(Loose{}, asWeight).size() == 1);
}

}  // namespace plumb::test
