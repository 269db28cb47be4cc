// SPDX-License-Identifier: MIT
// How can a function of JavaScript be a contact rule? A rule is a plain function pointer; so there are as many as
// JavaScript may have rules at a time, and each asks for its number.
#pragma once
#include <cstddef>

#include <plumb/space/shape_def.h>

namespace plumb::web {

inline constexpr std::size_t mostRules = 64;

/// Rules are numbered from 1; 0 is none. Throws std::invalid_argument on a number above mostRules.
ContactRule ruleOf(std::size_t number);
std::size_t numberOf(ContactRule rule);

}  // namespace plumb::web
