// SPDX-License-Identifier: MIT
#include <compare/command/verdict_words.h>

#include <fmt/format.h>

#include <algorithm>

namespace plumb::compare {

std::string painted(const std::string& text, const char* code, bool colour) {
    return colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

std::string verdictWord(Verdict verdict, bool colour) {
    switch (verdict) {
        case Verdict::Holds: return painted("PASS", green, colour);
        case Verdict::Fails: return painted("FAIL", red, colour);
        case Verdict::NotJudged: break;
    }
    return painted("----", grey, colour);
}

std::string countText(const std::string& what, std::span<const Verdict> verdicts, bool colour) {
    const auto held = std::ranges::count(verdicts, Verdict::Holds);
    const auto failed = std::ranges::count(verdicts, Verdict::Fails);
    const auto unjudged = std::ranges::count(verdicts, Verdict::NotJudged);
    const std::string hold = fmt::format("{} {}{}", held, what, held == 1 ? " holds" : "s hold");
    const std::string fail = fmt::format("{} {}", failed, failed == 1 ? "fails" : "fail");
    const char* failColour = failed ? red : held ? green : grey;
    std::string text = painted(hold, held ? green : grey, colour) + ", " + painted(fail, failColour, colour);
    if (unjudged) text += ", " + painted(fmt::format("{} not judged", unjudged), grey, colour);
    return text + ".";
}

std::string notJudgedText(const std::string& what, std::size_t checks) {
    return checks == 0 ? fmt::format("this {} has no checks", what) : "no check binds these engines";
}

}  // namespace plumb::compare
