// SPDX-License-Identifier: MIT
#include <compare/scene/bench.h>

#include <algorithm>
#include <iterator>

#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr int sizes[] = {1000, 2000, 4000, 8000, 16000, 32000, 64000};

void addSizes(std::vector<BenchScene>& list, const std::string& family, Scene (*scene)(int)) {
    for (const int n : sizes) {
        list.push_back({family + "_" + std::to_string(n), "scaling", family, [=] { return scene(n); }});
    }
}

std::vector<BenchScene> all() {
    std::vector<BenchScene> list{
        {"large_pyramid", "six", "", largePyramid},
        {"many_pyramids", "six", "", manyPyramids},
        {"joint_grid", "six", "", jointGrid},
        {"smash", "six", "", smash},
        {"tumbler", "six", "", tumblerOf2025},
        {"spinner", "six", "", spinner},
        {"small_20", "", "small", small20},
        {"small_50", "", "small", small50},
        {"small_200", "", "small", small200},
        {"junkyard", "", "", junkyard},
        {"compounds", "", "", compounds},
        {"washer", "", "", washer},
        {"rain", "", "", rain},
        {"dolls_100", "", "", dolls100},
        {"dolls_8", "", "", [] { return dolls(8); }},
        {"dolls_9", "", "", [] { return dolls(9); }},
        {"rope_60", "", "", rope60},
        {"bridge_20", "jointed", "", bridge20},
        {"truss_32", "jointed", "", truss32},
        {"net_20", "jointed", "", [] { return net(20); }},
        {"net_40", "jointed", "", [] { return net(40); }},
        {"cloth_20", "jointed", "", cloth20},
        {"grid_movers", "", "", gridMovers},
        {"platform_movers", "", "", platformMovers},
    };
    addSizes(list, "pile", pile);
    addSizes(list, "pyramids", pyramids);
    for (const int n : {200, 2000, 5000})
        list.push_back({"pit_" + std::to_string(n), "crowds", "pit", [=] { return pit(n); }});
    list.push_back({"gas_2000", "crowds", "", [] { return gas(2000); }});
    return list;
}

}  // namespace

const std::vector<BenchScene>& benchScenes() {
    static const std::vector<BenchScene> list = all();
    return list;
}

std::vector<BenchScene> findBenchScenes(const std::string& name) {
    const std::vector<BenchScene>& list = benchScenes();
    const auto isIn = [&](const BenchScene& s) { return s.name == name || (!s.group.empty() && s.group == name); };
    std::vector<BenchScene> found;
    std::ranges::copy_if(list, std::back_inserter(found), isIn);
    return found;
}

}  // namespace plumb::compare
