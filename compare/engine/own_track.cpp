// SPDX-License-Identifier: MIT
#include <compare/engine/own_track.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <system_error>

#include <compare/scene/json_text.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\r";
constexpr std::size_t leastRows = 2;  // a body that is at one place only has no velocity

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// As much of a cell as fits into a message.
std::string shownCell(const std::string& cell) {
    constexpr std::size_t most = 40;
    return onOneLine(cell.size() <= most ? cell : cell.substr(0, most) + "...");
}

char separatorOf(std::string_view line) {
    for (const char separator : {';', '\t', ','})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ' ';
}

/// Some spaces in a row are one separator. In quotes nothing separates; two quotes there are one (RFC 4180).
std::vector<std::string> cellsOf(std::string_view line, char separator) {
    std::vector<std::string> cells(1);
    bool isQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isQuote = line[i] == '"';
        if (isQuote && isQuoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[i++];
        else if (isQuote)
            isQuoted = !isQuoted;
        else if (isQuoted || line[i] != separator)
            cells.back() += line[i];
        else if (separator != ' ' || !cells.back().empty())
            cells.emplace_back();
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

/// What std::from_chars reads: a full stop before the decimals, and no plus sign.
std::string plainCell(const std::string& cell, char separator) {
    std::string plain = cell;
    if (separator == ';' || separator == '\t') {
        const std::size_t comma = plain.find(',');
        if (comma != std::string::npos && plain.find('.') == std::string::npos) plain[comma] = '.';
    }
    if (plain.size() > 1 && plain[0] == '+' && plain[1] != '-') plain.erase(0, 1);
    return plain;
}

struct ReadCell {
    double value = 0;
    bool isNumber = false, isTooLarge = false;
};

ReadCell readCell(const std::string& cell, char separator) {
    ReadCell read;
    const std::string plain = plainCell(cell, separator);
    const char* end = plain.data() + plain.size();
    const auto [rest, error] = std::from_chars(plain.data(), end, read.value);
    read.isNumber = error != std::errc::invalid_argument && rest == end;
    read.isTooLarge = error == std::errc::result_out_of_range;
    return read;
}

/// "time" and "s" of "Time [s]".
struct ColumnHead {
    std::string name, unit;
};

ColumnHead columnHeadOf(const std::string& cell) {
    std::string small = cell;
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::size_t end = std::min(small.find_first_of(" \t[(/"), small.size());
    ColumnHead head{small.substr(0, end), ""};
    for (const char c : small.substr(end))
        if (std::string_view(" \t[]()/").find(c) == std::string_view::npos) head.unit += c;
    return head;
}

/// With spaces as separators, a unit in brackets belongs to the name before it.
std::vector<std::string> withUnits(const std::vector<std::string>& cells) {
    std::vector<std::string> heads;
    for (const std::string& cell : cells) {
        const bool isUnit = cell.starts_with('[') || cell.starts_with('(');
        if (isUnit && !heads.empty())
            heads.back() += " " + cell;
        else
            heads.push_back(cell);
    }
    return heads;
}

struct TrackColumns {
    std::size_t t = 0, x = 1, y = 2;
    std::optional<std::size_t> body{};
};

class TrackReader {
public:
    explicit TrackReader(const std::string& file) : file_(file) { track_.file = file; }

    void takeLine(std::string_view text) {
        ++line_;
        const std::string_view line = trimmed(text);
        if (line.starts_with('#') || line.find_first_not_of(" \t,;") == std::string_view::npos) return;
        if (!isBegun_) {
            isBegun_ = true;
            separator_ = separatorOf(line);
            const std::vector<std::string> cells = cellsOf(countedIn(text, line), separator_);
            const auto isNumber = [&](const std::string& cell) { return readCell(cell, separator_).isNumber; };
            if (std::ranges::none_of(cells, isNumber)) return takeHead(withUnits(cells));
        }
        takeRow(cellsOf(countedIn(text, line), separator_));
    }

    OwnTrack finished() && {
        const std::size_t rows = track_.times.size();
        if (rows < leastRows)
            refuse(file_, "has " + std::to_string(rows) + (rows == 1 ? " row" : " rows") + ", wanted at least " +
                              std::to_string(leastRows));
        return std::move(track_);
    }

private:
    /// A line that begins with tabs has empty cells there, but spaces around a line are not cells.
    std::string_view countedIn(std::string_view text, std::string_view line) const {
        return separator_ == '\t' ? text : line;
    }
    std::string lineText() const { return file_ + ":" + std::to_string(line_); }
    std::string fieldText(const std::string& column) const { return lineText() + ": " + column; }

    void takeHead(const std::vector<std::string>& cells) {
        std::vector<ColumnHead> heads;
        for (const std::string& cell : cells) heads.push_back(columnHeadOf(cell));
        const auto isBody = [](const ColumnHead& head) { return head.name == "body"; };
        columns_.t = columnOf(cells, heads, {"t", "time"}, "s");
        columns_.x = columnOf(cells, heads, {"x"}, "m");
        columns_.y = columnOf(cells, heads, {"y"}, "m");
        if (const auto body = std::ranges::find_if(heads, isBody); body != heads.end())
            columns_.body = static_cast<std::size_t>(body - heads.begin());
    }

    /// names: those that the column may have.
    std::size_t columnOf(const std::vector<std::string>& cells, const std::vector<ColumnHead>& heads,
                         const std::vector<std::string>& names, const std::string& unit) const {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < heads.size(); ++i) {
            if (std::ranges::find(names, heads[i].name) == names.end()) continue;
            if (found) refuse(fieldText(names.front()), "given twice, wanted once");
            found = i;
        }
        if (!found) refuse(lineText(), "there is no column " + names.front() + "; the columns are " + shownAll(cells));
        if (const std::string& given = heads[*found].unit; !given.empty() && given != unit)
            refuse(fieldText(names.front()), "is in " + quoted(shownCell(given)) + ", wanted " + unit);
        return *found;
    }

    static std::string shownAll(const std::vector<std::string>& cells) {
        std::vector<std::string> shown;
        for (const std::string& cell : cells) shown.push_back(shownCell(cell));
        return listText(shown);
    }

    void takeRow(const std::vector<std::string>& cells) {
        const double time = numberIn(cells, columns_.t, "t");
        const Vec2 place(numberIn(cells, columns_.x, "x"), numberIn(cells, columns_.y, "y"));
        if (!track_.times.empty() && !(time > track_.times.back()))
            refuse(fieldText("t"),
                   toText(time) + " is not after " + toText(track_.times.back()) + " of the row before");
        const bool hasBody = columns_.body && *columns_.body < cells.size();
        const std::string body = hasBody ? cells[*columns_.body] : "";
        if (track_.times.empty()) track_.body = body;
        if (body != track_.body)
            refuse(fieldText("body"), quoted(shownCell(body)) + " is not " + quoted(shownCell(track_.body)) +
                                          " of the rows before, wanted one body");
        track_.times.push_back(time);
        track_.places.push_back(place);
    }

    double numberIn(const std::vector<std::string>& cells, std::size_t column, const std::string& name) const {
        if (column >= cells.size() || cells[column].empty()) refuse(fieldText(name), "is not given, wanted a number");
        const ReadCell read = readCell(cells[column], separator_);
        const std::string shown = quoted(shownCell(cells[column]));
        if (!read.isNumber) refuse(fieldText(name), shown + " is not a number");
        if (read.isTooLarge) refuse(fieldText(name), shown + " is beyond double precision");
        requireFinite(read.value, fieldText(name));
        return read.value;
    }

    const std::string& file_;
    int line_ = 0;
    bool isBegun_ = false;  // the first line that counts was read
    char separator_ = ',';
    TrackColumns columns_;
    OwnTrack track_;
};

}  // namespace

OwnTrack ownTrackFrom(std::string_view csv, const std::string& file) {
    if (csv.starts_with(byteOrderMark)) csv.remove_prefix(byteOrderMark.size());
    TrackReader reader(file);
    for (std::size_t start = 0; start < csv.size();) {
        const std::size_t end = std::min(csv.find('\n', start), csv.size());
        reader.takeLine(csv.substr(start, end - start));
        start = end + 1;
    }
    return std::move(reader).finished();
}

}  // namespace plumb::compare
