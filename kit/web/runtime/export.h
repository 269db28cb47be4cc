// SPDX-License-Identifier: MIT
// How does JavaScript come to call a function of C++ by its name?
#pragma once

/// Stands before the definition of a function that takes and returns numbers.
#define PLUMB_EXPORT(name) extern "C" [[clang::export_name(#name), gnu::used, gnu::visibility("default")]]
