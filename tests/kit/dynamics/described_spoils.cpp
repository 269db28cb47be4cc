// SPDX-License-Identifier: MIT
#include "kit/dynamics/described_spoils.h"

#include <cctype>

namespace plumb::test {

namespace {

/// "1, 4, 8 or 16"
std::string wordsOf(const std::vector<std::string>& words, const std::string& last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " " + last + " " : ", ") + words[i];
    return text;
}

template <class Id>
Spoils<Id> wrongIds(const std::string& thing, const Id& gone, const Id& foreign, const Id& value) {
    const auto put = [](const Id& id) { return [id](Id& v) { v = id; }; };
    Spoils<Id> spoils{
        {put({}), "", "{index 0, generation 0, world 0} names no " + thing + ": it was never set"},
        {put(gone), "", "names no " + thing + " of this world any more: it was removed"},
        {put(foreign), "", "belongs to another world"},
        {put({12345, 0, value.world}), "", "{index 12345, generation 0"},
    };
    for (Spoil<Id>& spoil : spoils) spoil.byWorld = true;
    return spoils;
}

}  // namespace

std::vector<double> numbersOutside(const Allowed& allowed) {
    if (allowed.anything) return {};
    std::vector<double> bad{nan};
    const auto add = [&bad](std::initializer_list<double> more) { bad.insert(bad.end(), more); };
    if (!allowed.infinite) add({infinity});
    if (!allowed.minusInfinite) add({-infinity});
    if (allowed.sign == Allowed::Sign::Positive) add({0});
    if (allowed.sign != Allowed::Sign::Any) add({-1, -5e-324});
    if (allowed.isRange())
        add({std::nextafter(allowed.low, -infinity), std::nextafter(allowed.high, infinity), allowed.low - 1,
             allowed.high + 1});
    for (const int choice : allowed.oneOf) add({choice + 100.0, -1.0 * choice});
    if (allowed.beyond != nullptr) add({std::nextafter(allowed.most, infinity), 1e16});
    if (allowed.beyond != nullptr && allowed.sign == Allowed::Sign::Any) add({-1e16, -1e300});
    if (allowed.zero != nullptr) add({0});
    return bad;
}

std::vector<double> numbersAtTheEdge(const Allowed& allowed) {
    std::vector<double> good;
    const auto add = [&good](std::initializer_list<double> more) { good.insert(good.end(), more); };
    if (allowed.anything) return good;
    if (allowed.infinite) add({infinity});
    if (allowed.minusInfinite) add({-infinity});
    if (allowed.sign == Allowed::Sign::NotNegative) add({0});
    if (allowed.sign == Allowed::Sign::Positive) add({5e-324});
    if (allowed.isRange()) add({allowed.low, allowed.high});
    if (allowed.beyond != nullptr) add({allowed.most});
    if (allowed.beyond != nullptr && allowed.sign == Allowed::Sign::Any) add({-allowed.most});
    good.insert(good.end(), allowed.oneOf.begin(), allowed.oneOf.end());
    return good;
}

std::string complaintOf(const Allowed& allowed, double value, const std::string& text) {
    if (!allowed.oneOf.empty()) {
        std::vector<std::string> choices;
        for (const int choice : allowed.oneOf) choices.push_back(std::to_string(choice));
        return text + " is not " + wordsOf(choices, "or");
    }
    if (!std::isfinite(value)) return text + " is not finite";
    if (allowed.isRange()) {
        const bool tell = allowed.instead != nullptr && value > allowed.high;
        return text + " is not within " + toText(allowed.low) + " to " + toText(allowed.high) +
               (tell ? std::string("; ") + allowed.instead : "");
    }
    if (allowed.sign == Allowed::Sign::Positive && value <= 0) return text + " is not positive";
    if (allowed.sign == Allowed::Sign::NotNegative && value < 0) return text + " is negative";
    if (std::fabs(value) > allowed.most) return text + " is beyond " + toText(allowed.most) + ", " + allowed.beyond;
    return text + " " + allowed.zero;
}

std::string complaintOf(int enumerator, std::span<const char* const> tags) {
    std::vector<std::string> names(tags.begin(), tags.end());
    for (std::string& name : names) name[0] = static_cast<char>(std::toupper(name[0]));
    return std::to_string(enumerator) + " is none of " + wordsOf(names, "and");
}

std::string complaintOfMass(const std::string& path, const std::string& complaint) {
    const std::string number = complaint.substr(0, complaint.find(' '));
    if (path == "mass.mass") return number + " is not a positive finite mass";
    if (path == "mass.inertia") return number + " is not a positive finite moment of inertia";
    return complaint;
}

Spoils<double> spoilsOf(const Bench&, const Member& member, const double&) {
    Spoils<double> spoils;
    for (const double bad : numbersOutside(member.allowed))
        spoils.push_back({[bad](double& v) { v = bad; }, "", complaintOf(member.allowed, bad, toText(bad))});
    return spoils;
}

Spoils<int> spoilsOf(const Bench&, const Member& member, const int&) {
    Spoils<int> spoils;
    for (const double bad : numbersOutside(member.allowed))
        if (std::fabs(bad) < 2e9 && bad == std::trunc(bad))
            spoils.push_back(
                {[bad](int& v) { v = static_cast<int>(bad); }, "", complaintOf(member.allowed, bad, toText(bad))});
    return spoils;
}

Spoils<Vec2> spoilsOf(const Bench&, const Member& member, const Vec2& value) {
    Spoils<Vec2> spoils;
    const auto add = [&](double number, const Vec2& bad) {
        spoils.push_back({[bad](Vec2& v) { v = bad; }, "", complaintOf(member.allowed, number, toText(bad))});
    };
    for (const double bad : numbersOutside(member.allowed)) {
        if (bad == 0) continue;
        add(bad, {bad, value.y()});
        add(bad, {value.x(), bad});
    }
    if (member.allowed.zero != nullptr) add(0, {0, 0});
    if (member.allowed.anchor != AnchorOf::None)
        spoils.push_back(
            {[](Vec2& v) { v = Vec2(3e5, 0); }, "", "(300000, 0) is more than 100000 m from the body it is on", true});
    return spoils;
}

Spoils<std::vector<Vec2>> spoilsOf(const Bench&, const Member& member, const std::vector<Vec2>& value) {
    Spoils<std::vector<Vec2>> spoils;
    for (const double bad : numbersOutside(member.allowed))
        for (std::size_t i = 0; i < value.size(); ++i)
            for (const Vec2& point : {Vec2(bad, value[i].y()), Vec2(value[i].x(), bad)})
                spoils.push_back({[i, point](std::vector<Vec2>& v) { v[i] = point; }, "[" + std::to_string(i) + "]",
                                  complaintOf(member.allowed, bad, toText(point))});
    return spoils;
}

Spoils<BodyId> spoilsOf(const Bench& bench, const Member&, const BodyId& value) {
    return wrongIds("body", bench.gone, bench.foreign, value);
}

Spoils<JointId> spoilsOf(const Bench& bench, const Member&, const JointId& value) {
    return wrongIds("joint", bench.goneJoint, bench.foreignJoint, value);
}

}  // namespace plumb::test
