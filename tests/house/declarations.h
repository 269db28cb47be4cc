// SPDX-License-Identifier: MIT
// What do a header's lines declare: which structs with which fields, which functions with which parameters?
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::test {

/// Names in the order in which they stand.
using Names = std::vector<std::string>;

struct Declarations {
    std::map<std::string, Names> structs;  ///< fields, of "WorldDef"
    std::map<std::string, Names> classes;  ///< none; "World"
    /// parameters, of all overloads: of "outline", and of public members of a class, "World.castRay"
    std::map<std::string, Names> functions;
};

/// Adds what a header of the house's style declares at the level of its namespaces, and within structs and classes;
/// a struct within another is "Outer.Inner". No macros; constructors, operators and friends are left out.
void addDeclarations(Declarations& all, std::string_view header);

}  // namespace plumb::test
