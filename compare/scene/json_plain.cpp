// SPDX-License-Identifier: MIT
#include <compare/scene/json_plain.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/math/check.h>

namespace plumb::compare {

Json plainJson(double value) {
    return value;
}
Json plainJson(bool value) {
    return value;
}
Json plainJson(int value) {
    return value;
}
Json plainJson(std::uint64_t value) {
    return value;
}
Json plainJson(Lock value) {
    return static_cast<bool>(value);
}
Json plainJson(const std::string& value) {
    return value;
}
Json plainJson(const Vec2& value) {
    return Json::array({value.x(), value.y()});
}

Json numberOrWord(double value) {
    return !std::isinf(value) ? Json(value) : Json(value > 0 ? infiniteTag : minusInfiniteTag);
}

Json tagJson(std::span<const char* const> tags, std::size_t which) {
    return tags[which];
}

void refuseKind(const std::string& path, const Json& value, const std::string& wanted) {
    std::string given = value.dump();
    if (given.size() > 40) given = given.substr(0, 37) + "...";
    refuse(path.empty() ? "scene" : path, given + " is not " + wanted);
}

std::string oneOfText(std::span<const char* const> tags) {
    std::string text;
    for (std::size_t i = 0; i < tags.size(); ++i)
        text += (i == 0 ? "" : i + 1 == tags.size() ? " or " : ", ") + std::string(tags[i]);
    return text;
}

void readPlain(const Json& json, const std::string& path, double& value) {
    if (!json.is_number()) refuseKind(path, json, "a number");
    value = json.get<double>();
}
void readPlain(const Json& json, const std::string& path, bool& value) {
    if (!json.is_boolean()) refuseKind(path, json, "true or false");
    value = json.get<bool>();
}
void readPlain(const Json& json, const std::string& path, int& value) {
    const auto fits = [&] {
        const auto wide = json.get<std::int64_t>();
        return wide >= std::numeric_limits<int>::min() && wide <= std::numeric_limits<int>::max();
    };
    const bool beyond = json.is_number_unsigned() && json.get<std::uint64_t>() > std::numeric_limits<int>::max();
    if (!json.is_number_integer() || beyond || !fits()) refuseKind(path, json, "a whole number of 32 bits");
    value = json.get<int>();
}
void readPlain(const Json& json, const std::string& path, std::uint64_t& value) {
    if (!json.is_number_unsigned()) refuseKind(path, json, "a whole number from 0 to 2^64 - 1");
    value = json.get<std::uint64_t>();
}
void readPlain(const Json& json, const std::string& path, Lock& value) {
    bool locked = false;
    readPlain(json, path, locked);
    value = locked;
}
void readPlain(const Json& json, const std::string& path, std::string& value) {
    if (!json.is_string()) refuseKind(path, json, "a text");
    value = json.get<std::string>();
}
void readPlain(const Json& json, const std::string& path, Vec2& value) {
    if (!json.is_array() || json.size() != 2) refuseKind(path, json, "two numbers [x, y]");
    readPlain(json[0], path + "[0]", value.x());
    readPlain(json[1], path + "[1]", value.y());
}

void readNumberOrWord(const Json& json, const std::string& path, double& value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (json.is_number())
        value = json.get<double>();
    else if (json == infiniteTag)
        value = infinity;
    else if (json == minusInfiniteTag)
        value = -infinity;
    else
        refuseKind(path, json, "a number or " + Json(infiniteTag).dump());
}

std::size_t readTag(const Json& json, const std::string& path, std::span<const char* const> tags) {
    const auto tag = std::ranges::find_if(tags, [&](const char* name) { return json == name; });
    if (tag == tags.end()) refuseKind(path, json, oneOfText(tags));
    return static_cast<std::size_t>(tag - tags.begin());
}

}  // namespace plumb::compare
