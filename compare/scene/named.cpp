// SPDX-License-Identifier: MIT
#include <compare/scene/named.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace plumb::compare {
namespace {

/// Levenshtein's distance, a row of its table at a time. Source: Wagner, Fischer, "The string-to-string correction
/// problem", JACM 1974.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest(std::string_view name, std::span<const std::string> known) {
    const auto best = std::ranges::min_element(
        known, {}, [&](const std::string& candidate) { return editDistance(name, candidate); });
    return best == known.end() ? std::string() : *best;
}

std::string listText(std::span<const std::string> known) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(known.size(), most); ++i) text += (i == 0 ? "" : ", ") + known[i];
    return known.size() > most ? text + ", ..." : text;
}

}  // namespace plumb::compare
