// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include <games/frame/key_list.h>

namespace plumb::games {
namespace {

constexpr double middle = screenWidth / 2;
constexpr double lineHeight = Menu::lineHeight;

void dim(Canvas& canvas, const Theme& theme, double share) {
    canvas.clear(theme.background.faded(share));
}

/// What holds a menu, or a list, from one height of the screen to another.
void panel(Canvas& canvas, const Theme& theme, double top, double bottom) {
    constexpr double halfWidth = 130, radius = 16;
    canvas.rect({middle - halfWidth, top}, {2 * halfWidth, bottom - top}, theme.panel.faded(0.88), radius);
}

/// Where a menu ends whose first line has its middle at a height of the screen.
double menuEnd(const Menu& menu, double first) {
    return first + (menu.size() - 0.5) * lineHeight;
}

void heading(Canvas& canvas, const std::string& text, const Theme& theme, double y, double size) {
    TextStyle style{.size = size,
                    .color = theme.background.faded(0.8),
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy,
                    .fitWidth = screenWidth - 60};
    canvas.text({middle + size / 24, y + size / 24}, text, style);  // its shadow
    style.color = theme.text;
    canvas.text({middle, y}, text, style);
}

void aside(Canvas& canvas, const std::string& text, const Theme& theme, double y, double width) {
    canvas.text(
        {middle, y}, text,
        {.size = 13, .color = theme.quiet, .align = Align::Center, .baseline = Baseline::Middle, .fitWidth = width});
}

void drawKeys(Canvas& canvas, const GameInfo& info) {
    constexpr std::size_t longest = 96;
    const std::vector<std::string> lines = keyLines(info.actions, longest);
    double y = screenHeight - 16 - 16 * (static_cast<double>(lines.size()) - 1);
    for (const std::string& line : lines) {
        canvas.text({middle, y}, line,
                    {.size = 12,
                     .color = info.theme.text,
                     .align = Align::Center,
                     .baseline = Baseline::Middle,
                     .fitWidth = screenWidth - 40});
        y += 16;
    }
}

void drawTitle(Canvas& canvas, const ScreenView& view) {
    const GameInfo& info = view.session.info();
    constexpr double first = 160;
    dim(canvas, info.theme, info.drawTitle ? 0.2 : 0.66);  // what was drawn to lie behind it leaves room for it
    heading(canvas, info.title, info.theme, 66, 58);
    aside(canvas, info.about, info.theme, 112, screenWidth - 60);
    panel(canvas, info.theme, first - lineHeight, menuEnd(view.menu, first) + 10);
    view.menu.draw(canvas, {middle, first}, info.theme);
    drawKeys(canvas, info);
}

std::string verdictOf(const Session& session) {
    const std::string own = session.game()->verdict();
    if (!own.empty()) return own;
    return session.progress().outcome == Outcome::Won ? "You won" : "Game over";
}

/// How a round's score stands to the best.
std::string placeOf(const ScreenView& view) {
    const auto& scores = view.session.scores();
    if (view.rank == 0) return "the best so far";
    if (view.rank > 0) return "number " + std::to_string(view.rank + 1) + " of the best";
    return scores.empty() ? "" : "the best so far: " + std::to_string(scores.front());
}

void drawOver(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    constexpr double first = 214;
    dim(canvas, theme, 0.5);
    heading(canvas, verdictOf(view.session), theme, 66, 46);
    panel(canvas, theme, 106, menuEnd(view.menu, first) + 12);
    canvas.text({middle, 138}, std::to_string(view.session.progress().score),
                {.size = 34,
                 .color = theme.accent,
                 .align = Align::Center,
                 .baseline = Baseline::Middle,
                 .weight = Weight::Heavy,
                 .fitWidth = 230});
    aside(canvas, placeOf(view), theme, 170, 230);
    view.menu.draw(canvas, {middle, first}, theme);
}

void drawScores(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    const auto& scores = view.session.scores();
    dim(canvas, theme, 0.62);
    heading(canvas, "Best scores", theme, 38, 34);
    panel(canvas, theme, 66, 346);
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const double y = 86 + 23 * static_cast<double>(i);
        const Color color = static_cast<int>(i) == view.rank ? theme.accent : theme.text;
        TextStyle style{.size = 16, .color = theme.quiet, .align = Align::Right, .baseline = Baseline::Middle};
        canvas.text({middle - 62, y}, std::to_string(i + 1), style);
        style.color = color;
        style.weight = Weight::Bold;
        canvas.text({middle + 90, y}, std::to_string(scores[i]), style);
    }
    if (scores.empty()) aside(canvas, "none yet", theme, 180, 230);
    view.menu.draw(canvas, {middle, 327}, theme);
}

void drawPause(Canvas& canvas, const ScreenView& view) {
    const Theme& theme = view.session.info().theme;
    constexpr double first = 170;
    dim(canvas, theme, 0.5);
    heading(canvas, "Pause", theme, 100, 46);
    panel(canvas, theme, first - lineHeight, menuEnd(view.menu, first) + 12);
    view.menu.draw(canvas, {middle, first}, theme);
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
