// SPDX-License-Identifier: MIT
// At which place in a list is a name?
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace plumb::compare {

/// Looks up names without going through the list each time. The list must outlive the index and must not change.
class NameIndex {
public:
    template <class Named>
    explicit NameIndex(const std::vector<Named>& things) {
        places_.reserve(things.size());
        for (std::size_t i = 0; i < things.size(); ++i) places_.try_emplace(things[i].name, i);
    }
    /// The first place of the name; empty when there is none.
    std::optional<std::size_t> find(std::string_view name) const {
        const auto place = places_.find(name);
        if (place == places_.end()) return {};
        return place->second;
    }

private:
    std::unordered_map<std::string_view, std::size_t> places_;
};

}  // namespace plumb::compare
