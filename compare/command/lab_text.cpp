// SPDX-License-Identifier: MIT
#include <compare/command/lab_text.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>

#include <compare/command/colours.h>

namespace plumb::compare {
namespace {

std::string painted(const std::string& text, const char* code, bool colour) {
    return colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

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
    const std::string verdict = result.pass ? painted("PASS", green, colour) : painted("FAIL", red, colour);
    fmt::print(out, "{}  {}\n", verdict, result.lab.name);
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
    const auto held = std::ranges::count_if(results, [](const LabResult& result) { return result.pass; });
    const auto failed = std::ssize(results) - held;
    const std::string hold = fmt::format("{} lab{}", held, held == 1 ? " holds" : "s hold");
    const std::string fail = fmt::format("{} {}", failed, failed == 1 ? "fails" : "fail");
    fmt::print(out, "{}, {}.\n", painted(hold, held ? green : yellow, colour),
               painted(fail, failed ? red : green, colour));
}

}  // namespace plumb::compare
