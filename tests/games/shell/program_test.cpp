// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>

#include "catch.h"
#include "games/walk_through.h"
#include "house/shell.h"

using namespace plumb::test;

namespace {

namespace fs = std::filesystem;

/// A file in the test's own folder.
std::string fileOf(const std::string& name) {
    return (fs::temp_directory_path() / name).string();
}

std::string written(const std::string& name, const std::string& text) {
    std::ofstream(fileOf(name)) << text;
    return fileOf(name);
}

std::string textOf(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Runs the example game of games/README.md without a display and a sound device. Leaks are checked in the tests, not
/// here: fontconfig would be reported, but it has none.
Ran bounce(const std::string& arguments) {
    return shell("ASAN_OPTIONS=detect_leaks=0 SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy XDG_DATA_HOME=" +
                 quoted(fileOf("data")) + " " + quoted(PLUMB_WALK_THROUGH_PROGRAM) + " " + arguments);
}

nlohmann::json resultOf(const std::string& arguments) {
    const Ran ran = bounce(arguments);
    REQUIRE(ran.ok);
    REQUIRE(std::count(ran.output.begin(), ran.output.end(), '\n') == 1);
    return nlohmann::json::parse(ran.output);
}

/// The text on standard error of a run that ends with status 2.
std::string complaintOf(const std::string& arguments) {
    const Ran ran = bounce(arguments + " 2>&1 >/dev/null; echo $?");
    REQUIRE(ran.output.ends_with("\n2\n"));
    const std::string text = ran.output.substr(0, ran.output.size() - 2);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    return text;
}

const std::string head = "plumb-record 1 bounce\n";
/// A kick every 20 ticks takes the ball over the top.
const std::string kicks = [] {
    std::string text = head + "seed 3\n20 -\n1 confirm\n";
    for (int i = 0; i < 30; ++i) text += "20 -\n1 kick\n";
    return text;
}();

}  // namespace

TEST_CASE("the example of games/README.md has fewer than forty lines, is built, and is won by kicks", "[games]") {
    std::istringstream lines(walkThrough().source);
    int count = 0;
    for (std::string line; std::getline(lines, line);) count += line.empty() ? 0 : 1;
    CHECK(count > 30);
    CHECK(count < 40);

    const auto result = resultOf("--headless --replay " + written("kicks.record", kicks));
    CHECK(result["game"] == "bounce");
    CHECK(result["seed"] == 3);
    CHECK(result["result"] == "won");
    CHECK(result["score"] == 1);
    CHECK(result["ticks"] == 651);
    CHECK(result["hash"].get<std::string>().size() == 16);
}

TEST_CASE("a record of a replay is the same record with the hash at its end, a replay with another hash is refused",
          "[games]") {
    const std::string first = written("first.record", kicks), second = fileOf("second.record");
    const auto result = resultOf("--headless --replay " + first + " --record " + second);
    const std::string text = textOf(second);
    CHECK(text == kicks + "end " + result["hash"].get<std::string>() + "\n");
    CHECK(resultOf("--headless --replay " + second) == result);
    const std::string other = head + "seed 3\n5 -\nend 0123456789abcdef\n";
    CHECK(complaintOf("--headless --replay " + written("other.record", other)).find("0123456789abcdef") !=
          std::string::npos);
}

TEST_CASE("records of 30 and 100 ticks in a window replay without a window to the same hash", "[games]") {
    const std::string record = fileOf("window.record"), kicked = written("kicked.record", kicks);
    REQUIRE(bounce("--player nobody --ticks 30 --record " + record).ok);
    CHECK(textOf(record).find("\n30 -\nend ") != std::string::npos);
    CHECK(resultOf("--headless --replay " + record)["ticks"] == 30);

    const Ran shown = bounce("--replay " + kicked + " --ticks 100 --times --record " + record);
    REQUIRE(shown.ok);
    const auto times = nlohmann::json::parse(shown.output);
    CHECK(times["frames"] > 0);
    CHECK(times["tick_ms"]["median"] > 0);
    CHECK(resultOf("--headless --replay " + record)["ticks"] == 100);
}

TEST_CASE("pictures are written at the ticks and in the size of the arguments", "[games]") {
    const std::string a = fileOf("at-0.png"), b = fileOf("at-30.png");
    fs::remove(a);
    fs::remove(b);
    const std::string pictures = " --screenshot " + b + " --at 30 --screenshot " + a + " --at 0 --size 320x180";
    resultOf("--headless --player nobody --ticks 40" + pictures);
    CHECK(textOf(a).substr(16, 8) == std::string("\0\0\x01\x40\0\0\0\xb4", 8));
    CHECK(textOf(a) != textOf(b));
}

TEST_CASE("bad arguments and records give one line that says what is wrong, and status 2", "[games]") {
    const auto complains = [](const std::string& arguments, const std::string& part) {
        CAPTURE(arguments);
        CHECK_THAT(complaintOf(arguments), containsText(part));
    };
    complains("--headless", "--ticks");
    complains("--headless --player computer", "no computer player");
    complains("--headless --player keyboard --ticks 1", "no keyboard");
    complains("--player robot", "--player");
    complains("--ticks -1 --headless", "--ticks");
    complains("--ticks 1e3 --headless", "--ticks");
    complains("--seed -1 --headless --ticks 1", "--seed");
    complains("--seed x --headless --ticks 1", "--seed");
    complains("--size 0x0 --headless --ticks 1", "--size");
    complains("--size big --headless --ticks 1", "--size: \"big\"");
    complains("--screenshot a.png --headless --ticks 1", "--at");
    complains("--screenshot /no/folder/a.png --at 0 --headless --ticks 1", "/no/folder/a.png");
    complains("--screenshot " + fileOf("late.png") + " --at 9 --headless --ticks 1", "--at: 9");
    complains("--headless --ticks 1 --record /no/folder/a", "cannot write /no/folder/a");
    complains("--replay /no/such/file --headless", "cannot read /no/such/file");
    complains("--replay /dev/null --headless", "/dev/null:1");
    complains("--replay " + written("bad.record", head + "3 fly\n") + " --headless", "bad.record:2: \"3 fly\"");
    complains("--replay " + fileOf("bad.record") + " --player nobody --headless", "--player");
    complains("--replay " + fileOf("bad.record") + " --seed 4 --headless", "--seed");
    complains("--nonsense", "--nonsense");
    complains("more", "more");
}

TEST_CASE("--help lists the options and ends with status 0", "[games]") {
    const Ran help = bounce("--help");
    CHECK(help.ok);
    for (const char* option : {"--seed", "--player", "--record", "--replay", "--headless", "--ticks", "--screenshot"})
        CHECK_THAT(help.output, containsText(option));
}
