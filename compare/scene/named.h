// SPDX-License-Identifier: MIT
// What does the message say if a scene uses an unknown name?
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <compare/scene/nearest.h>
#include <plumb/math/check.h>

namespace plumb::compare {

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
