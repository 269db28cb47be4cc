// SPDX-License-Identifier: MIT
#include <compare/page/page_table.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

namespace plumb::compare {
namespace {

std::string rowText(const std::vector<std::string>& cells) {
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream rest(line.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        if (first != std::string::npos) cells.push_back(cell.substr(first, last - first + 1));
    }
    return cells;
}

/// The numbers of a cell such as "0, 6, 90" or "61.5 mm", in the SI unit.
std::vector<double> numbersOf(const std::string& cell) {
    static const std::map<std::string, double> scales{{"nm", 1e-9}, {"µm", 1e-6}, {"mm", 1e-3}};
    static const std::regex number("(-?[0-9.]+(?:e[-+]?[0-9]+)?)(?: (nm|µm|mm))?");
    std::vector<double> numbers;
    for (auto each = std::sregex_iterator(cell.begin(), cell.end(), number); each != std::sregex_iterator(); ++each) {
        const auto scale = scales.find(each->str(2));
        numbers.push_back(std::stod(each->str(1)) * (scale == scales.end() ? 1 : scale->second));
    }
    return numbers;
}

bool isWithinTwo(const std::string& page, const std::string& measured) {
    if (page == measured) return true;
    const std::vector<double> said = numbersOf(page), seen = numbersOf(measured);
    return !said.empty() && std::ranges::equal(said, seen, [](double a, double b) {
        return a == b || (a * b > 0 && std::abs(std::log2(a / b)) <= 1);
    });
}

bool agrees(const std::string& page, const std::string& measured, Exactness exactness) {
    switch (exactness) {
        case Exactness::ToTheDigit: return page == measured;
        case Exactness::WithinTwo: return isWithinTwo(page, measured);
        case Exactness::Unseen: break;
    }
    return true;
}

}  // namespace

std::string markdown(const PageTable& table) {
    std::string text = rowText(table.head);
    text += "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) text += "---|";
    text += "\n";
    for (const std::vector<std::string>& row : table.rows) text += rowText(row);
    return text;
}

PageTable tableOf(const std::string& text) {
    PageTable table;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) {
            if (!table.head.empty()) break;
        } else if (table.head.empty()) {
            table.head = cellsOf(line);
        } else if (!line.starts_with("|---")) {
            table.rows.push_back(cellsOf(line));
        }
    }
    return table;
}

std::vector<std::string> differences(const PageTable& page, const PageTable& measured,
                                     const std::vector<Exactness>& columns) {
    const auto shape = [](const PageTable& table) { return std::pair(table.head.size(), table.rows.size()); };
    if (shape(page) != shape(measured))
        return {fmt::format("the table has {} columns and {} rows, wanted {} and {}", page.head.size(),
                            page.rows.size(), measured.head.size(), measured.rows.size())};
    std::vector<std::string> found;
    for (std::size_t row = 0; row < measured.rows.size(); ++row) {
        const std::vector<std::string>&said = page.rows[row], &seen = measured.rows[row];
        if (said.size() != seen.size()) {
            found.push_back(fmt::format("{} has {} cells, wanted {}", seen.front(), said.size(), seen.size()));
            continue;
        }
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (!agrees(said[i], seen[i], columns[i]))
                found.push_back(fmt::format("{}, {}: the page says \"{}\", measured was \"{}\"", seen.front(),
                                            measured.head[i], said[i], seen[i]));
    }
    return found;
}

}  // namespace plumb::compare
