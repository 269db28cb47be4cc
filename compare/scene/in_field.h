// SPDX-License-Identifier: MIT
// Of which field of a file is a message?
#pragma once
#include <stdexcept>
#include <string>

namespace plumb::compare {

/// The message of what act refuses begins with the field. mark: what stands between both, "." for a field of an object.
template <class Act>
auto inField(const std::string& field, const Act& act, const char* mark = ": ") {
    try {
        return act();
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(field + mark + error.what());
    }
}

}  // namespace plumb::compare
