// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

namespace plumb::games {
namespace {

constexpr double middle = screenWidth / 2;

void dim(Canvas& canvas, const Theme& theme, double share) {
    canvas.clear(theme.background.faded(share));
}

void heading(Canvas& canvas, const std::string& text, const Theme& theme, double y, double size) {
    canvas.text({middle, y}, text,
                {.size = size,
                 .color = theme.text,
                 .align = Align::Center,
                 .baseline = Baseline::Middle,
                 .weight = Weight::Heavy,
                 .fitWidth = screenWidth - 80});
}

void aside(Canvas& canvas, const std::string& text, const Theme& theme, double y) {
    canvas.text({middle, y}, text,
                {.size = 13,
                 .color = theme.quiet,
                 .align = Align::Center,
                 .baseline = Baseline::Middle,
                 .fitWidth = screenWidth - 60});
}

std::string keysOf(const Action& action) {
    std::string keys;
    for (const Key key : action.keys) keys += (keys.empty() ? "" : " / ") + std::string(nameOf(key));
    return keys;
}

void drawTitle(Canvas& canvas, const ScreenView& view) {
    const GameInfo& info = view.session.info();
    dim(canvas, info.theme, 0.6);
    heading(canvas, info.title, info.theme, 70, 54);
    aside(canvas, info.about, info.theme, 110);
    view.menu.draw(canvas, {middle, 150}, info.theme);
    std::string keys;
    for (const Action& action : info.actions)
        if (!action.about.empty()) keys += (keys.empty() ? "" : "     ") + keysOf(action) + ": " + action.about;
    aside(canvas, keys, info.theme, 336);
}

void drawOver(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    const Progress progress = view.session.progress();
    dim(canvas, theme, 0.6);
    heading(canvas, progress.outcome == Outcome::Won ? "You won" : "Game over", theme, 90, 44);
    heading(canvas, std::to_string(progress.score), theme, 140, 28);
    if (view.rank >= 0) aside(canvas, view.rank == 0 ? "the best so far" : "among the best", theme, 168);
    view.menu.draw(canvas, {middle, 210}, theme);
}

void drawScores(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    dim(canvas, theme, 0.8);
    heading(canvas, "Best scores", theme, 48, 32);
    const auto& scores = view.session.scores();
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const double y = 86 + 22 * static_cast<double>(i);
        canvas.text({middle - 70, y}, std::to_string(i + 1) + ".", {.size = 16, .color = theme.quiet});
        canvas.text({middle + 70, y}, std::to_string(scores[i]),
                    {.size = 16, .color = theme.text, .align = Align::Right});
    }
    if (scores.empty()) aside(canvas, "none yet", theme, 150);
    view.menu.draw(canvas, {middle, 332}, theme);
}

void drawPause(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    dim(canvas, theme, 0.6);
    heading(canvas, "Pause", theme, 110, 44);
    view.menu.draw(canvas, {middle, 180}, theme);
}

}  // namespace

void drawScreen(Canvas& canvas, const ScreenView& view) {
    switch (view.session.screen()) {
        case Screen::Title: return drawTitle(canvas, view);
        case Screen::Pause: return drawPause(canvas, view);
        case Screen::Over: return drawOver(canvas, view);
        case Screen::Scores: return drawScores(canvas, view);
        case Screen::Play: return;
    }
}

}  // namespace plumb::games
