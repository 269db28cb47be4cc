// SPDX-License-Identifier: MIT
#include <compare/engine/own_track.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <plumb/math/random.h>

#include "catch.h"

namespace plumb::compare {
namespace {

OwnTrack trackOf(const std::string& csv) {
    return ownTrackFrom(csv, "f.csv");
}

std::string trackComplaint(const std::string& csv) {
    try {
        trackOf(csv);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no complaint";
}

/// (0.5 s, 1 m, 2 m) and (1 s, 3 m, -4.5 m).
bool isTwoRows(const OwnTrack& track) {
    return track.times == std::vector<double>{0.5, 1} && track.places == std::vector<Vec2>{{1, 2}, {3, -4.5}};
}

/// Letters of which tables are made, more often than others.
std::string randomTable(Random& random) {
    static const std::string usual = "0123456789012345678901234567890123456789.,;\t \n\n\n\r\"#-+etxy[]sm";
    std::string text = random.integer(0, 1) == 0 ? "t,x,y\n" : "";
    for (int left = random.integer(0, 60); left > 0; --left)
        text += random.integer(0, 19) == 0
                    ? static_cast<char>(random.integer(0, 255))
                    : usual[static_cast<std::size_t>(random.integer(0, static_cast<int>(usual.size()) - 1))];
    return text;
}

/// A table that is right but for one letter in ten.
std::string nearlyRightTable(Random& random) {
    std::string text = "t;x;y;body\n";
    for (int row = 0; row < 4; ++row) text += fmt::format("{};{},5;{};a\n", row, row, random.integer(-9, 9));
    if (random.integer(0, 3) > 0)
        text[static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1))] =
            static_cast<char>(random.integer(0, 255));
    return text;
}

}  // namespace

TEST_CASE("a table of two rows is read with each head and each separator", "[compare][engine]") {
    for (const std::string csv :
         {"t,x,y\n0.5,1,2\n1,3,-4.5\n", "0.5,1,2\n1,3,-4.5", "y (m), x/m, Time [s]\n2, 1, 0.5\n-4.5, 3, 1\n",
          "t [s];x [m];y [m]\n0.5;1;2\n1;3;-4.5\n", "T\tX\tY\n0.5\t1\t2\n1\t3\t-4.5\n",
          "t [s]   x [m] y [m]\n  0.5  1 2  \n  1  3  -4.5\n", "\xEF\xBB\xBFt,x,y\r\n0.5,1,2\r\n1,3,-4.5\r\n",
          "# filmed\n\nt,x,y\n0.5,1,2\n # late\n,,\n1,3,-4.5\n\n", "n,t,x,y,vx\nA,0.5,1,2,7\nB,1,3,-4.5,8\n",
          "\"t [s]\",\"x [m]\",\"y [m]\"\n\"0.5\",+1,2e0\n1,3,-4.5\n", "x\ty\tt\n1\t2\t0.5\n3\t-4.5\t1\n"}) {
        INFO(csv);
        const OwnTrack track = trackOf(csv);
        CHECK(isTwoRows(track));
        CHECK(track.body.empty());
        CHECK(track.file == "f.csv");
    }
}

TEST_CASE("a German spreadsheet's table has decimal commas between semicolons or tabs", "[compare][engine]") {
    CHECK(isTwoRows(trackOf("\xEF\xBB\xBFt [s];x [m];y [m]\r\n0,5;1,0;2\r\n1;3;-4,5\r\n")));
    CHECK(isTwoRows(trackOf("0,5\t1\t2,000\n1,0\t3\t-4,5\n")));
}

TEST_CASE("a column body names the body, a name in quotes may have a comma", "[compare][engine]") {
    CHECK(trackOf("t,body,x,y\n0,ball,1,2\n1,ball,1,2\n").body == "ball");
    CHECK(trackOf("t,body,x,y\n0,\"a, \"\"b\"\"\",1,2\n1,\"a, \"\"b\"\"\",1,2\n").body == "a, \"b\"");
}

TEST_CASE("each fault of a table is refused on one line that names file, line and column",
          "[compare][engine][errors]") {
    const std::string head = "t,x,y\n0,0,0\n";
    CHECK(trackComplaint("") == "f.csv: has 0 rows, wanted at least 2");
    CHECK(trackComplaint(head) == "f.csv: has 1 row, wanted at least 2");
    CHECK(trackComplaint(head + "1,abc,0\n") == "f.csv:3: x: \"abc\" is not a number");
    CHECK(trackComplaint(head + "1,2,1 000\n") == "f.csv:3: y: \"1 000\" is not a number");
    CHECK(trackComplaint("t;x;y\n0;1.000,5;2\n") == "f.csv:2: x: \"1.000,5\" is not a number");
    CHECK(trackComplaint(head + "# here\n\n1,2\n") == "f.csv:5: y: is not given, wanted a number");
    CHECK(trackComplaint(head + "1,,2\n") == "f.csv:3: x: is not given, wanted a number");
    CHECK(trackComplaint(head + "nan,1,2\n") == "f.csv:3: t: nan is not finite");
    CHECK(trackComplaint(head + "1,-inf,2\n") == "f.csv:3: x: -inf is not finite");
    CHECK(trackComplaint(head + "1,2,1e999\n") == "f.csv:3: y: \"1e999\" is beyond double precision");
    CHECK(trackComplaint(head + "0.5,1,2\n0.5,1,2\n") == "f.csv:4: t: 0.5 is not after 0.5 of the row before");
    CHECK(trackComplaint(head + "-1,1,2\n") == "f.csv:3: t: -1 is not after 0 of the row before");
    CHECK(trackComplaint("time,x,height\n0,0,0\n") == "f.csv:1: there is no column y; the columns are time, x, height");
    CHECK(trackComplaint("# a\nt,t,x,y\n") == "f.csv:2: t: given twice, wanted once");
    CHECK(trackComplaint("t [ms],x,y\n") == "f.csv:1: t: is in \"ms\", wanted s");
    CHECK(trackComplaint("t,x,y (cm)\n") == "f.csv:1: y: is in \"cm\", wanted m");
    CHECK(trackComplaint("t,x,y,body\n0,0,0,a\n1,0,0,b\n") ==
          "f.csv:3: body: \"b\" is not \"a\" of the rows before, wanted one body");
    CHECK(trackComplaint(head + "1,\a" + std::string(50, 'x') + ",2\n") ==
          "f.csv:3: x: \" " + std::string(39, 'x') + "...\" is not a number");
}

TEST_CASE("5000 random texts are each a track with finite places and rising times, or are refused on one line",
          "[compare][engine][errors]") {
    Random random(7);
    int tracks = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::string csv = i % 2 == 0 ? randomTable(random) : nearlyRightTable(random);
        try {
            const OwnTrack track = trackOf(csv);
            ++tracks;
            REQUIRE(track.times.size() >= 2);
            REQUIRE(track.places.size() == track.times.size());
            for (std::size_t row = 0; row < track.times.size(); ++row) {
                REQUIRE((std::isfinite(track.times[row]) && track.places[row].allFinite()));
                if (row > 0) REQUIRE(track.times[row] > track.times[row - 1]);
            }
        } catch (const std::invalid_argument& error) {
            const std::string message = error.what();
            INFO(message);
            REQUIRE(message.starts_with("f.csv:"));
            REQUIRE(message.find_first_of("\r\n") == std::string::npos);
        }
    }
    CHECK(tracks > 500);  // a quarter of half of them is right as it is
    CHECK(tracks < 4500);
}

}  // namespace plumb::compare
