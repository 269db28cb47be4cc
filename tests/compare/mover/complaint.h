// SPDX-License-Identifier: MIT
// What is said of a scene's text that is refused?
#pragma once
#include <stdexcept>
#include <string>

#include <compare/scene/json.h>

namespace plumb::compare {

/// "" if it is taken.
inline std::string complaint(const std::string& text) {
    try {
        (void)fromJson(text, "f.json");
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace plumb::compare
