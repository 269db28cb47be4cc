// SPDX-License-Identifier: MIT
#include <plumb/math/check.h>

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace plumb {
namespace {

// Not snprintf, whose decimal separator depends on the locale.
std::string withDigits(double value, int digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << value;
    return out.str();
}

double read(const std::string& text) {
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double value = 0;
    in >> value;
    return value;
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
    for (int digits = 15; digits < 17; ++digits) {
        const std::string text = withDigits(value, digits);
        if (read(text) == value) return text;
    }
    return withDigits(value, 17);
}

std::string toText(const Vec2& value) {
    return "(" + toText(value.x()) + ", " + toText(value.y()) + ")";
}

}  // namespace plumb
