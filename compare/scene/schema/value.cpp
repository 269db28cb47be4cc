// SPDX-License-Identifier: MIT
#include <compare/scene/schema/value.h>

#include <cstdint>
#include <limits>
#include <string>

#include <compare/scene/fields/tags.h>

namespace plumb::compare {
namespace {

void addBounds(Json& schema, const Allowed& allowed) {
    if (allowed.anything) return;
    if (allowed.beyond != nullptr) {
        schema["minimum"] = -allowed.most;
        schema["maximum"] = allowed.most;
    }
    if (allowed.isRange()) {
        schema["minimum"] = allowed.low;
        schema["maximum"] = allowed.high;
    }
    if (allowed.sign == Allowed::Sign::NotNegative) schema["minimum"] = 0;
    if (allowed.sign == Allowed::Sign::Positive) {
        schema.erase("minimum");
        schema["exclusiveMinimum"] = 0;
    }
    if (!allowed.oneOf.empty()) schema["enum"] = Json(allowed.oneOf);
}

}  // namespace

Json numberSchema(const Allowed& allowed) {
    Json number{{"type", "number"}};
    addBounds(number, allowed);
    if (!allowed.anything && allowed.zero != nullptr) number["not"] = Json{{"const", 0}};
    if (!allowed.infinite && !allowed.minusInfinite) return number;
    Json either = Json::array({number});
    if (allowed.infinite) either.push_back(Json{{"const", infiniteTag}});
    if (allowed.minusInfinite) either.push_back(Json{{"const", minusInfiniteTag}});
    return Json{{"anyOf", either}};
}

Json vectorSchema(const Allowed& allowed) {
    Json coordinate{{"type", "number"}};
    addBounds(coordinate, allowed);
    Json vector{{"type", "array"}, {"items", coordinate}, {"minItems", 2}, {"maxItems", 2}};
    if (!allowed.anything && allowed.zero != nullptr) vector["not"] = Json{{"const", Json::array({0, 0})}};
    return vector;
}

Json signed32Schema() {
    using Limits = std::numeric_limits<std::int32_t>;
    return {{"type", "integer"}, {"minimum", Limits::min()}, {"maximum", Limits::max()}};
}

Json unsigned64Schema() {
    return {{"type", "integer"}, {"minimum", 0}, {"maximum", std::numeric_limits<std::uint64_t>::max()}};
}

void addMeaning(Json& schema, const Member& member) {
    const std::string unit = member.unit;
    schema["description"] = member.meaning + (unit.empty() ? unit : " [" + unit + "]");
    if (!unit.empty()) schema["unit"] = unit;
}

}  // namespace plumb::compare
