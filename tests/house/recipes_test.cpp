// SPDX-License-Identifier: MIT
#include "house/recipes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <compare/lab/builtin.h>
#include <compare/scene/builtin.h>

#include "catch.h"
#include "games/walk_through.h"
#include "house/arrows.h"
#include "house/blocks.h"
#include "house/cmake_project.h"
#include "house/examples.h"
#include "house/repository.h"
#include "house/shell.h"
#include "house/ten_lines.h"

using namespace plumb::test;
namespace fs = std::filesystem;

namespace {

using Commands = std::vector<std::string>;

struct Recipe {
    std::string page, command;
};

/// Of all pages, the README first, then in the order of their paths. What an earlier page runs already is left out.
std::vector<Recipe> allRecipes() {
    std::vector<fs::path> pages = repositoryFiles();
    std::erase_if(pages, [](const fs::path& file) { return file.extension() != ".md"; });
    std::stable_partition(pages.begin(), pages.end(), [](const fs::path& page) { return page == "README.md"; });
    std::vector<Recipe> recipes;
    std::set<std::string> seen;
    for (const fs::path& page : pages)
        for (const std::string& command : recipesOn(textOf(repository / page)))
            if (seen.insert(command).second) recipes.push_back({page.generic_string(), command});
    return recipes;
}

/// The repository as somebody has it who has just cloned it.
struct Checkout {
    fs::path folder = houseFolder("checkout");
    fs::path prefix = folder / "build/prefix";          ///< where the recipe installs the kit
    fs::path saves = houseFolder("recipes") / "saves";  ///< not among the best scores of who runs this

    Checkout() {
        fs::remove_all(folder);
        fs::remove_all(houseFolder("recipes"));
        fs::create_directories(saves);
        for (const fs::path& file : repositoryFiles()) {
            fs::create_directories((folder / file).parent_path());
            fs::copy_file(repository / file, folder / file);
        }
    }

    Ran run(const std::string& command, const std::string& before = "") const {
        return shell("cd " + quoted(folder.string()) + " && XDG_DATA_HOME=" + quoted(saves.string()) + " " + before +
                     " bash -e -c " + quoted(command) + " </dev/null 2>&1");
    }
};

/// The game whose window a command opens; empty where it opens none.
std::string windowOf(const std::string& command) {
    static const std::regex play(R"(^(?:\./)?games/run ([a-z]\w*)(.*)$)");
    static const std::regex noWindow(R"(--headless|--help|--screenshot|(^| )-h\b)");
    std::smatch match;
    if (!std::regex_match(command, match, play) || match[1] == "pictures") return "";
    return std::regex_search(match[2].first, match[2].second, noWindow) ? "" : match[1].str();
}

/// Well, if it still ran after some seconds: timeout stops it then, and ends with 124.
Ran playIn(const Checkout& checkout, const std::string& command) {
    return checkout.run("status=0; timeout 5 bash -e -c " + quoted(command) + " || status=$?; (( status == 124 ))",
                        "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy");
}

std::string lastLineOf(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

void requireJson(const std::string& output) {
    INFO(output);
    REQUIRE(lastLineOf(output).starts_with("{\"game\":"));
    REQUIRE(lastLineOf(output).ends_with('}'));
}

/// What the page on games says in words: a folder, a file, a line in a list.
void addNewGame(const Checkout& checkout) {
    const WalkThrough page = walkThrough();
    const std::string name = page.line.substr(0, page.line.find(':'));
    // Whoever followed the page here has it already.
    if (!fs::create_directories(checkout.folder / "games" / name)) return;
    std::ofstream(checkout.folder / "games" / name / (name + ".cpp")) << page.source;
    std::ofstream(checkout.folder / "games/list.txt", std::ios::app) << page.line << '\n';
}

/// Without a command every scene and lab is run, and the report written where it is called.
void requireAllPass(const Checkout& checkout, const std::string& output) {
    for (const plumb::compare::Scene& scene : plumb::compare::builtinScenes())
        REQUIRE_THAT(output, containsText("PASS  " + scene.name));
    for (const plumb::compare::Lab& lab : plumb::compare::builtinLabs())
        REQUIRE_THAT(output, containsText("PASS  " + lab.name + "\n"));
    REQUIRE_THAT(output, containsText("box2d-2.4 2.4."));
    REQUIRE(fs::exists(checkout.folder / "build/report/index.html"));
}

void follow(const Checkout& checkout, const Recipe& recipe) {
    INFO(recipe.page << ": " << recipe.command);
    const std::string& command = recipe.command;
    const std::string window = windowOf(command);
    if (!window.empty()) {  // time counts from when it is built
        const Ran built = checkout.run(".setup/build games release plumb-" + window);
        INFO(built.output);
        REQUIRE(built.ok);
    }
    const Ran ran = window.empty() ? checkout.run(command) : playIn(checkout, command);
    INFO(ran.output);
    REQUIRE(ran.ok);
    if (command.find("games/run") != std::string::npos && command.find("--headless") != std::string::npos)
        requireJson(ran.output);
    if (command == "./compare/run") requireAllPass(checkout, ran.output);
}

/// The block ```cmake of the README that uses an installation.
std::string cmakeLinesOf(const std::string& readme) {
    for (const Block& block : blocksOn(readme))
        if (block.kind == "cmake" && block.text.find("find_package(plumb") != std::string::npos) return block.text;
    FAIL("README.md has no block ```cmake with find_package(plumb ...)");
    return "";
}

/// A project of the README's lines, and nothing else.
void buildTenLinesWith(const fs::path& prefix, const fs::path& folder) {
    const std::string readme = textOf(repository / "README.md");
    REQUIRE_FALSE(examplesOn(readme).empty());
    fs::create_directories(folder);
    std::ofstream(folder / "main.cpp") << examplesOn(readme).front().program;
    std::ofstream(folder / "CMakeLists.txt") << cmakeLinesOf(readme);
    buildProject({.source = folder, .build = folder / "build", .options = {"-DCMAKE_PREFIX_PATH=" + prefix.string()}});
}

/// Installing has once switched off the rest in the folder that the commands build in.
void requireCommandsBuildable(const Checkout& checkout) {
    const Ran help = checkout.run("cmake --build build/release --target help");
    INFO(help.output);
    REQUIRE(help.ok);
    for (const std::string target : {"plumb-compare: ", "plumb-tests: ", "plumb-maze: "})
        CHECK(help.output.find("\n" + target) != std::string::npos);
}

/// All of the kit's headers that users may include, and no others.
void requireOnlyPublicHeaders(const fs::path& installed) {
    std::set<std::string> wanted, found;
    for (const SourceFile& source : sourcesUnder(repository / "kit/plumb", repository / "kit"))
        if (isInstalled(source.path)) wanted.insert(source.path);
    for (const auto& entry : fs::recursive_directory_iterator(installed))
        if (!entry.is_directory()) found.insert(fs::relative(entry.path(), installed).generic_string());
    CHECK(found == wanted);
}

}  // namespace

TEST_CASE("a page's commands are what its sh blocks hold, without comments", "[house]") {
    const std::string page =
        "# A\n\n```\n./not/this\n```\n```sh\n# first\n./compare/run       # all of it\n\n"
        "./tests/run \"[a] # b\" '#c' d#e # f\n```\n- and\n  ```sh\n  cmake --preset kit \\\n    -DA=1   # why\n  ```\n"
        "```bash\nnor this\n```\n";
    CHECK(recipesOn(page) == Commands{"./compare/run", "./tests/run \"[a] # b\" '#c' d#e", "cmake --preset kit -DA=1"});
}

TEST_CASE("a command opens a window if it names a game, and nothing that does without one", "[house]") {
    CHECK(windowOf("./games/run maze") == "maze");
    CHECK(windowOf("games/run artillery --rival friend") == "artillery");
    CHECK(windowOf("./games/run").empty());
    CHECK(windowOf("./games/run pictures").empty());
    CHECK(windowOf("./games/run maze --help").empty());
    CHECK(windowOf("./games/run maze --headless --ticks 60").empty());
    CHECK(windowOf("./compare/run list").empty());
}

TEST_CASE("the folder to copy holds the README's lines", "[house]") {
    const std::string readme = textOf(repository / "README.md");
    CHECK(textOf(repository / "kit/example/CMakeLists.txt") ==
          "# SPDX-License-Identifier: MIT\n" + cmakeLinesOf(readme));
    REQUIRE_FALSE(examplesOn(readme).empty());
    CHECK(textOf(repository / "kit/example/main.cpp") ==
          "// SPDX-License-Identifier: MIT\n" + examplesOn(readme).front().program);
}

TEST_CASE("the pages have a recipe for each thing that the repository is for", "[house]") {
    Commands commands;
    for (const Recipe& recipe : allRecipes()) commands.push_back(recipe.command);
    for (const std::string command : {"./compare/run", "./tests/run", "./games/run", "./games/run maze",
                                      "cmake --install build/kit --prefix build/prefix"}) {
        CAPTURE(command);
        CHECK(std::count(commands.begin(), commands.end(), command) == 1);
    }
}

// Six to eight minutes of one processor: everything but the tests themselves is built once, the kit twice, as the
// recipe for an installation builds it in a folder of its own.
TEST_CASE("every command on a page does what the page says, in a checkout of its own", "[house][build]") {
    const Checkout checkout;
    for (const Recipe& recipe : allRecipes()) {
        if (recipe.command.starts_with("./tests/run")) continue;  // it would come here again
        if (recipe.page == "games/README.md") addNewGame(checkout);
        follow(checkout, recipe);
    }
    // One game more leaves the others as they were.
    follow(checkout, {"after a new game", "./games/run maze --headless --player computer --ticks 60"});
    requireCommandsBuildable(checkout);

    REQUIRE(fs::exists(checkout.prefix));
    requireOnlyPublicHeaders(checkout.prefix / "include");
    const fs::path user = houseFolder("recipes") / "user";
    buildTenLinesWith(checkout.prefix, user);
    requireBallAtRest(user / "build" / "game");
}
