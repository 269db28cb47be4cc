// SPDX-License-Identifier: MIT
#include "house/header_names.h"

#include <algorithm>

#include "catch.h"
#include "house/repository.h"

using namespace plumb::test;
using NameFaults = std::vector<std::string>;

namespace {

/// The headers under a folder of the repository, their paths as they are included.
std::vector<SourceFile> headersIn(const std::string& folder, const std::string& root) {
    std::vector<SourceFile> headers;
    for (const auto& file : repositoryFiles())
        if (file.extension() == ".h" && file.generic_string().starts_with(folder))
            headers.push_back({file.generic_string().substr(root.size()), textOf(repository / file)});
    REQUIRE(headers.size() > 10);
    return headers;
}

/// With those of the kit, which it includes.
std::vector<SourceFile> headersOnKit(const std::string& folder) {
    std::vector<SourceFile> headers = headersIn("kit/plumb/", "kit/");
    const std::vector<SourceFile> more = headersIn(folder, "");
    headers.insert(headers.end(), more.begin(), more.end());
    return headers;
}

}  // namespace

TEST_CASE("every header of the kit includes what declares the names that it uses", "[house]") {
    const std::vector<SourceFile> kit = headersIn("kit/plumb/", "kit/");
    CHECK(missingStandardHeaders(kit) == NameFaults{});
    CHECK(missingHeaders(kit) == NameFaults{});
}

TEST_CASE("every header of the comparison and of the games includes what declares the names that it uses", "[house]") {
    for (const std::string folder : {"compare/", "games/"}) {
        const std::vector<SourceFile> headers = headersOnKit(folder);
        CHECK(missingStandardHeaders(headers) == NameFaults{});
        CHECK(missingHeaders(headers) == NameFaults{});
    }
}

TEST_CASE("a planted use of a standard name without its header is caught, and one within reach is none", "[house]") {
    CHECK(missingStandardHeaders({{"plumb/a.h", "#include <string>\nstd::vector<int> f(std::size_t n);\n"}}) ==
          NameFaults{"plumb/a.h uses std::vector without <vector>"});
    CHECK(missingStandardHeaders({{"plumb/a.h", "#include <plumb/b.h>\nstd::vector<int> f();\n"},
                                  {"plumb/b.h", "#include <plumb/c.h>\n"},
                                  {"plumb/c.h", "#include <vector>\n"}}) == NameFaults{});
    CHECK(missingStandardHeaders({{"plumb/a.h", "#include <Eigen/Core>\nstd::uint64_t f();\n"}}).size() == 1);
    CHECK(missingStandardHeaders({{"plumb/a.h",
                                   "// std::vector\n/* std::map\n std::set */ char c = '\"';\n"
                                   "const char* text = \"std::span \\\" std::array\";\nint n = 1'000;\n"
                                   "auto raw = R\"(std::function \" )\";\n"}}) == NameFaults{});
    CHECK(missingStandardHeaders({{"plumb/a.h", "int n = 1'000; std::set<int> f();\n"}}).size() == 1);
}

TEST_CASE("a planted use of another header's type is caught, unless that header is within reach or the type announced",
          "[house]") {
    const SourceFile world{"plumb/world.h", "namespace plumb {\nclass World {\n    struct Part {};\n};\n}\n"};
    const auto with = [&](const std::string& text) { return missingHeaders({world, {"plumb/a.h", text}}); };
    CHECK(with("namespace plumb { void f(const World& world); }") ==
          NameFaults{"plumb/a.h names World, of plumb/world.h"});
    CHECK(with("void f(plumb::World& world);").size() == 1);
    CHECK(with("#include <plumb/world.h>\nvoid f(plumb::World& world);") == NameFaults{});
    CHECK(with("namespace plumb {\nclass World;\nvoid f(World& world);\n}") == NameFaults{});
    CHECK(with("class A {\n    friend class World;\n};") == NameFaults{});
    CHECK(with("template <class World> void f(World& world);") == NameFaults{});
    CHECK(with("struct A {\n    struct World {};\n    World world;\n};") == NameFaults{});
    CHECK(with("enum class Size { World, Room };\nauto f = Size::World;\nint g = a.World + other::World;") ==
          NameFaults{});
    CHECK(with("// World\nconst char* f = \"World\"; struct Part;") == NameFaults{});
    CHECK(missingHeaders({world, {"plumb/a.h", "void f(World&);"}, {"plumb/b.h", "struct World {};"}}) == NameFaults{});
}

TEST_CASE("types are found with where they stand", "[house]") {
    const DeclaredTypes types = typesIn(
        "namespace a::b {\nstruct A final : B<C> { struct In {}; enum { one }; };\nclass D;\nenum class E : int;\n"
        "enum class F : int { x };\nusing G = A;\ntemplate <class H> concept I = true;\ntemplate <> struct J<int> {};\n"
        "struct alignas(16) K {};\nusing L::m;\nvoid f() { struct N {}; }\nnamespace { struct O {}; }\n}\n");
    CHECK(types.defined == NameFaults{"A", "F", "G", "I", "K", "O"});
    CHECK(types.announced == NameFaults{"D", "E"});
    CHECK(types.within == NameFaults{"In", "H", "N"});
}
