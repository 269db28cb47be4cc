// SPDX-License-Identifier: MIT
#include <compare/scene/random/seed_range.h>

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <string_view>

namespace plumb::compare {
namespace {

constexpr std::string_view prefix = "random:", dots = "..";
constexpr std::uint64_t mostSeeds = 10000;

std::uint64_t seedFrom(std::string_view text, const std::string& name) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seed);
    if (error != std::errc{} || rest != end)
        throw std::invalid_argument(fmt::format(
            "{}: \"{}\" is not a whole number of 0 or more, wanted random:SEED or random:A..B", name, text));
    return seed;
}

}  // namespace

std::optional<SeedRange> seedRangeOf(const std::string& name) {
    if (!name.starts_with(prefix)) return {};
    const std::string_view text = std::string_view(name).substr(prefix.size());
    const std::size_t middle = text.find(dots);
    const std::uint64_t first = seedFrom(text.substr(0, middle), name);
    if (middle == std::string_view::npos) return SeedRange{first, first};
    const std::uint64_t last = seedFrom(text.substr(middle + dots.size()), name);
    if (last < first)
        throw std::invalid_argument(
            fmt::format("{}: {} is less than {}, wanted random:A..B with the smaller first", name, last, first));
    if (last - first >= mostSeeds)
        throw std::invalid_argument(fmt::format("{}: wanted at most {} scenes", name, mostSeeds));
    return SeedRange{first, last};
}

}  // namespace plumb::compare
