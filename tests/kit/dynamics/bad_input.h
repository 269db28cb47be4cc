// SPDX-License-Identifier: MIT
// How can each field of what goes into the kit be wrong, and what is then said of it?
#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <plumb/plumb.h>

#include "numbers.h"

namespace plumb::test {

/// A way to spoil a thing, and what is then said: "<name of the thing>.<field><member>: <complaint>..."
template <class T>
struct Spoil {
    std::function<void(T&)> spoil;
    std::string member, complaint;
};

/// A field with all the ways to spoil it, none if nothing can be wrong with it; put sets what is a number in it, for
/// numbers of any size.
template <class T>
struct Field {
    std::string name;
    std::vector<Spoil<T>> spoils = {};
    std::vector<std::function<void(T&, double)>> put = {};
};

template <class T>
using Fields = std::vector<Field<T>>;

/// A number that is wrong, and why.
struct BadNumber {
    double value;
    std::string text, complaint;
};
using BadNumbers = std::vector<BadNumber>;

inline BadNumbers joined(BadNumbers a, const BadNumbers& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
inline const BadNumbers notANumber{{nan, "nan", "is not finite"}};
inline const BadNumbers infinite{{infinity, "inf", "is not finite"}, {-infinity, "-inf", "is not finite"}};
inline const BadNumbers belowZero{{-1, "-1", "is negative"}, {-1e-300, "-1e-300", "is negative"}};
inline const BadNumbers upToZero{{-1, "-1", "is not positive"}, {0, "0", "is not positive"}};
inline const BadNumbers notFinite = joined(notANumber, infinite);
inline const BadNumbers negative = joined(notFinite, belowZero);
inline const BadNumbers notPositive = joined(notFinite, upToZero);
/// Where infinity is a number as good as any.
inline const BadNumbers negativeBound = joined(joined(notANumber, {infinite[1]}), belowZero);
inline const BadNumbers notPositiveBound = joined(joined(notANumber, {infinite[1]}), upToZero);

/// Nothing that it can hold is wrong.
template <class T>
Field<T> anything(const std::string& name) {
    return {name};
}

/// A number, or a vector of which each coordinate may be wrong, or an optional one.
template <class T, class Value>
Field<T> number(const std::string& name, Value T::*at, const BadNumbers& bads) {
    Field<T> field{name};
    if constexpr (std::is_same_v<Value, Vec2> || std::is_same_v<Value, std::optional<Vec2>>) {
        for (const BadNumber& bad : bads) {
            const double value = bad.value;
            field.spoils.push_back(
                {[=](T& t) { t.*at = Vec2(value, 0); }, "", "(" + bad.text + ", 0) " + bad.complaint});
            field.spoils.push_back(
                {[=](T& t) { t.*at = Vec2(0, value); }, "", "(0, " + bad.text + ") " + bad.complaint});
        }
        field.put = {[=](T& t, double value) { t.*at = Vec2(value, 0); },
                     [=](T& t, double value) { t.*at = Vec2(value, -value); }};
    } else {
        for (const BadNumber& bad : bads)
            field.spoils.push_back(
                {[=, value = bad.value](T& t) { t.*at = value; }, "", bad.text + " " + bad.complaint});
        field.put = {[=](T& t, double value) { t.*at = value; }};
    }
    return field;
}

/// A part with fields of its own: part(t) makes a sound one there, and gives it; member is what stands before theirs.
template <class T, class Part>
Field<T> nested(const std::string& name, const std::string& member, std::function<Part&(T&)> part,
                const Fields<Part>& fields) {
    Field<T> field{name};
    for (const Field<Part>& inner : fields) {
        for (const Spoil<Part>& spoil : inner.spoils)
            field.spoils.push_back({[part, spoil = spoil.spoil](T& t) { spoil(part(t)); },
                                    member + "." + inner.name + spoil.member, spoil.complaint});
        for (const auto& put : inner.put) field.put.push_back([part, put](T& t, double value) { put(part(t), value); });
    }
    return field;
}
template <class T, class Part>
Field<T> nested(const std::string& name, std::optional<Part> T::*at, const Fields<Part>& fields) {
    return nested<T, Part>(
        name, "", [at](T& t) -> Part& { return (t.*at).emplace(); }, fields);
}
template <class T, class Part>
Field<T> nested(const std::string& name, Part T::*at, const Fields<Part>& fields) {
    return nested<T, Part>(
        name, "", [at](T& t) -> Part& { return t.*at; }, fields);
}

/// The same, and more ways to spoil it.
template <class T>
Field<T> with(Field<T> field, const std::vector<Spoil<T>>& more) {
    field.spoils.insert(field.spoils.end(), more.begin(), more.end());
    return field;
}
template <class T>
Field<T> with(Field<T> field, const Field<T>& more) {
    field.put.insert(field.put.end(), more.put.begin(), more.put.end());
    return with(std::move(field), more.spoils);
}

/// Names of fields by the name of their struct, and of parameters by that of their function.
using Covered = std::map<std::string, std::vector<std::string>>;

template <class T>
void cover(Covered& covered, const std::string& name, const Fields<T>& fields) {
    for (const Field<T>& field : fields) covered[name].push_back(field.name);
}

/// What each table has.
Covered coveredDefs();
Covered coveredJoints();
Covered coveredCalls();

/// A world with something of everything in it, to which bad input is given.
struct Bench {
    World world, other;
    BodyId floor, lift, ball, crate, sleeper, gone, foreign, wall;
    JointId hinge, slide, rod, goneJoint, foreignJoint;
    ShapeId ballShape, goneShape, liftShape;
    Bench();
};

/// All that can be seen of a world, to the last bit, and in words.
std::string stateOf(const World& world);

/// Calls, and says why it was refused; "" if it was not.
std::string refusalOf(const std::function<void()>& call);

/// Says how the refusal is not what it should be, or how the world has changed; "" when all is well.
std::string faultOf(Bench& bench, const std::function<void()>& call, const std::string& field,
                    const std::string& complaint);

/// Gives each spoiled thing to take(bench, thing), and tells of each that is not refused as it should be.
template <class T, class Take>
std::vector<std::string> faultsOf(const std::string& name, const Fields<T>& fields, const T& sound, Take&& take) {
    std::vector<std::string> faults;
    Bench bench;
    for (const Field<T>& field : fields) {
        for (const Spoil<T>& spoil : field.spoils) {
            T bad = sound;
            spoil.spoil(bad);
            const std::string fault = faultOf(
                bench, [&] { take(bench, bad); }, name + "." + field.name + spoil.member, spoil.complaint);
            if (!fault.empty()) faults.push_back(fault);
        }
    }
    return faults;
}

/// Numbers that a float cannot hold, or hardly.
inline const std::vector<double> extremes{1e-320, 1e-30, 1e12, 1e39, 1e160, 1.7e308, infinity};

/// Steps for a second, and tells of a body that is neither finite nor in quarantine; "" if there is none.
std::string unsoundAfter(World& world);
/// And of one that is in quarantine.
std::string unsoundOrQuarantinedAfter(World& world);

/// Puts extreme numbers into each field; whatever take(bench, thing) does not refuse must leave the world sound, which
/// faultAfter steps it for and tells.
template <class T, class Take>
std::vector<std::string> unsoundWith(const std::string& name, const Fields<T>& fields, const T& sound, Take&& take,
                                     std::string (*faultAfter)(World&) = unsoundAfter) {
    std::vector<std::string> faults;
    for (const Field<T>& field : fields) {
        for (std::size_t way = 0; way < field.put.size(); ++way) {
            for (const double size : extremes) {
                for (const double value : {size, -size}) {
                    Bench bench;
                    T extreme = sound;
                    const auto give = [&] {
                        field.put[way](extreme, value);
                        take(bench, extreme);
                    };
                    if (!refusalOf(give).empty()) continue;
                    const std::string fault = faultAfter(bench.world);
                    if (fault.empty()) continue;
                    faults.push_back(name + "." + field.name + " (" + std::to_string(way) +
                                     ") = " + std::to_string(value) + ": " + fault);
                }
            }
        }
    }
    return faults;
}

}  // namespace plumb::test
