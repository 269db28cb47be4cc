// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <plumb/dynamics/describe.h>
#include <plumb/shapes/tile_text.h>

#include "catch.h"
#include "house/repository.h"
#include "house/user_program.h"

using namespace plumb::test;

namespace {

const std::string start =
    "#include <plumb/plumb.h>\n#include <iostream>\nusing namespace plumb;\nint main() {\n"
    "    World world;\n"
    "    const BodyId a = world.add({.position = {3, 4}, .shapes = {circle(0.5)}});\n"
    "    const BodyId b = world.add({.shapes = {circle(0.5)}});\n";

std::string programOf(const std::string& lines) {
    return start + lines + "\n}\n";
}

/// Twenty lines that somebody writes who has not read about expressions. Each is used after what it was made from is
/// gone.
const std::string twentyLines = R"(
    auto apart = world.body(a).position() - world.body(b).position();
    auto sum = world.body(a).position() + world.body(b).position();
    auto middle = (world.body(a).position() + world.body(b).position()) / 2;
    auto back = -world.body(a).position();
    auto twice = 2 * world.body(a).position();
    auto half = world.body(a).position() / 2.0;
    auto direction = (world.body(a).position() - world.body(b).position()).normalized();
    auto aside = perp(world.body(a).position() - world.body(b).position());
    auto mixed = world.body(a).position() * 0.25 + world.body(b).position() * 0.75;
    auto next = world.body(a).position() + world.body(a).velocity() * (1.0 / 60);
    auto least = world.body(a).position().cwiseMin(world.body(b).position() + Vec2(1, 9));
    auto most = world.body(a).position().cwiseMax(world.body(b).position() + Vec2(1, 9));
    auto scaled = world.body(a).position().cwiseProduct(Vec2(2, 3));
    auto turned = Rot::fromAngle(0) * (world.body(a).position() - Vec2(1, 1));
    auto placed = world.body(a).pose() * Vec2(1, 0);
    auto local = world.body(a).pose().inverse() * (world.body(a).position() + Vec2(1, 0));
    auto away = direction * world.body(a).mass() / world.body(a).mass();
    auto reached = world.body(a).centerOfMass() + 0.5 * (world.body(b).position() - world.body(a).position());
    auto far = std::abs(apart.x()) > 2 ? apart * 2 : sum;
    auto center = (Vec2(1, 1) + Vec2(3, 3)) * 0.5;
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60);
    for (const auto& v : {apart, sum, middle, back, twice, half, direction, aside, mixed, next, least, most, scaled, turned,
                          placed, local, away, reached, far, center})
        std::cout << v << "; ";
)";
const std::string theirNumbers =
    "3 4; 3 4; 1.5 2; -3 -4; 6 8; 1.5 2; 0.6 0.8; -4 3; 0.75 1; 3 4; 1 4; 3 9; 6 12; 2 3; 4 4; 1 0; 0.6 0.8; 1.5 2; "
    "6 8; 2 2; ";

/// Lines that are wrong, and words of the one sentence that says what to write.
const std::vector<std::pair<std::string, std::string>> wrongLines{
    {"world.add({.shapes = {Circle{0.5}}});", "a Circle is a shape's outline: write plumb::circle(radius)"},
    {"world.add({.shapes = {Polygon{{{0, 0}, {1, 0}, {0, 1}}}}});",
     "a Polygon is a shape's outline: write plumb::polygon(vertices)"},
    {"world.join({.bodyA = a, .bodyB = b, .anchor = {1, 0}});",
     "name it: join(RevoluteJointDef{.bodyA = a, .bodyB = b})"},
    {"FixedClock clock(1.0 / 60);", "name the interval: write FixedClock({.interval = 1.0 / 60})"},
    {"World other(Vec2(0, -9.81));", "name the gravity: write World({.gravity = {0, -9.81}})"},
    {"world.add(circle(0.5));", "a shape belongs to a body: write add({.shapes = {circle(0.5)}})"},
    {"world.addField(Drag{.linear = 1});", "name the law: write addField({.law = Drag{...}})"},
    {"world.add({.shapes = {box(1, 0.5)}});", "both in braces: box({halfWidth, halfHeight})"},
    {"world.add(RevoluteJointDef{.bodyA = a, .bodyB = b});", "a joint joins bodies: write join(RevoluteJointDef{...})"},
    {"world.body(a).position() = {1, 0};", "it would be lost: call setPose, setVelocity, ... of the body"},
    {"world.body(a).position().x() = 3;", "assign"},
    {"world.add({.friction = 0.3});", "no match? add(BodyDef{...}) makes the compiler name the member"},
};

/// A row of the page's table: "| `Limit` | `lower upper` |".
template <class Def>
std::string rowOf() {
    std::string names;
    const Def def{};
    plumb::describe(def, [&](const plumb::Member& member, const auto&) {
        names += std::string(names.empty() ? "" : " ") + member.name;
    });
    return std::string("| `") + plumb::definitionName<Def>.type + "` | `" + names + "` |";
}

}  // namespace

TEST_CASE("the distance of two positions under auto is 5 at every optimisation, with GCC and with Clang",
          "[house][build]") {
    const std::string program = programOf(
        "    for (int i = 0; i < 3; ++i) {\n"
        "        auto d = world.body(a).position() - world.body(b).position();\n"
        "        auto e = world.body(a).velocity() * 2 + world.body(b).velocity();\n"
        "        std::cout << d.norm() << ' ' << e.norm() << ' ';\n    }");
    for (const std::string compiler : {"g++", "clang++"})
        for (const std::string level : {"-O0", "-O1", "-O2", "-O3"}) {
            CAPTURE(compiler, level);
            CHECK(builtAndRun(compiler, level, program).output == "5 0 5 0 5 0 ");
        }
}

TEST_CASE("twenty natural lines with auto give their numbers, and touch no memory that is gone", "[house][build]") {
    for (const std::string compiler : {"g++", "clang++"}) {
        CAPTURE(compiler);
        const Ran ran =
            builtAndRun(compiler, "-O2 -fsanitize=address -fsanitize-address-use-after-scope", programOf(twentyLines));
        CHECK(ran.ok);
        CHECK(ran.output == theirNumbers);
    }
}

TEST_CASE("a wrong line does not compile, and a sentence says what to write", "[house][build]") {
    for (const std::string compiler : {"g++", "clang++"}) {
        for (const auto& [line, sentence] : wrongLines) {
            CAPTURE(compiler, line);
            const Ran ran = compiled(compiler, "-fsyntax-only -Werror", programOf(line));
            CHECK_FALSE(ran.ok);
            CHECK_THAT(ran.output, containsText(sentence));
            CHECK(std::count(ran.output.begin(), ran.output.end(), '\n') < 40);
        }
        CHECK(
            compiled(compiler, "-fsyntax-only", programOf("world.join(RevoluteJointDef{.bodyA = a, .bodyB = b});")).ok);
    }
}

TEST_CASE("the kit's page has the members of definitions in the order in which they are given", "[house]") {
    const std::string page = textOf(repository / "kit/README.md");
    for (const std::string& row :
         {rowOf<plumb::BodyDef>(), rowOf<plumb::ShapeDef>(), rowOf<plumb::Material>(), rowOf<plumb::RevoluteJointDef>(),
          rowOf<plumb::PrismaticJointDef>(), rowOf<plumb::DistanceJointDef>(), rowOf<plumb::WheelJointDef>(),
          rowOf<plumb::WorldDef>()})
        CHECK_THAT(page, containsText(row));
}

TEST_CASE("the page on shapes lists every character that stands for a tile", "[house]") {
    const std::string page = textOf(repository / "kit/plumb/shapes/README.md");
    for (const auto& [sign, tile] : plumb::standardLegend()) {
        CAPTURE(sign);
        CHECK_THAT(page, containsText(sign == ' ' ? std::string("or a space") : std::string("`") + sign + "`"));
    }
}

// The C++ library's headers that the kit's own have to include make most of these.
TEST_CASE("the first include of a program is at most 75,000 lines", "[house]") {
    const Ran ran = compiled(PLUMB_COMPILER, "-E", "#include <plumb/plumb.h>\n");
    REQUIRE(ran.ok);
    const auto lines = std::count(ran.output.begin(), ran.output.end(), '\n');
    CHECK(lines > 10'000);
    CHECK(lines <= 75'000);
}
