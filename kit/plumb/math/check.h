// SPDX-License-Identifier: MIT
// Is this number valid input? If not, which error is thrown?
#pragma once
#include <string>
#include <string_view>

#include <plumb/math/vec2.h>

namespace plumb {

// Each throws std::invalid_argument with "<field><member>: <value> <what is wrong>" unless the value is as the
// function's name says. member is separate so that a caller need not build a string for each member of a structure.

void requireFinite(double value, std::string_view field, std::string_view member = {});
void requireFinite(const Vec2& value, std::string_view field, std::string_view member = {});
void requirePositive(double value, std::string_view field, std::string_view member = {});       ///< and finite
void requirePositive(const Vec2& value, std::string_view field, std::string_view member = {});  ///< both, and finite
void requireNotNegative(double value, std::string_view field, std::string_view member = {});    ///< and finite
void requireWithin(double value, double low, double high, std::string_view field, std::string_view member = {});

/// Throws std::invalid_argument with "<field>: <complaint>".
[[noreturn]] void refuse(std::string_view field, std::string_view complaint);

/// The fewest digits, 15 or more, that read back as the same number; "nan", "inf", "-inf".
std::string toText(double value);
std::string toText(const Vec2& value);  ///< "(x, y)"

}  // namespace plumb
