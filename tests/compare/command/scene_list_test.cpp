// SPDX-License-Identifier: MIT
#include <compare/command/scene_list.h>

#include <algorithm>
#include <set>
#include <string>

#include <compare/lab/builtin.h>
#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/command/called.h"

namespace plumb::compare {
namespace {

/// The lines of the list that are neither a heading nor indented.
std::set<std::string> listedNames(const std::string& text) {
    std::set<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != ' ' && line[0] != '=') names.insert(line);
    return names;
}

}  // namespace

TEST_CASE("list shows each group of scenes once, under its heading, and the labs under theirs", "[compare][command]") {
    const std::string out = call({"list"}).out;
    std::set<std::string> groups{"Labs"};
    for (const Scene& scene : builtinScenes()) groups.insert(scene.group);
    for (const std::string& group : groups) {
        CAPTURE(group);
        const std::size_t heading = out.find("== " + group + " ==\n");
        REQUIRE(heading != std::string::npos);
        CHECK(out.find("== " + group + " ==\n", heading + 1) == std::string::npos);
        const std::size_t end = std::min(out.find("\n== ", heading), out.size());
        for (const Scene& scene : builtinScenes()) {
            const std::size_t at = out.find("\n" + scene.name + "\n");
            CHECK((at > heading && at < end) == (scene.group == group));
        }
    }
    CHECK(out.starts_with("== "));
    CHECK(listedNames(out).size() == builtinScenes().size() + builtinLabs().size());
}

TEST_CASE("list with a word shows what has it in its name, group or question, in any case", "[compare][command]") {
    const std::set<std::string> dolls = listedNames(call({"list", "RagDoll"}).out);
    CHECK(dolls.contains("ragdoll"));
    CHECK_FALSE(dolls.contains("free_fall"));
    const std::set<std::string> jointed = listedNames(call({"list", "joints and"}).out);
    for (const Scene& scene : builtinScenes())
        if (scene.group == "Joints and machines") CHECK(jointed.contains(scene.name));
    const Scene asked = builtinScenes().front();
    CHECK(listedNames(call({"list", asked.question}).out) == std::set<std::string>{asked.name});
    CHECK(listedNames(call({"list", "integrators"}).out).contains("integrators"));
    std::set<std::string> labs;
    for (const Lab& lab : builtinLabs()) labs.insert(lab.name);
    CHECK(std::ranges::includes(listedNames(call({"list", "labs"}).out), labs));
}

TEST_CASE("list refuses a word that nothing contains, in one line that says what to do", "[compare][command]") {
    const Called called = call({"list", "zeppelin"});
    CHECK(called.status == 2);
    CHECK(called.out.empty());
    CHECK(called.err ==
          "plumb-compare: list: no scene or lab has \"zeppelin\" in its name, group or question; list without a word "
          "shows all\n");
}

}  // namespace plumb::compare
