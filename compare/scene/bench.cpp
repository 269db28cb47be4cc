// SPDX-License-Identifier: MIT
#include <compare/scene/bench.h>

#include <algorithm>
#include <iterator>

#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr std::ptrdiff_t six = 6;  // scenes at the head of the list
constexpr int sizes[] = {1000, 2000, 4000, 8000, 16000, 32000, 64000};

/// Measured: the first step takes 0.2 s, the twelfth 8 s.
const LeftOut noPlaceForBox2d24{"box2d-2.4",
                                "a step takes seconds: Box2D 2.4 enlarges boxes by four times a step's motion, and the "
                                "paddle's tip makes 1.7 m a step"};

/// Measured: 0.2 s a step at 16,000 bodies, 2.7 s at 64,000.
const LeftOut tooLongForBox2d24{"box2d-2.4", "a step takes seconds"};

void addSizes(std::vector<BenchScene>& list, const std::string& family, Scene (*scene)(int)) {
    for (const int n : sizes) {
        const auto leftOut = n > 16000 ? std::optional(tooLongForBox2d24) : std::nullopt;
        list.push_back({family + "_" + std::to_string(n), family, [=] { return scene(n); }, leftOut});
    }
}

std::vector<BenchScene> all() {
    std::vector<BenchScene> list{
        {"large_pyramid", "", largePyramid},     {"many_pyramids", "", manyPyramids},
        {"joint_grid", "", jointGrid},           {"smash", "", smash},
        {"tumbler", "", tumblerOf2025},          {"spinner", "", spinner, noPlaceForBox2d24},
        {"small_50", "small", small50},          {"grid_movers", "", gridMovers},
        {"platform_movers", "", platformMovers},
    };
    list.push_back({"small_20", "small", small20, {}});
    list.push_back({"small_200", "small", small200, {}});
    list.push_back({"junkyard", "", junkyard, {}});
    list.push_back({"compounds", "", compounds, {}});
    list.push_back({"washer", "", washer, {}});
    list.push_back({"rain", "", rain, {}});
    list.push_back({"dolls_100", "dolls", dolls100, {}});
    for (const int n : {8, 9})
        list.push_back({"dolls_" + std::to_string(n), "dolls", [=] { return dolls(n); }, {}});
    list.push_back({"rope_60", "", rope60, {}});
    list.push_back({"bridge_20", "", bridge20, {}});
    addSizes(list, "pile", pile);
    addSizes(list, "pyramids", pyramids);
    for (const int n : {200, 2000, 5000})
        list.push_back({"pit_" + std::to_string(n), "pit", [=] { return pit(n); }, {}});
    list.push_back({"gas_2000", "gas", [] { return gas(2000); }, {}});
    return list;
}

}  // namespace

const std::vector<BenchScene>& benchScenes() {
    static const std::vector<BenchScene> list = all();
    return list;
}

std::vector<BenchScene> findBenchScenes(const std::string& name) {
    const std::vector<BenchScene>& list = benchScenes();
    if (name == "six") return {list.begin(), list.begin() + six};
    const auto isIn = [&](const BenchScene& s) {
        if (name == "scaling") return s.family == "pile" || s.family == "pyramids";
        if (name == "crowds") return s.family == "pit" || s.family == "gas";
        return s.name == name;
    };
    std::vector<BenchScene> found;
    std::ranges::copy_if(list, std::back_inserter(found), isIn);
    return found;
}

}  // namespace plumb::compare
