// SPDX-License-Identifier: MIT
#include <plumb/math/check.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace plumb {
namespace {

/// In the style of the program's locale, whose decimal separator may be another than a full stop. Not a stream: those
/// are large.
std::string withDigits(double value, int digits) {
    char text[32];
    return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.*g", digits, value))};
}

/// The shortest text from which the value can be read back, in the style of the locale.
std::string shortText(double value) {
    for (int digits = 15; digits < 17; ++digits) {
        const std::string text = withDigits(value, digits);
        if (std::strtod(text.c_str(), nullptr) == value) return text;
    }
    return withDigits(value, 17);
}

[[noreturn]] void refuse(std::string_view field, std::string_view member, const std::string& value,
                         const std::string& complaint) {
    plumb::refuse(std::string(field).append(member), value + " " + complaint);
}

}  // namespace

void requireFinite(double value, std::string_view field, std::string_view member) {
    if (!std::isfinite(value)) refuse(field, member, toText(value), "is not finite");
}

void requireFinite(const Vec2& value, std::string_view field, std::string_view member) {
    if (!std::isfinite(value.x()) || !std::isfinite(value.y())) refuse(field, member, toText(value), "is not finite");
}

void requirePositive(double value, std::string_view field, std::string_view member) {
    requireFinite(value, field, member);
    if (!(value > 0)) refuse(field, member, toText(value), "is not positive");
}

void requirePositive(const Vec2& value, std::string_view field, std::string_view member) {
    requireFinite(value, field, member);
    if (!(value.x() > 0 && value.y() > 0)) refuse(field, member, toText(value), "is not positive");
}

void requireNotNegative(double value, std::string_view field, std::string_view member) {
    requireFinite(value, field, member);
    if (value < 0) refuse(field, member, toText(value), "is negative");
}

void requireWithin(double value, double low, double high, std::string_view field, std::string_view member) {
    requireFinite(value, field, member);
    if (value < low || value > high)
        refuse(field, member, toText(value), "is not within " + toText(low) + " to " + toText(high));
}

void refuse(std::string_view field, std::string_view complaint) {
    throw std::invalid_argument(std::string(field).append(": ").append(complaint));
}

std::string toText(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    std::string text = shortText(value);
    const std::string_view separator = std::localeconv()->decimal_point;
    if (const std::size_t at = text.find(separator); at != std::string::npos) text.replace(at, separator.size(), ".");
    return text;
}

std::string toText(const Vec2& value) {
    return "(" + toText(value.x()) + ", " + toText(value.y()) + ")";
}

}  // namespace plumb
