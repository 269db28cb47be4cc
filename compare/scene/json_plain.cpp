// SPDX-License-Identifier: MIT
#include <compare/scene/json_plain.h>

#include <cmath>

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

}  // namespace plumb::compare
