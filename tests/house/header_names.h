// SPDX-License-Identifier: MIT
// Does a header include what declares the names that it uses? Sources are compiled together and after a precompiled
// header, so that no compiler asks.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "house/arrows.h"

namespace plumb::test {

/// Without comments, preprocessor lines, and what stands within quotes.
std::string codeOf(std::string_view text);

struct DeclaredTypes {
    std::vector<std::string> defined;    ///< at the level of namespaces: struct, class, enum, concept, using NAME =
    std::vector<std::string> announced;  ///< "struct World;"
    std::vector<std::string> within;     ///< in structs, classes and functions; friends; parameters of templates
};

/// Of code, as codeOf gives it.
DeclaredTypes typesIn(std::string_view code);

// Both find one sentence a fault. A name is there where the header itself has what it needs, or a header of these that
// it includes, or one that that includes.

/// Of the standard library's names, those that are most in use: "plumb/a.h uses std::vector without <vector>".
std::vector<std::string> missingStandardHeaders(const std::vector<SourceFile>& headers);
/// Of types that are defined in one of these headers and no other: "plumb/a.h names World, of plumb/world.h".
std::vector<std::string> missingHeaders(const std::vector<SourceFile>& headers);

}  // namespace plumb::test
