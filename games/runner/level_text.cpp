// SPDX-License-Identifier: MIT
#include <games/runner/level_text.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include <games/runner/legend.h>
#include <games/runner/track.h>

namespace plumb::games::runner {
namespace {

constexpr std::size_t mostColumns = 1000, mostRows = 100;

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.emplace_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    while (!lines.empty() && lines.back().find_first_not_of(' ') == std::string::npos) lines.pop_back();
    return lines;
}

std::string quoted(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    if (code > 32 && code < 127) return std::string("'") + letter + "'";
    return "byte " + std::to_string(code);
}

class Reader {
public:
    Reader(std::string_view text, std::string_view file) : file_(file), lines_(linesOf(text)) {}

    Level read() {
        readHead();
        map_ = {file_, std::span(lines_).subspan(static_cast<std::size_t>(next_)), next_ + 1};
        makeTiles();
        for (int column = 0; column < level_.tiles.columns(); ++column)
            for (int row = level_.tiles.rows() - 1; row >= 0; --row) readCell(row, column);
        level_.platforms = platformsOf(map_);
        requireOne(start_, "no start: one S was wanted");
        requireOne(beacon_, "no beacon: one G was wanted");
        return std::move(level_);
    }

private:
    void requireOne(const std::optional<Vec2>& found, std::string_view complaint) const {
        if (!found) refuse(file_, {map_.firstRow, 1}, complaint);
    }

    void readHead() {
        for (next_ = 0; next_ < static_cast<int>(lines_.size()); ++next_) {
            const std::string& line = lines_[static_cast<std::size_t>(next_)];
            if (line.empty() || line.front() == ';') continue;
            if (line == "map:") {
                ++next_;
                return;
            }
            readEntry(line, next_ + 1);
        }
        refuse(file_, {next_ + 1, 1}, "the text ends: a line \"map:\" and the map were wanted");
    }

    void readEntry(const std::string& line, int row) {
        const std::size_t colon = line.find(':');
        const std::string key = line.substr(0, colon);
        if (colon == std::string::npos || (key != "name" && key != "sky" && key != "par"))
            refuse(file_, {row, 1}, "\"" + key + "\": one of name:, sky:, par: and map: was wanted");
        const std::size_t begin = std::min(line.find_first_not_of(' ', colon + 1), line.size());
        const TextPlace place{row, static_cast<int>(begin) + 1};
        const std::string value = line.substr(begin);
        if (key == "name") level_.name = value;
        if (key == "sky") level_.sky = skyIn(value, place);
        if (key == "par") level_.par = parIn(value, place);
    }

    Sky skyIn(const std::string& value, const TextPlace& place) const {
        if (value == "dawn") return Sky::Dawn;
        if (value == "noon") return Sky::Noon;
        if (value == "night") return Sky::Night;
        refuse(file_, place, "\"" + value + "\": a sky of dawn, noon or night was wanted");
    }

    double parIn(const std::string& value, const TextPlace& place) const {
        int seconds = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seconds);
        if (error != std::errc() || end != value.data() + value.size() || seconds < 1 || seconds > 3600)
            refuse(file_, place, "\"" + value + "\": whole seconds from 1 to 3600 were wanted");
        return seconds;
    }

    void makeTiles() {
        std::size_t columns = 0;
        for (std::size_t row = 0; row < map_.rows.size(); ++row) {
            columns = std::max(columns, map_.rows[row].size());
            if (columns > mostColumns)
                refuse(file_, map_.place(static_cast<int>(row), static_cast<int>(mostColumns)),
                       "a row too long: at most 1000 letters were wanted");
        }
        if (columns == 0) refuse(file_, {map_.firstRow, 1}, "no map: its rows were wanted here");
        if (map_.rows.size() > mostRows)
            refuse(file_, map_.place(static_cast<int>(mostRows), 0), "a row too many: at most 100 were wanted");
        level_.tiles = TileMap({.columns = static_cast<int>(columns), .rows = static_cast<int>(map_.rows.size())});
    }

    void readCell(int row, int column) {
        const char letter = map_.at(row, column);
        const Vec2 center = map_.center(row, column);
        if (letter == startLetter) return keepOnly(start_, level_.start, row, column);
        if (letter == platformLetter || trackLetters.find(letter) != std::string_view::npos) return;
        const Letter* entry = find(letter);
        if (entry == nullptr)
            refuse(file_, map_.place(row, column),
                   quoted(letter) + " stands for nothing; wanted was one of " + allLetters());
        if (!entry->thing) return level_.tiles.set(level_.tiles.cellAt(center), entry->tile);
        if (*entry->thing == ThingKind::Beacon) return keepOnly(beacon_, level_.beacon, row, column);
        level_.things.push_back({*entry->thing, center});
    }

    void keepOnly(std::optional<Vec2>& found, Vec2& place, int row, int column) const {
        if (found)
            refuse(file_, map_.place(row, column),
                   std::string("a second ") + map_.at(row, column) + ": one was wanted");
        place = map_.center(row, column);
        found = place;
    }

    std::string_view file_;
    std::vector<std::string> lines_;
    int next_ = 0;  ///< of lines_
    DrawnMap map_;
    Level level_;
    std::optional<Vec2> start_, beacon_;
};

}  // namespace

void refuse(std::string_view file, const TextPlace& place, std::string_view complaint) {
    throw std::invalid_argument(std::string(file) + ":" + std::to_string(place.row) + ":" +
                                std::to_string(place.column) + ": " + std::string(complaint));
}

Level readLevel(std::string_view text, std::string_view file) {
    return Reader(text, file).read();
}

}  // namespace plumb::games::runner
