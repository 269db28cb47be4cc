// SPDX-License-Identifier: MIT
#include <compare/command/lab_text.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>

#include <compare/command/verdict_words.h>

namespace plumb::compare {
namespace {

std::string withUnit(double value, const std::string& unit) {
    return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::size_t widestCheck(const LabResult& result) {
    std::size_t width = 0;
    for (const LabOutcome& outcome : result.outcomes) width = std::max(width, outcome.check.name.size());
    return width;
}

}  // namespace

std::string boundText(const LabCheck& check) {
    return fmt::format("{} {}", check.bound == Bound::AtMost ? "at most" : "at least",
                       withUnit(check.limit, check.unit));
}

void listLabs(std::span<const Lab> labs, std::ostream& out) {
    for (const Lab& lab : labs) {
        fmt::print(out, "{}\n    {}\n    a lab; varied: {}\n", lab.name, lab.question, lab.varied);
        for (const LabCheck& check : lab.checks) fmt::print(out, "    {}: {}\n", check.name, boundText(check));
    }
}

void printLab(const LabResult& result, std::ostream& out, bool colour) {
    fmt::print(out, "{}  {}\n", verdictWord(result.verdict, colour), result.lab.name);
    if (result.verdict == Verdict::NotJudged)
        fmt::print(out, "      {}\n", painted(notJudgedText("lab", result.lab.checks.size()), grey, colour));
    const std::size_t width = widestCheck(result);
    for (const LabOutcome& outcome : result.outcomes) {
        const LabCheck& check = outcome.check;
        const std::string value = outcome.value ? withUnit(*outcome.value, check.unit) : "does not exist";
        const std::string line = fmt::format("{:4}  {:{}}  {}, {}", outcome.pass ? "ok" : "FAIL", check.name, width,
                                             value, boundText(check));
        if (outcome.pass)
            fmt::print(out, "      {}\n", line);
        else
            fmt::print(out, "      {}\n", painted(line + ": " + check.reason, red, colour));
    }
    out.flush();
}

void printLabSummary(std::span<const LabResult> results, std::ostream& out, bool colour) {
    std::vector<Verdict> verdicts;
    for (const LabResult& result : results) verdicts.push_back(result.verdict);
    fmt::print(out, "{}\n", countText("lab", verdicts, colour));
}

}  // namespace plumb::compare
