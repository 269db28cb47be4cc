// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/scenes.h>

#include <set>

#include <compare/scene/builtin.h>
#include "catch.h"

namespace plumb::compare {

TEST_CASE("each built-in scene has a title that no other has, and a group", "[compare][scene]") {
    std::set<std::string> titles;
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        CHECK_FALSE(scene.title.empty());
        CHECK_FALSE(scene.group.empty());
        CHECK(titles.insert(scene.title).second);
    }
}

TEST_CASE("a scene without a title is called by its name", "[compare][scene]") {
    Scene scene;
    scene.name = "two_balls";
    CHECK(titleOf(scene) == "Two balls");
    giveTitle(scene);
    CHECK(scene.title.empty());
    scene.title = "A pair";
    CHECK(titleOf(scene) == "A pair");
}

}  // namespace plumb::compare
