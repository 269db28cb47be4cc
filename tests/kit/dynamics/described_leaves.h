// SPDX-License-Identifier: MIT
// Which numbers, vectors, flags and names does a definition hold in the end, by its description?
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <plumb/dynamics/describe.h>

namespace plumb::test {

template <class T>
inline constexpr bool isVariantType = false;
template <class... T>
inline constexpr bool isVariantType<std::variant<T...>> = true;
template <class T>
inline constexpr bool isOptionalType = false;
template <class T>
inline constexpr bool isOptionalType<std::optional<T>> = true;

/// What is said of the members of each definition, and of those that are members of it, by the definition's name.
using Descriptions = std::map<std::string, std::vector<Member>>;
Descriptions allDescriptions();

/// Calls leaf(path, member, value) for each member that has none of its own; what an empty optional could hold is none.
template <class Leaf>
struct LeafWalk {
    Leaf& leaf;
    std::string path = {};

    template <class T>
    void operator()(const Member& member, T& value) const {
        using Value = std::remove_const_t<T>;
        const std::string name = path + member.name;
        if constexpr (isOptionalType<Value>) {
            if (value) (*this)(member, *value);
        } else if constexpr (isVariantType<Value>) {
            std::visit([&](auto& kind) { (*this)(member, kind); }, value);
        } else if constexpr (std::is_same_v<Value, std::vector<ShapeDef>>) {
            for (std::size_t i = 0; i < value.size(); ++i)
                describe(value[i], LeafWalk{leaf, name + "[" + std::to_string(i) + "]."});
        } else if constexpr (Described<Value> && !std::is_same_v<Value, TileMap>) {
            describe(value, LeafWalk{leaf, name + "."});
        } else {
            leaf(name, member, value);
        }
    }
};

template <class Def, class Leaf>
void forEachLeaf(Def& def, Leaf&& leaf) {
    describe(def, LeafWalk<std::remove_reference_t<Leaf>>{leaf});
}

/// Puts something sound into all that a definition may go without, or only into what holds one leaf.
struct Fill {
    std::string only = {}, path = {};

    template <class T>
    void operator()(const Member& member, T& value) const {
        const std::string name = path + member.name;
        if (!only.empty() && only != name && !only.starts_with(name + ".") && !only.starts_with(name + "[")) return;
        if constexpr (std::is_same_v<T, std::optional<double>>) value = 1;
        if constexpr (std::is_same_v<T, std::optional<Vec2>>) value = Vec2(0, 1);
        if constexpr (std::is_same_v<T, std::optional<Limit>>) value = Limit{-1, 1};
        if constexpr (std::is_same_v<T, std::optional<Spring>>) value = Spring{2, 1};
        if constexpr (std::is_same_v<T, std::optional<Mass>>) value = Mass{2, {0.25, 0}, 1};
        if constexpr (std::is_same_v<T, std::optional<Shape>>) value = Circle{2};
        if constexpr (isVariantType<T>) {
            std::visit([&](auto& kind) { fill(kind, name); }, value);
        } else if constexpr (std::is_same_v<T, std::vector<ShapeDef>>) {
            for (std::size_t i = 0; i < value.size(); ++i) fill(value[i], name + "[" + std::to_string(i) + "]");
        } else {
            fill(value, name);
        }
    }
    template <class T>
    void fill(T& value, const std::string& name) const {
        if constexpr (Described<T> && !std::is_same_v<T, TileMap>) describe(value, Fill{only, name + "."});
    }
};

template <class Def>
Def filled(Def def, const std::string& only = {}) {
    describe(def, Fill{only});
    return def;
}

/// Of all that a definition can hold.
template <class Def>
std::vector<std::string> leavesOf(const Def& sound) {
    std::vector<std::string> paths;
    const Def all = filled(sound);
    forEachLeaf(all, [&](const std::string& path, const auto&...) { paths.push_back(path); });
    return paths;
}

/// A joint of any kind that a world takes, between two bodies or two joints: points that no two members share.
template <class Def>
Def soundJoint(const BodyId (&bodies)[2], const JointId (&joints)[2]) {
    Def def = filled(Def{});
    std::size_t body = 0, joint = 0;
    double along = 0;
    forEachLeaf(def, [&]<class T>(const std::string&, const Member&, T& value) {
        if constexpr (std::is_same_v<T, BodyId>) value = bodies[body++];
        if constexpr (std::is_same_v<T, JointId>) value = joints[joint++];
        if constexpr (std::is_same_v<T, Vec2>) value = {along += 0.25, 1};
    });
    return def;
}

/// Calls visit(def) with a default one of each alternative that is described by its members.
template <class Visit, class... Kinds>
void forEachAlternative(std::type_identity<std::variant<Kinds...>>, Visit&& visit) {
    const auto each = [&]<class Kind>(const Kind& kind) {
        if constexpr (!std::is_same_v<Kind, TileMap>) visit(kind);
    };
    (each(Kinds{}), ...);
}

}  // namespace plumb::test
