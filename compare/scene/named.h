// SPDX-License-Identifier: MIT
// Which known name was probably meant, and what does the message say of an unknown one?
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <plumb/math/check.h>

namespace plumb::compare {

/// The known name that is reached from name with the fewest insertions, deletions and replacements of letters. If
/// several are equally near, the first; empty if no name is known.
std::string nearest(std::string_view name, std::span<const std::string> known);

/// "a, b, c", with "..." for all names after the twelfth.
std::string listText(std::span<const std::string> known);

inline std::string at(const std::string& list, std::size_t index) {
    return list + "[" + std::to_string(index) + "]";
}

inline std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

/// what: the kind of thing, such as "a body" or "an engine".
inline void requireKnown(const std::string& name, std::span<const std::string> known, const std::string& field,
                         const std::string& what) {
    if (std::ranges::find(known, name) != known.end()) return;
    if (name.empty() && !known.empty())
        refuse(field, "is not given, wanted the name of " + what + "; known are " + listText(known));
    const std::string hint =
        known.empty() ? "there is none" : "the nearest is " + nearest(name, known) + "; known are " + listText(known);
    refuse(field, quoted(name) + " is not the name of " + what + ", " + hint);
}

template <class Named>
std::vector<std::string> namesOf(const std::vector<Named>& things) {
    std::vector<std::string> names;
    for (const Named& thing : things) names.push_back(thing.name);
    return names;
}

}  // namespace plumb::compare
