// SPDX-License-Identifier: MIT
// Does each member of each definition of the kit come back from a scene's file as it went in?
#include <compare/scene/json.h>

#include <cmath>
#include <limits>

#include <plumb/math/check.h>

#include "catch.h"
#include "kit/dynamics/described_leaves.h"

namespace plumb::compare {
namespace {

constexpr std::uint64_t bothEnds = 0x8000000000000001u;

bool allows(const Allowed& allowed, double number) {
    if (allowed.sign == Allowed::Sign::Positive && number <= 0) return false;
    if (allowed.sign == Allowed::Sign::NotNegative && number < 0) return false;
    return number >= allowed.low && number <= allowed.high;
}

/// To another value that is sound too.
template <class T>
void change(const Member& member, T& value) {
    if constexpr (std::is_same_v<T, double>) {
        const double half = value / 2;
        value = half != value && std::isfinite(half) && allows(member.allowed, half) ? half : 1.0 / 3;
    } else if constexpr (std::is_same_v<T, int>) {
        value = value + 1;
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
        value ^= bothEnds;
    } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, Lock>) {
        value = !static_cast<bool>(value);
    } else if constexpr (std::is_same_v<T, Vec2>) {
        value += Vec2(1.0 / 16, 1.0 / 3);
    } else if constexpr (std::is_same_v<T, std::vector<Vec2>>) {
        value.front() -= Vec2(0.25, 0.125);
    } else if constexpr (std::is_enum_v<T>) {
        value = static_cast<T>((static_cast<std::size_t>(value) + 1) % tagsOf(value).size());
    }
}

/// Do a file and a scene hold it? Ids are names there, and code is in neither.
template <class T>
inline constexpr bool isWritten = !std::is_same_v<T, BodyId> && !std::is_same_v<T, JointId> &&
                                  !std::is_same_v<T, ContactRule> && !std::is_same_v<T, TileMap>;

template <class T>
std::string leafText(const T& value) {
    if constexpr (std::is_same_v<T, Vec2>) {
        return toText(value);
    } else if constexpr (std::is_same_v<T, std::vector<Vec2>>) {
        std::string text;
        for (const Vec2& point : value) text += toText(point);
        return text;
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
        return std::to_string(value);
    } else {
        return toText(static_cast<double>(value));
    }
}

/// A line a leaf.
template <class Def>
std::string leavesText(const Def& def) {
    std::string text;
    test::forEachLeaf(def, [&]<class T>(const std::string& path, const Member&, const T& value) {
        if constexpr (isWritten<T>) text += path + " = " + leafText(value) + "\n";
    });
    return text;
}

/// A scene whose last body, field or joint, or whose wrap, is the definition.
template <class Def>
Scene sceneHolding(const Def& def) {
    Scene scene{.name = "described",
                .bodies = {{"a", {.type = BodyType::Static}}, {"b", {.shapes = {circle(0.5)}}}},
                .joints = {{"h", "a", "b", RevoluteJointDef{}}, {"s", "a", "b", PrismaticJointDef{}}}};
    if constexpr (std::is_same_v<Def, BodyDef>) {
        scene.bodies.push_back({"c", def});
    } else if constexpr (std::is_same_v<Def, FieldDef>) {
        scene.fields.push_back({.name = "f", .def = def, .body = std::holds_alternative<Magnet>(def.law) ? "b" : ""});
    } else if constexpr (std::is_same_v<Def, Wrap>) {
        scene.wrap = def;
    } else if constexpr (std::is_same_v<Def, GearJointDef>) {
        scene.joints.push_back({.name = "j", .def = def, .jointA = "h", .jointB = "s"});
    } else {
        scene.joints.push_back({"j", "b", std::is_same_v<Def, TargetJointDef> ? "" : "a", def});
    }
    return scene;
}

template <class Def>
Def heldBy(const Scene& scene) {
    if constexpr (std::is_same_v<Def, BodyDef>)
        return scene.bodies.back().def;
    else if constexpr (std::is_same_v<Def, FieldDef>)
        return scene.fields.back().def;
    else if constexpr (std::is_same_v<Def, Wrap>)
        return scene.wrap;
    else
        return std::get<Def>(scene.joints.back().def);
}

/// Changes one leaf after the other, of those whose path begins so, and tells of each that is not read as it was, or
/// that the text does not show.
template <class Def>
std::vector<std::string> lostIn(const Def& sound, const std::string& start = "") {
    std::vector<std::string> lost;
    const std::string plain = toJson(sceneHolding(sound));
    CHECK(leavesText(heldBy<Def>(fromJson(plain, "f.json"))) == leavesText(sound));
    std::size_t leaves = 0;
    test::forEachLeaf(sound, [&](const auto&...) { ++leaves; });
    for (std::size_t at = 0; at < leaves; ++at) {
        Def changed = sound;
        std::size_t leaf = 0;
        std::string name;
        test::forEachLeaf(changed, [&]<class T>(const std::string& path, const Member& member, T& value) {
            if (leaf++ != at || !isWritten<T> || !path.starts_with(start)) return;
            change(member, value);
            name = path;
        });
        if (name.empty()) continue;
        CHECK(leavesText(changed) != leavesText(sound));
        const std::string text = toJson(sceneHolding(changed));
        if (text == plain || leavesText(heldBy<Def>(fromJson(text, "f.json"))) != leavesText(changed))
            lost.push_back(name);
    }
    return lost;
}

using Lost = std::vector<std::string>;

}  // namespace

TEST_CASE("each member of each joint comes back from a file when it alone is changed", "[compare][scene][describe]") {
    test::forEachAlternative(std::type_identity<JointDef>(), [&]<class Def>(const Def&) {
        INFO(definitionName<Def>.type);
        CHECK(lostIn(test::soundJoint<Def>({{}, {}}, {{}, {}})) == Lost{});
    });
}

TEST_CASE("each member of a body, its mass, its shapes and their materials comes back from a file",
          "[compare][scene][describe]") {
    const BodyDef body{.shapes = {circle(0.5), capsule({0, 0}, {1, 0}, 0.5), box({1, 1}), segment({0, 0}, {1, 0}),
                                  chain({{0, 0}, {1, 0}, {2, 1}})}};
    BodyDef full = test::filled(body);
    CHECK(lostIn(full, "mass") == Lost{});
    full.mass.reset();  // only a dynamic one has it given
    CHECK(lostIn(full) == Lost{});
}

TEST_CASE("each member of each field and of its region, and of a wrap, comes back from a file",
          "[compare][scene][describe]") {
    test::forEachAlternative(std::type_identity<FieldLaw>(), [&]<class Law>(const Law& law) {
        INFO(definitionName<Law>.type);
        CHECK(lostIn(test::filled(FieldDef{.law = law})) == Lost{});
    });
    CHECK(lostIn(Wrap{.width = 20, .height = 30}) == Lost{});
}

TEST_CASE("what may be infinite in a joint is written and read as such", "[compare][scene][describe]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    test::forEachAlternative(std::type_identity<JointDef>(), [&]<class Def>(const Def&) {
        Def def = test::soundJoint<Def>({{}, {}}, {{}, {}});
        test::forEachLeaf(def, [&]<class T>(const std::string&, const Member& member, T& value) {
            if constexpr (std::is_same_v<T, double>) {
                if (member.allowed.infinite) value = infinity;
                if (member.allowed.minusInfinite) value = -infinity;
            }
        });
        const std::string text = toJson(sceneHolding(def));
        CHECK(leavesText(heldBy<Def>(fromJson(text, "f.json"))) == leavesText(def));
    });
}

}  // namespace plumb::compare
