// SPDX-License-Identifier: MIT
#include <plumb/math/require_members.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <plumb/math/check.h>
#include <plumb/math/function_ref.h>

namespace plumb {

namespace {

/// "1, 4, 8 or 16"
std::string listed(std::size_t count, const char* last, FunctionRef<std::string(std::size_t)> itemAt) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) list += (i == 0 ? "" : i + 1 == count ? last : ", ") + itemAt(i);
    return list;
}

}  // namespace

std::string MemberPath::text() const {
    std::string path(name);
    if (index >= 0) path += "[" + std::to_string(index) + "]";
    return within != nullptr ? within->text(path) : path;
}

std::string MemberPath::text(std::string_view member) const {
    return member.empty() ? text() : text().append(".").append(member);
}

// What is as it should be is not given a name, which would take much longer than the check.

void requireFinite(double value, const MemberPath& path, const char* member) {
    if (!std::isfinite(value)) requireFinite(value, path.text(member));
}

void requireFinite(const Vec2& value, const MemberPath& path, const char* member) {
    if (!value.allFinite()) requireFinite(value, path.text(member));
}

void requireFinite(std::span<const Vec2> values, const MemberPath& path, const char* member) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!values[i].allFinite()) requireFinite(values[i], path.text(member) + "[" + std::to_string(i) + "]");
}

void requireNotNegative(double value, const MemberPath& path, const char* member) {
    if (!std::isfinite(value) || value < 0) requireNotNegative(value, path.text(member));
}

void requirePositive(double value, const MemberPath& path, const char* member) {
    if (!std::isfinite(value) || value <= 0) requirePositive(value, path.text(member));
}

void requireWithin(double value, double low, double high, const MemberPath& path, const char* member) {
    if (!(value >= low && value <= high)) requireWithin(value, low, high, path.text(member));
}

void requireWithin(double value, double low, double high, const char* instead, const MemberPath& path,
                   const char* member) {
    if (std::isfinite(value) && value > high)
        refuse(path.text(member),
               toText(value) + " is not within " + toText(low) + " to " + toText(high) + "; " + instead);
    requireWithin(value, low, high, path, member);
}

void requireOneOf(double value, std::span<const int> choices, const MemberPath& path, const char* member) {
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    const auto choiceAt = [&](std::size_t i) { return std::to_string(choices[i]); };
    refuse(path.text(member), toText(value) + " is not " + listed(choices.size(), " or ", choiceAt));
}

void requireEnumerator(int number, std::span<const char* const> tags, const MemberPath& path, const char* member) {
    if (number >= 0 && static_cast<std::size_t>(number) < tags.size()) return;
    // A file says "geometricMean", and code GeometricMean.
    const auto enumeratorAt = [&](std::size_t i) {
        std::string name = tags[i];
        name[0] = static_cast<char>(std::toupper(name[0]));
        return name;
    };
    refuse(path.text(member), std::to_string(number) + " is none of " + listed(tags.size(), " and ", enumeratorAt));
}

void requireUpTo(double value, double most, const char* why, const MemberPath& path, const char* member) {
    if (!(std::fabs(value) <= most))
        refuse(path.text(member), toText(value) + " is beyond " + toText(most) + ", " + why);
}

void requireUpTo(const Vec2& value, double most, const char* why, const MemberPath& path, const char* member) {
    if (!(value.cwiseAbs().maxCoeff() <= most))
        refuse(path.text(member), toText(value) + " is beyond " + toText(most) + ", " + why);
}

void refuseZero(const char* value, const char* why, const MemberPath& path, const char* member) {
    refuse(path.text(member), std::string(value) + " " + why);
}

}  // namespace plumb
