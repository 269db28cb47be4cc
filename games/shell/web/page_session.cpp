// SPDX-License-Identifier: MIT
#include <games/shell/web/page_session.h>

#include <array>
#include <cmath>
#include <utility>

namespace plumb::games {
namespace {

std::string cssOf(const Color& color) {
    std::string css = "#";
    for (const double share : {color.red, color.green, color.blue}) {
        const auto level = static_cast<std::size_t>(std::lround(share * 255));
        css += "0123456789abcdef"[level / 16];
        css += "0123456789abcdef"[level % 16];
    }
    return css;
}

template <class Button>
std::string namesOfAll(const std::vector<Button>& buttons) {
    std::string names;
    for (const Button button : buttons) names += (names.empty() ? "" : ",") + std::to_string(static_cast<int>(button));
    return names;
}

}  // namespace

PageSession::PageSession(const GameInfo& info, Record start, std::vector<std::int64_t> scores)
    : session_(info, {start.seed, start.options, std::move(scores)}),
      record_{info.name, start.seed, start.options},
      expected_(start.hash) {
    if (!start.runs.empty()) replay_ = recordSource(std::move(start));
}

bool PageSession::tick(Buttons buttons) {
    if (session_.ended()) return false;
    if (replay_) {
        const std::optional<Buttons> next = replay_->next(session_);
        if (!next) return false;
        buttons = *next;
    } else if (!taps_.empty()) {
        buttons = taps_.front();
        taps_.pop_front();
    }
    session_.update(buttons);
    record_.add(buttons);
    for (const Cue& cue : session_.takeCues()) mixer_.add(cue);
    return true;
}

void PageSession::tap(const Vec2& pixel, PixelSize size) {
    if (!taps_.empty()) return;
    for (const Buttons buttons : session_.pressesAt(pixel, size, footer_)) taps_.push_back(buttons);
}

const MarkRow& PageSession::draw(PixelSize size, double between, FooterLine footer) {
    Canvas canvas(size, between);
    footer_.clear();
    if (!footer.empty()) footer_.push_back(std::move(footer));
    session_.draw(canvas, footer_);
    writeMarks(canvas.drawing(), row_);
    return row_;
}

const std::vector<float>& PageSession::mix(std::size_t count) {
    samples_.resize(count);
    mixer_.mix(samples_);
    return samples_;
}

std::string PageSession::recordText() const {
    Record record = record_;
    record.hash = session_.hash();
    return textOf(record, session_.actions());
}

bool PageSession::replayAgrees() const {
    return !expected_ || *expected_ == session_.hash();
}

std::string describeGame(const GameInfo& info) {
    const Theme& theme = info.theme;
    std::string text = "title\t" + info.title + "\nabout\t" + info.about + "\nfillsUpright\t" +
                       (info.fillsUpright ? "yes" : "no") + "\ncolors";
    for (const Color& color : {theme.background, theme.panel, theme.text, theme.quiet, theme.accent})
        text += "\t" + cssOf(color);
    const ActionList actions = withMenuActions(info.actions);
    for (const Action& action : actions.all())
        text += "\naction\t" + action.name + "\t" + action.about + "\t" + namesOfAll(action.keys) + "\t" +
                namesOfAll(action.pads);
    return text;
}

}  // namespace plumb::games
