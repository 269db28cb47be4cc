// SPDX-License-Identifier: MIT
#include <compare/scene/random/random_scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include <compare/scene/random/bodies.h>
#include <compare/scene/random/machines.h>
#include <compare/scene/random/worlds.h>

namespace plumb::compare {
namespace {

using Fill = std::string (*)(Scene&, Draw&, const Filling&);

constexpr int leastBodies = 20, mostBodies = 3000, steps = 300;

double drawGravity(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    if (kind < 0.45) return 10;
    if (kind < 0.9) return 9.81;
    return draw.uniform(2, 20);
}

/// nullptr stands for blocks at rest, which layAtRest lays.
Fill drawFill(Draw& draw, bool isJointed) {
    const double kind = isJointed ? draw.uniform(0, 0.56) : draw.uniform(0, 1);
    if (kind < 0.28) return fillBin;
    if (kind < 0.42) return fillHills;
    if (kind < 0.56) return fillTiles;
    if (kind < 0.68) return fillDrum;
    if (kind < 0.8) return fillGasBox;
    return nullptr;
}

/// Sorts by size within each run, the largest first. So the items in a row are of similar size, and heaps are still
/// mixed.
void sortInRuns(std::vector<Item>& items, Draw& draw) {
    const int run = draw.integer(20, 200);
    for (auto first = items.begin(); first != items.end();) {
        const auto last = first + std::min<std::ptrdiff_t>(run, items.end() - first);
        std::stable_sort(first, last, [](const Item& a, const Item& b) { return b.half.y() < a.half.y(); });
        first = last;
    }
}

/// Machines first, then the bodies that fall on them. Bridges come first of all, so they are lowest.
std::vector<Item> drawItems(Draw& draw, const Style& style, int count, bool isJointed) {
    std::vector<Item> items, bodies;
    int left = count;
    if (isJointed) {
        const double share = draw.uniform(0.1, 0.5);
        items = drawMachines(draw, std::max(10, static_cast<int>(share * count)), style.density.low);
        for (const Item& machine : items) left -= static_cast<int>(machine.bodies.size());
    }
    for (int i = 0; i < left; ++i) bodies.push_back(drawBody(draw, style));
    sortInRuns(bodies, draw);
    items.insert(items.end(), bodies.begin(), bodies.end());
    return items;
}

std::string questionOf(const Scene& scene, const Style& style, int count, const std::string& place) {
    const int ratio = static_cast<int>(style.radius.high / style.radius.low + 0.5);
    const std::string sizes = ratio < 2 ? "of about one size" : fmt::format("of sizes up to 1 : {}", ratio);
    const std::string joints =
        scene.joints.empty() ? "" : fmt::format(", with machines of {} joints", scene.joints.size());
    return fmt::format("What does a step of {} bodies {} take, {}{}?", count, sizes, place, joints);
}

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

Scene randomScene(std::uint64_t seed) {
    Draw draw(seed);
    Scene scene{.name = fmt::format("random_{}", seed)};
    scene.bodies.resize(1);  // the world, which is built around what is in it
    scene.duration = steps * scene.dt;
    scene.sleeping = draw.chance(0.5);
    scene.gravity = {0, -drawGravity(draw)};
    const int count = static_cast<int>(draw.logUniform(leastBodies, mostBodies));
    const bool isJointed = draw.chance(0.2);
    const Fill fill = drawFill(draw, isJointed);
    const Style style = drawStyle(draw, count);
    std::string place;
    if (fill == nullptr)
        place = layAtRest(scene, draw, style, count);
    else
        place = fill(scene, draw, {drawItems(draw, style, count, isJointed), style});
    scene.question = questionOf(scene, style, count, place);
    return scene;
}

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
