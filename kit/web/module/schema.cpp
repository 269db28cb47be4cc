// SPDX-License-Identifier: MIT
// Prints, as JSON, what JavaScript has to know to call the kit: each struct with its members, their kinds, defaults,
// units and meanings; each enumeration; each function with its parameters. Run while the module is built.
#include <cmath>
#include <iostream>
#include <set>

#include <nlohmann/json.hpp>

#include <plumb/dynamics/describe.h>
#include <web/module/world_calls.h>

namespace plumb::web {

using Json = nlohmann::ordered_json;

Json types = Json::object();
Json enumerations = Json::object();

/// "CastHit" of "plumb::CastHit".
template <class T>
std::string nameOfType() {
    return std::string(lastWord(__PRETTY_FUNCTION__));
}

std::string camelCase(std::string_view name) {
    std::string text(name);
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

template <class E, int... I>
Json enumeratorNames(std::integer_sequence<int, I...>) {
    return Json{camelCase(nameOfEnumerator<static_cast<E>(I)>())...};
}

template <class T>
void defineType();

/// What kind of value is it in JavaScript? A word, or an object with what it is made of.
template <class T>
Json kindOf() {
    if constexpr (isState<T>) {
        return {{"state", nameOfType<T>()}, {"words", stateWords<T>}};
    } else if constexpr (isBits<T>) {
        return "bits";
    } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, Lock>) {
        return "bool";
    } else if constexpr (std::is_integral_v<T>) {
        return {{"integer", {std::numeric_limits<T>::min(), std::numeric_limits<T>::max()}}};
    } else if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, Rot>) {
        return "number";
    } else if constexpr (std::is_enum_v<T>) {
        enumerations[nameOfType<T>()] = enumeratorNames<T>(std::make_integer_sequence<int, enumeratorCount<T>()>{});
        return {{"oneOf", nameOfType<T>()}};
    } else if constexpr (std::is_same_v<T, Vec2>) {
        return "vec";
    } else if constexpr (std::is_same_v<T, ContactRule>) {
        return "rule";
    } else if constexpr (std::is_same_v<T, std::string>) {
        return "text";
    } else if constexpr (isOf<T, std::optional>) {
        return {{"maybe", kindOf<typename T::value_type>()}};
    } else if constexpr (isOf<T, std::map>) {
        return {{"mapTo", kindOf<typename T::mapped_type>()}};
    } else if constexpr (isOf<T, std::vector> || isSpan<T> || isArray<T>) {
        return {{"listOf", kindOf<typename T::value_type>()}};
    } else if constexpr (isOf<T, std::variant>) {
        return []<class... Ts>(std::variant<Ts...>*) {
            Json tags = Json::object();
            ((tags[definitionName<Ts>.tag] = kindOf<Ts>()), ...);
            return Json{{"either", tags}};
        }(static_cast<T*>(nullptr));
    } else {
        defineType<T>();
        return {{"struct", nameOfType<T>()}};
    }
}
template <>
Json kindOf<MotionPath>() {
    return kindOf<PathPieces>();
}

Json valueOf(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity";
}

/// A value as JavaScript writes it; numbers that JSON has not are words.
template <class T>
Json valueOf(const T& value) {
    if constexpr (isBits<T>) {
        return std::to_string(value);
    } else if constexpr (std::is_same_v<T, Lock>) {
        return static_cast<bool>(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
        return value;
    } else if constexpr (std::is_enum_v<T>) {
        (void)kindOf<T>();
        return enumerations[nameOfType<T>()][static_cast<std::size_t>(value)];
    } else if constexpr (std::is_same_v<T, Vec2>) {
        return {valueOf(value.x()), valueOf(value.y())};
    } else if constexpr (std::is_same_v<T, Rot>) {
        return value.angle();
    } else if constexpr (std::is_same_v<T, std::string>) {
        return value;
    } else if constexpr (isOf<T, std::optional>) {
        return value ? valueOf(*value) : Json();
    } else if constexpr (isOf<T, std::vector> || isSpan<T> || isArray<T>) {
        Json list = Json::array();
        for (const auto& one : value) list.push_back(valueOf(one));
        return list;
    } else if constexpr (isOf<T, std::variant>) {
        return std::visit(
            []<class One>(const One& one) {
                return Json{{definitionName<One>.tag, valueOf(one)}};
            },
            value);
    } else if constexpr (isState<T> || std::is_same_v<T, ContactRule> || std::is_same_v<T, PassRule> ||
                         std::is_same_v<T, TileMap>) {
        return nullptr;
    } else {
        Json object = Json::object();
        const auto names = memberNames<T>();
        std::size_t i = 0;
        forEachMember(value, [&]<class M>(const M& member) {
            const std::string name(names[i++]);
            if constexpr (!std::is_same_v<M, PassRule>) object[name] = valueOf(member);
        });
        return object;
    }
}

/// Units and meanings, where the kit describes the struct.
struct Meanings {
    Json& members;
    void operator()(const Member& member, const auto&) const {
        for (Json& m : members)
            if (m["name"] == member.name) m["unit"] = member.unit, m["meaning"] = member.meaning;
    }
};

template <class T>
void addMembers(const T& example, Json& members) {
    const auto names = memberNames<T>();
    std::size_t i = 0;
    forEachMember(example, [&]<class M>(const M& member) {
        const std::string name(names[i++]);
        if constexpr (!std::is_same_v<M, PassRule>)
            members.push_back({{"name", name}, {"kind", kindOf<M>()}, {"value", valueOf(member)}});
    });
    if constexpr (requires { describe(example, Meanings{members}); }) describe(example, Meanings{members});
}

template <class T>
T exampleOf() {
    if constexpr (std::is_same_v<T, PathMoverDef>)
        return {.path = MotionPath({0, 0})};
    else if constexpr (std::is_same_v<T, WanderState>)
        return {.random = Random(0)};
    else if constexpr (std::is_same_v<T, WanderStep>)
        return {.state = exampleOf<WanderState>()};
    else
        return {};
}

template <class T>
void defineType() {
    const std::string name = nameOfType<T>();
    if (types.contains(name)) return;
    types[name] = Json::array();
    Json members = Json::array();
    if constexpr (std::is_same_v<T, TileMap>) {
        addMembers(TileMapDef{}, members);
        members.push_back({{"name", "tiles"},
                           {"kind", kindOf<std::vector<Tile>>()},
                           {"value", Json::array({valueOf(Tile{})})},
                           {"unit", ""},
                           {"meaning", "row by row, from the lowest"}});
    } else {
        addMembers(exampleOf<T>(), members);
    }
    types[name] = members;
}
template <>
Json valueOf(const MotionPath&) {
    return nullptr;
}

template <class A>
Json kindOfArgument() {
    using T = std::remove_cvref_t<A>;
    if constexpr (std::is_same_v<T, World> || std::is_same_v<T, WorldHost>)
        return "world";
    else if constexpr (isView<T>)
        return {{"view", nameOfType<T>()}};
    else if constexpr (isHeld<T>)
        return "mover";
    else
        return kindOf<T>();
}

template <class R>
Json kindOfResult() {
    using T = std::remove_cvref_t<R>;
    if constexpr (std::is_void_v<T>)
        return "nothing";
    else
        return kindOfArgument<R>();
}

struct CallList {
    Json calls = Json::array();

    template <auto Function>
    void operator()(const char* owner, const char* name, const char* parameters, Fn<Function>) {
        using S = Signature<std::remove_const_t<decltype(Function)>>;
        bool changes = false;
        Json kinds = [&changes]<class... A>(Types<A...>) {
            changes = changesState<std::tuple_element_t<0, std::tuple<A..., void>>>;
            return Json::array({kindOfArgument<A>()...});
        }(typename S::Arguments{});
        calls.push_back({{"owner", owner},
                         {"name", name},
                         {"parameters", parameters},
                         {"kinds", kinds},
                         {"result", kindOfResult<typename S::Result>()}});
        if (changes) calls.back()["changesState"] = true;
    }
};

}  // namespace plumb::web

int main() {
    using namespace plumb::web;
    CallList list;
    listAllCalls(list);
    (void)kindOf<plumb::ContactCandidate>();
    std::cout << Json{{"types", types}, {"enumerations", enumerations}, {"mostRules", mostRules}, {"calls", list.calls}}
                     .dump(1)
              << '\n';
}
