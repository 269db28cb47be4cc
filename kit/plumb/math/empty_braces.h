// SPDX-License-Identifier: MIT
// What does X x({}) mean, for a class X that is made from a definition?
#pragma once

namespace plumb::detail {

/// Empty braces are converted to this enumeration without a user-defined conversion, so a constructor that takes it is
/// preferred to those that take a definition or another X, which would be ambiguous.
enum class EmptyBraces {};

}  // namespace plumb::detail
