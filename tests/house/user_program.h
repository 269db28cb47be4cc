// SPDX-License-Identifier: MIT
// What does a compiler say of a program that includes the kit, and what does the program print?
#pragma once
#include <string>

#include "house/shell.h"

namespace plumb::test {

/// Compiled only, as the compiler's options say: what it prints, errors included.
Ran compiled(const std::string& compiler, const std::string& options, const std::string& program);

/// Compiled, linked with the kit of this build, and run: what it prints. A test fails where it cannot be built.
Ran builtAndRun(const std::string& compiler, const std::string& options, const std::string& program);

}  // namespace plumb::test
