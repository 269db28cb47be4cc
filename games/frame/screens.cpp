// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include <algorithm>

namespace plumb::games {
namespace {

constexpr double middle = screenWidth / 2;
constexpr double lineHeight = Menu::lineHeight;
constexpr double mostScale = 2;  // a panel is then nearly as wide as the safe area

/// The place on which a screen is drawn.
struct Sheet {
    Canvas& canvas;
    const Theme& theme;
    double width;  ///< of the safe area, in units of the sheet; these may be larger than units of the screen
};

void dim(const Sheet& on, double share) {
    on.canvas.clear(on.theme.background.faded(share));
}

/// Draws the panel behind a menu or a list, from one height of the screen to another.
void panel(const Sheet& on, double top, double bottom) {
    constexpr double halfWidth = 130, radius = 16;
    on.canvas.rect({middle - halfWidth, top}, {2 * halfWidth, bottom - top}, on.theme.panel.faded(0.88), radius);
}

/// The lower end of a menu. first: the height of the middle of its first line.
double menuEnd(const Menu& menu, double first) {
    return first + (menu.size() - 0.5) * lineHeight;
}

void heading(const Sheet& on, const std::string& text, double y, double size) {
    TextStyle style{.size = size,
                    .color = on.theme.background.faded(0.8),
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy,
                    .fitWidth = on.width - 60};
    on.canvas.text({middle + size / 24, y + size / 24}, text, style);  // its shadow
    style.color = on.theme.text;
    on.canvas.text({middle, y}, text, style);
}

void aside(const Sheet& on, const std::string& text, double y, double width) {
    on.canvas.text(
        {middle, y}, text,
        {.size = 13, .color = on.theme.quiet, .align = Align::Center, .baseline = Baseline::Middle, .fitWidth = width});
}

/// Draws the line about the game, in two lines where it is too long for one.
void aboutGame(const Sheet& on, const std::string& text, double y) {
    constexpr double letterWidth = 6.5;  // at the size of aside(), about
    const double width = on.width - 40;
    const std::size_t space = text.find(' ', text.size() / 2);
    if (letterWidth * static_cast<double>(text.size()) < 1.3 * width || space == std::string::npos)
        return aside(on, text, y, width);
    aside(on, text.substr(0, space), y - 6, width);
    aside(on, text.substr(space + 1), y + 10, width);
}

void drawKeys(const Sheet& on, const GameInfo& info) {
    const double longest = 96 * on.width / screenWidth;  // [letters]
    const std::vector<std::string> lines = keyLines(info.actions, static_cast<std::size_t>(longest));
    double y = screenHeight - 16 - 16 * (static_cast<double>(lines.size()) - 1);
    for (const std::string& line : lines) {
        on.canvas.text({middle, y}, line,
                       {.size = 12,
                        .color = on.theme.text,
                        .align = Align::Center,
                        .baseline = Baseline::Middle,
                        .fitWidth = on.width - 40});
        y += 16;
    }
}

void drawTitle(const Sheet& on, const ScreenView& view) {
    const GameInfo& info = view.session.info();
    const double first = menuTop(Screen::Title).y();
    dim(on, info.drawTitle ? 0.2 : 0.66);  // a picture that was made for the title leaves room for the menu
    heading(on, info.title, 66, 58);
    aboutGame(on, info.about, 112);
    panel(on, first - lineHeight, menuEnd(view.menu, first) + 10);
    view.menu.draw(on.canvas, menuTop(Screen::Title), on.theme);
    drawKeys(on, info);
}

std::string verdictOf(const Session& session) {
    const std::string own = session.game()->verdict();
    if (!own.empty()) return own;
    return session.progress().outcome == Outcome::Won ? "You won" : "Game over";
}

/// Compares the score of a round with the best scores, in words.
std::string placeOf(const ScreenView& view) {
    const auto& scores = view.session.scores();
    if (view.rank == 0) return "the best so far";
    if (view.rank > 0) return "number " + std::to_string(view.rank + 1) + " of the best";
    return scores.empty() ? "" : "the best so far: " + std::to_string(scores.front());
}

void drawOver(const Sheet& on, const ScreenView& view) {
    const double first = menuTop(Screen::Over).y();
    dim(on, 0.5);
    heading(on, verdictOf(view.session), 66, 46);
    panel(on, 106, menuEnd(view.menu, first) + 12);
    on.canvas.text({middle, 138}, std::to_string(view.session.progress().score),
                   {.size = 34,
                    .color = on.theme.accent,
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy,
                    .fitWidth = 230});
    aside(on, placeOf(view), 170, 230);
    view.menu.draw(on.canvas, menuTop(Screen::Over), on.theme);
}

void drawScores(const Sheet& on, const ScreenView& view) {
    const auto& scores = view.session.scores();
    dim(on, 0.62);
    heading(on, "Best scores", 38, 34);
    panel(on, 66, 346);
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const double y = 86 + 23 * static_cast<double>(i);
        const Color color = static_cast<int>(i) == view.rank ? on.theme.accent : on.theme.text;
        TextStyle style{.size = 16, .color = on.theme.quiet, .align = Align::Right, .baseline = Baseline::Middle};
        on.canvas.text({middle - 62, y}, std::to_string(i + 1), style);
        style.color = color;
        style.weight = Weight::Bold;
        on.canvas.text({middle + 90, y}, std::to_string(scores[i]), style);
    }
    if (scores.empty()) aside(on, "none yet", 180, 230);
    view.menu.draw(on.canvas, menuTop(Screen::Scores), on.theme);
}

void drawPause(const Sheet& on, const ScreenView& view) {
    const double first = menuTop(Screen::Pause).y();
    dim(on, 0.5);
    heading(on, "Pause", 100, 46);
    panel(on, first - lineHeight, menuEnd(view.menu, first) + 12);
    view.menu.draw(on.canvas, menuTop(Screen::Pause), on.theme);
}

}  // namespace

Vec2 menuTop(Screen screen) {
    switch (screen) {
        case Screen::Title: return {middle, 160};
        case Screen::Pause: return {middle, 170};
        case Screen::Over: return {middle, 214};
        case Screen::Scores: return {middle, 327};
        case Screen::Play: break;
    }
    return {middle, 0};
}

Place screenPlace(const Aabb& visible) {
    const double scale = std::clamp((visible.upper.y() - visible.lower.y()) / screenHeight, 1.0, mostScale);
    const Vec2 center(middle, screenHeight / 2);
    return {.position = (1 - scale) * center, .scale = {scale, scale}};
}

void drawScreen(Canvas& canvas, const ScreenView& view) {
    canvas.screen();
    const Place place = screenPlace(canvas.visible());
    const auto scope = canvas.place(place);
    const Sheet on{canvas, view.session.info().theme, screenWidth / place.scale.x()};
    switch (view.session.screen()) {
        case Screen::Title: return drawTitle(on, view);
        case Screen::Pause: return drawPause(on, view);
        case Screen::Over: return drawOver(on, view);
        case Screen::Scores: return drawScores(on, view);
        case Screen::Play: return;
    }
}

}  // namespace plumb::games
