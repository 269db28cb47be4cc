// SPDX-License-Identifier: MIT
// What does a page's JavaScript call? Numbers go in and out; texts and rows lie in the module's memory.
#include <charconv>
#include <exception>
#include <memory>
#include <new>
#include <string>

#include <games/shell/web/game_of_page.h>
#include <games/shell/web/page_session.h>
#include <web/runtime/export.h>

namespace plumb::games {
namespace {

/// All that the module keeps between two calls.
struct Page {
    GameInfo info = gameOfPage();
    std::unique_ptr<PageSession> run = nullptr;
    std::string text = {};  ///< what was given, or is told
    std::vector<std::int64_t> scores = {};
    FooterLine footer = {};
};

Page& page() {
    static Page page;
    return page;
}

/// False after an error, whose words are then the text.
template <class Act>
bool tried(Act act) {
    try {
        act();
        return true;
    } catch (const std::bad_alloc&) {
        page().text = "there is not enough memory";
    } catch (const std::exception& fault) {
        page().text = fault.what();
    }
    return false;
}

}  // namespace

/// Room for a text of so many bytes.
PLUMB_EXPORT(room) char* room(std::uint32_t length) {
    page().text.resize(length);
    return page().text.data();
}
PLUMB_EXPORT(textAt) const char* textAt() {
    return page().text.data();
}
PLUMB_EXPORT(textLength) std::uint32_t textLength() {
    return static_cast<std::uint32_t>(page().text.size());
}

PLUMB_EXPORT(describe) void describe() {
    page().text = describeGame(page().info);
}
/// Of the next run.
PLUMB_EXPORT(addScore) void addScore(double score) {
    page().scores.push_back(static_cast<std::int64_t>(score));
}
/// The title lists other keys for the game's action of that number: the text has their numbers, with commas.
PLUMB_EXPORT(listKeys) void listKeys(std::uint32_t action) {
    std::vector<Key> keys;
    const std::string& text = page().text;
    int number = 0;
    for (const char *at = text.data(), *end = at + text.size(); at < end; ++at) {
        at = std::from_chars(at, end, number).ptr;
        if (number >= 0 && number <= static_cast<int>(Key::Digit9)) keys.push_back(static_cast<Key>(number));
    }
    tried([&] { page().run->session().listKeys(static_cast<int>(action), std::move(keys)); });
}
/// The text is a record: its seed and options begin a run, its ticks, if it has any, are replayed. After an error the
/// run before goes on.
PLUMB_EXPORT(begin) int begin() {
    return tried([] {
        std::vector<std::int64_t> scores = std::exchange(page().scores, {});
        Record start = readRecord(page().text, "record", page().info);
        page().run = std::make_unique<PageSession>(page().info, std::move(start), std::move(scores));
    });
}
PLUMB_EXPORT(isReplay) int isReplay() {
    return page().run->isReplay();
}
PLUMB_EXPORT(replayAgrees) int replayAgrees() {
    return page().run->replayAgrees();
}

/// 1: it goes on; 0: it is over; -1: an error, see the text.
PLUMB_EXPORT(tick) int tick(std::uint32_t buttons) {
    bool goesOn = false;
    return tried([&] { goesOn = page().run->tick(buttons); }) ? int{goesOn} : -1;
}
PLUMB_EXPORT(tap) void tap(double x, double y, int width, int height) {
    page().run->tap({x, y}, {width, height});
}
/// Footer's next column: the text; none: the footer ends.
PLUMB_EXPORT(addFooter) void addFooter() {
    page().footer.push_back(page().text);
}
/// How many numbers the marks are; -1: an error, see the text. The text has the marks' words.
PLUMB_EXPORT(draw) int draw(int width, int height, double between) {
    int count = 0;
    const bool drawn = tried([&] {
        const MarkRow& row = page().run->draw({width, height}, between, std::exchange(page().footer, {}));
        page().text = row.text;
        count = static_cast<int>(row.numbers.size());
    });
    return drawn ? count : -1;
}
PLUMB_EXPORT(numbersAt) const double* numbersAt() {
    return page().run->row().numbers.data();
}
PLUMB_EXPORT(mix) const float* mix(std::uint32_t count) {
    return page().run->mix(count).data();
}

/// Into the text: the record so far.
PLUMB_EXPORT(record) void record() {
    page().text = page().run->recordText();
}
/// Into the text: what the page keeps for the next time: "score N" and "option NAME VALUE", one a line.
PLUMB_EXPORT(toKeep) void toKeep() {
    std::string kept;
    const Session& session = page().run->session();
    for (const std::int64_t score : session.scores()) kept += "score " + std::to_string(score) + "\n";
    for (const auto& [name, value] : session.gameSetup().options)
        if (!value.empty()) kept += "option " + name + " " + value + "\n";
    page().text = kept;
}
PLUMB_EXPORT(screen) int screen() {
    return static_cast<int>(page().run->session().screen());
}
PLUMB_EXPORT(ticks) double ticks() {
    return static_cast<double>(page().run->session().ticks());
}
PLUMB_EXPORT(hash) std::uint64_t hash() {
    return page().run->session().hash();
}
PLUMB_EXPORT(showDebug) void showDebug(int shown) {
    page().run->session().showDebug(shown != 0);
}

}  // namespace plumb::games
