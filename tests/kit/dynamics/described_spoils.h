// SPDX-License-Identifier: MIT
// How can each member of a definition be wrong by its description, and what is then said of it?
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <plumb/math/check.h>

#include "kit/dynamics/bad_input.h"
#include "kit/dynamics/described_leaves.h"

namespace plumb::test {

/// A way to spoil a value: what then stands behind its name, as "[1]", and why it is refused.
template <class T>
struct Spoil {
    std::function<void(T&)> spoil;
    std::string behind, complaint;
    bool byWorld = false;  ///< nobody but a world can know that it is wrong
};
template <class T>
using Spoils = std::vector<Spoil<T>>;

/// Just beyond each bound, and far beyond, and what is never allowed.
std::vector<double> numbersOutside(const Allowed& allowed);
/// On each bound.
std::vector<double> numbersAtTheEdge(const Allowed& allowed);
/// "-1 is negative"
std::string complaintOf(const Allowed& allowed, double value, const std::string& text);
/// "-1 is none of Static, Kinematic and Dynamic"
std::string complaintOf(int enumerator, std::span<const char* const> tags);

Spoils<double> spoilsOf(const Bench& bench, const Member& member, const double& value);
Spoils<int> spoilsOf(const Bench& bench, const Member& member, const int& value);
Spoils<Vec2> spoilsOf(const Bench& bench, const Member& member, const Vec2& value);
Spoils<std::vector<Vec2>> spoilsOf(const Bench& bench, const Member& member, const std::vector<Vec2>& value);
Spoils<BodyId> spoilsOf(const Bench& bench, const Member& member, const BodyId& value);
Spoils<JointId> spoilsOf(const Bench& bench, const Member& member, const JointId& value);

template <class T>
Spoils<T> spoilsOf(const Bench&, const Member&, const T& value) {
    Spoils<T> spoils;
    if constexpr (std::is_enum_v<T>)
        for (const int bad : {-1, static_cast<int>(tagsOf(value).size())})
            spoils.push_back({[bad](T& v) { v = static_cast<T>(bad); }, "", complaintOf(bad, tagsOf(value))});
    return spoils;
}

/// "FieldDef.region.radius", but "Drag.wind": a law is refused by its own name.
template <class Def>
std::string fullName(const Def& def, const std::string& path) {
    if constexpr (std::is_same_v<Def, FieldDef>)
        if (path.starts_with("law."))
            return std::visit([]<class Law>(const Law&) { return definitionName<Law>.type; }, def.law) + path.substr(3);
    return std::string(definitionName<Def>.type) + "." + path;
}

/// What is wrong with a definition, and what is to be said of it.
struct Wrong {
    std::string path, behind = {}, complaint = {};
    bool once = false;     ///< cannot be changed later
    bool byWorld = false;  ///< as of a Spoil
};

/// A dynamic body's mass has more conditions, which it is refused by.
std::string complaintOfMass(const std::string& path, const std::string& complaint);

/// Calls visit(bad, wrong) with a definition of which one leaf is spoiled, for each leaf and each way.
template <class Def, class Visit>
void forEachSpoiled(const Bench& bench, const Def& sound, Visit&& visit) {
    for (const std::string& path : leavesOf(sound)) {
        bool more = true;
        for (std::size_t way = 0; more; ++way) {
            Def bad = filled(sound, path);
            Wrong wrong{path};
            forEachLeaf(bad, [&]<class T>(const std::string& at, const Member& member, T& value) {
                if (at != path) return;
                const Spoils<T> spoils = spoilsOf(bench, member, std::as_const(value));
                more = way < spoils.size();
                if (!more) return;
                const Spoil<T>& spoil = spoils[way];
                spoil.spoil(value);
                wrong.behind = spoil.behind, wrong.byWorld = spoil.byWorld, wrong.once = member.allowed.once;
                wrong.complaint = complaintOfMass(path, spoil.complaint);
            });
            if (more) visit(std::as_const(bad), std::as_const(wrong));
        }
    }
}

/// Puts numbers on the bounds of what is allowed into each leaf, and tells of each that take(def) refuses.
template <class Def, class Take>
std::vector<std::string> refusedAtTheEdge(const Def& sound, Take&& take) {
    std::vector<std::string> faults;
    for (const std::string& path : leavesOf(sound)) {
        for (std::size_t edge = 0, edges = 1; edge < edges; ++edge) {
            Def def = filled(sound, path);
            forEachLeaf(def, [&]<class T>(const std::string& at, const Member& member, T& value) {
                if (at != path) return;
                const std::vector<double> numbers = numbersAtTheEdge(member.allowed);
                edges = std::is_arithmetic_v<T> || std::is_same_v<T, Vec2> ? numbers.size() : 0;
                if (edge >= edges) return;
                if constexpr (std::is_same_v<T, Vec2>) value = {numbers[edge], numbers[edge]};
                if constexpr (std::is_arithmetic_v<T>) value = static_cast<T>(numbers[edge]);
            });
            const std::string said = refusalOf([&] { take(def); });
            if (!said.empty()) faults.push_back(said);
        }
    }
    return faults;
}

/// Ways to put a number of any size into a value.
template <class T>
std::vector<std::function<void(T&, double)>> waysToPut(const T&) {
    if constexpr (std::is_same_v<T, double>) return {[](T& v, double number) { v = number; }};
    if constexpr (std::is_same_v<T, Vec2>)
        return {[](T& v, double number) { v = Vec2(number, 0); },
                [](T& v, double number) { v = Vec2(number, -number); }};
    if constexpr (std::is_same_v<T, std::vector<Vec2>>)
        return {[](T& v, double number) { v.at(2).x() = number; },
                [](T& v, double number) {
                    for (Vec2& point : v) point.x() *= std::fabs(number);
                },
                [](T& v, double number) {
                    for (Vec2& point : v) point *= std::fabs(number);
                }};
    return {};
}

/// Puts extreme numbers into each leaf of make(bench); whatever take(bench, def) does not refuse must leave the world
/// sound, which faultAfter steps it for and tells.
template <class Make, class Take>
std::vector<std::string> unsoundWith(Make&& make, Take&& take, std::string (*faultAfter)(World&)) {
    std::vector<std::string> faults;
    const auto tryNumber = [&](const std::string& path, std::size_t way, double number) {
        Bench bench;
        auto def = filled(make(std::as_const(bench)), path);
        if constexpr (requires { def.limit; })
            if (def.limit) def.limit.emplace();
        bool more = false;
        const auto put = [&]<class T>(const std::string& at, const Member&, T& value) {
            if (at != path) return;
            const auto ways = waysToPut(std::as_const(value));
            more = way < ways.size();
            if (more) ways[way](value, number);
        };
        const bool refused = !refusalOf([&] {
                                  forEachLeaf(def, put);
                                  if (more) take(bench, std::as_const(def));
                              }).empty();
        const std::string fault = more && !refused ? faultAfter(bench.world) : "";
        if (!fault.empty()) faults.push_back(path + " = " + toText(number) + ": " + fault);
        return more;
    };
    for (const std::string& path : leavesOf(make(Bench())))
        for (std::size_t way = 0; tryNumber(path, way, 1e-320); ++way)
            for (const double size : extremes)
                for (const double number : {size, -size}) tryNumber(path, way, number);
    return faults;
}

}  // namespace plumb::test
