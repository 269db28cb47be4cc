// SPDX-License-Identifier: MIT
// How does a game run in a page of a browser?
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <games/frame/record.h>
#include <games/frame/session.h>
#include <games/frame/source.h>
#include <games/frame/synth.h>
#include <games/shell/web/mark_row.h>

namespace plumb::games {

/// A session, the record of it, and its sound. The page tells it what is pressed.
class PageSession {
public:
    /// start: a seed and options; what it has of runs is replayed. Throws as Session does.
    PageSession(const GameInfo& info, Record start, std::vector<std::int64_t> scores);

    bool isReplay() const { return replay_ != nullptr; }
    /// One tick; false: the player has left, or the replay has ended, and nothing was done. buttons: of the actions in
    /// their order; a replay does without them.
    bool tick(Buttons buttons);
    /// A point of the window was clicked; on a menu's entry, the next ticks choose that.
    void tap(const Vec2& pixel, PixelSize size);
    /// between: what share of a tick has passed [-]; footer: may be empty.
    const MarkRow& draw(PixelSize size, double between, FooterLine footer);
    /// The next samples of the sound.
    const std::vector<float>& mix(std::size_t count);

    const MarkRow& row() const { return row_; }  ///< of the last draw()
    Session& session() { return session_; }
    /// The record of all ticks so far, with the hash.
    std::string recordText() const;
    /// Has the replay come to the hash that its record has? true as well where the record has none.
    bool replayAgrees() const;

    static constexpr int samplesPerSecond = 48000;

private:
    Session session_;
    Record record_;
    std::unique_ptr<Source> replay_;
    std::optional<std::uint64_t> expected_;
    std::deque<Buttons> taps_;  ///< to be pressed, one a tick
    Mixer mixer_{samplesPerSecond};
    std::vector<float> samples_;
    std::vector<FooterLine> footer_;  ///< of the last draw()
    MarkRow row_;
};

/// What the page has to know of a game: lines of words with tabs between them: "title T", "about A",
/// "colors BACKGROUND PANEL TEXT QUIET ACCENT", and for each action, those of the menus behind those of the game,
/// "action NAME ABOUT KEYS PADS"; keys and pads are their numbers in Key and Pad, with commas between them.
std::string describeGame(const GameInfo& info);

}  // namespace plumb::games
