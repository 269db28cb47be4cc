// SPDX-License-Identifier: MIT
#include <games/frame/record.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace plumb::games {
namespace {

constexpr std::string_view format = "plumb-record";
constexpr int version = 1;

std::string namesOf(Buttons buttons, const ActionList& actions) {
    std::string names;
    for (int i = 0; i < actions.size(); ++i)
        if ((buttons >> i & 1) != 0) names += (names.empty() ? "" : "+") + actions[i].name;
    return names.empty() ? "-" : names;
}

std::string hexOf(std::uint64_t bits) {
    std::string digits(16, '0');
    for (std::size_t i = 0; i < digits.size(); ++i) digits[i] = "0123456789abcdef"[bits >> (60 - 4 * i) & 15];
    return digits;
}

template <class Number>
std::optional<Number> numberIn(const std::string& word, int base = 10) {
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number, base);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\v\f", at), text.size());
        if (end > at) words.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

/// Reads a record line by line. Its errors name the line.
class Reader {
public:
    Reader(std::string_view text, const std::string& name, const GameInfo& info)
        : rest_(text), name_(name), info_(info), actions_(withMenuActions(info.actions)) {}

    Record read() {
        readHead();
        while (nextLine()) readLine();
        return std::move(record_);
    }

private:
    /// Reads the words of the next line that has any. # begins a comment.
    bool nextLine() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            text_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++line_;
            words_ = wordsOf(std::string_view(text_).substr(0, text_.find('#')));
            if (!words_.empty()) return true;
        }
        return false;
    }

    [[noreturn]] void fail(const std::string& wanted) const {
        std::string shown = text_.substr(0, 60);
        std::replace_if(
            shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
        throw std::invalid_argument(name_ + ":" + std::to_string(line_) + ": \"" + shown + "\" is not " + wanted);
    }

    void readHead() {
        const std::string wanted =
            "\"" + std::string(format) + " " + std::to_string(version) + " " + info_.name + "\", a record's first line";
        const bool any = nextLine();
        line_ = std::max(line_, 1);
        if (!any || words_ != std::vector<std::string>{std::string(format), std::to_string(version), info_.name})
            fail(wanted);
        record_.game = info_.name;
    }

    void readLine() {
        if (record_.hash) fail("wanted after the line \"end\"");
        if (words_[0] == "seed")
            readSeed();
        else if (words_[0] == "option")
            readOption();
        else if (words_[0] == "end")
            readEnd();
        else
            readRun();
    }

    void readSeed() {
        const auto seed = words_.size() == 2 ? numberIn<std::uint64_t>(words_[1]) : std::nullopt;
        if (!seed) fail("\"seed\" and a whole number from 0 to 2^64 - 1");
        record_.seed = *seed;
    }

    /// A value goes to the end of its line, because it may be the name of a file.
    void readOption() {
        const char* wanted = "\"option\", its name and its value";
        if (words_.size() < 2) fail(wanted);
        std::string value = text_.substr(text_.find(words_[1], text_.find(words_[0]) + words_[0].size()));
        value.erase(0, value.find_first_not_of(" \t", words_[1].size()));
        value.erase(value.find_last_not_of(" \t\r") + 1);
        if (value.empty()) fail(wanted);
        record_.options[words_[1]] = value;
    }

    void readEnd() {
        const auto hash = words_.size() == 2 ? numberIn<std::uint64_t>(words_[1], 16) : std::nullopt;
        if (!hash) fail("\"end\" and a hash of hexadecimal digits");
        record_.hash = *hash;
    }

    void readRun() {
        constexpr std::int64_t longest = 1'000'000'000;  // half a year; the sum of 2^33 lines of it still fits
        const auto ticks = words_.size() == 2 ? numberIn<std::int64_t>(words_[0]) : std::nullopt;
        if (!ticks || *ticks < 1 || *ticks > longest)
            fail("a number of ticks, 1 to 10^9, and the actions done in them");
        record_.runs.push_back({*ticks, buttonsIn(words_[1])});
    }

    Buttons buttonsIn(const std::string& names) const {
        Buttons buttons = 0;
        if (names == "-") return buttons;
        for (std::size_t at = 0; at <= names.size();) {
            const std::size_t end = std::min(names.find('+', at), names.size());
            const std::string name = names.substr(at, end - at);
            if (!actions_.contains(name)) fail("made of the actions of " + info_.name + ": " + allNames());
            buttons |= actions_.button(name);
            at = end + 1;
        }
        return buttons;
    }

    std::string allNames() const {
        std::string names;
        for (const Action& action : actions_.all()) names += (names.empty() ? "" : ", ") + action.name;
        return names;
    }

    std::string_view rest_;  ///< the part that has not been read yet
    std::string name_;
    const GameInfo& info_;
    ActionList actions_;
    Record record_;
    std::string text_;
    std::vector<std::string> words_;
    int line_ = 0;
};

class Recorded final : public Source {
public:
    explicit Recorded(Record record) : record_(std::move(record)) {}

    std::optional<Buttons> next(const Session&) override {
        if (run_ == record_.runs.size()) return std::nullopt;
        const Run& run = record_.runs[run_];
        if (++used_ == run.ticks) {
            ++run_;
            used_ = 0;
        }
        return run.buttons;
    }

private:
    Record record_;
    std::size_t run_ = 0;
    std::int64_t used_ = 0;
};

}  // namespace

void Record::add(Buttons buttons) {
    if (runs.empty() || runs.back().buttons != buttons)
        runs.push_back({1, buttons});
    else
        ++runs.back().ticks;
}

std::int64_t Record::ticks() const {
    std::int64_t sum = 0;
    for (const Run& run : runs) sum += run.ticks;
    return sum;
}

std::string textOf(const Record& record, const ActionList& actions) {
    std::string text = std::string(format) + " " + std::to_string(version) + " " + record.game + "\nseed " +
                       std::to_string(record.seed) + "\n";
    for (const auto& [name, value] : record.options) text += "option " + name + " " + value + "\n";
    for (const Run& run : record.runs) text += std::to_string(run.ticks) + " " + namesOf(run.buttons, actions) + "\n";
    if (record.hash) text += "end " + hexOf(*record.hash) + "\n";
    return text;
}

Record readRecord(std::string_view text, const std::string& name, const GameInfo& info) {
    return Reader(text, name, info).read();
}

std::unique_ptr<Source> recordSource(Record record) {
    return std::make_unique<Recorded>(std::move(record));
}

}  // namespace plumb::games
