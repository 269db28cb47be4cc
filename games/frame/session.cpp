// SPDX-License-Identifier: MIT
#include <games/frame/session.h>

#include <algorithm>

#include <games/frame/canvas.h>
#include <games/frame/debug_view.h>
#include <games/frame/hash.h>
#include <games/frame/menu.h>
#include <games/frame/screens.h>
#include <games/frame/title_show.h>
#include <plumb/math/random.h>

namespace plumb::games {
namespace {

constexpr std::size_t mostScores = 10;
/// The end of a round stays for this time before a button leads on: a player who lost was still pressing some [ticks].
constexpr int overDelay = 40;

}  // namespace

struct Session::State {
    GameInfo info;
    ActionList actions;
    Random seeds;  ///< for the rounds after the first
    GameSetup next;
    std::vector<std::int64_t> scores;
    std::vector<Option> options;

    Screen screen = Screen::Title;
    std::int64_t ticks = 0, since = 0;  ///< since: ticks in this screen
    Buttons before = 0;
    Menu menu;
    std::unique_ptr<Game> game;
    int rounds = 0;
    int rank = -1;  ///< of the last round among the scores; -1: not among them
    TitleShow show;
    bool ended = false, debug = false;
    std::vector<Cue> cues;

    State(const GameInfo& game_, const SessionSetup& setup)
        : info(game_),
          actions(withMenuActions(info.actions)),
          seeds(setup.seed),
          next{setup.seed, optionsOf(info, setup.options)},
          scores(setup.scores),
          options(optionsToChoose(info)),
          show(info) {
        std::sort(scores.rbegin(), scores.rend());
        if (scores.size() > mostScores) scores.resize(mostScores);
        // Refuses a bad value of an option now, and not only when the player chooses Play.
        if (!setup.options.empty()) static_cast<void>(info.make(next));
        goTo(Screen::Title);
    }

    void goTo(Screen to) {
        screen = to;
        since = 0;
        menu = Menu(entriesOf(to));
    }

    std::vector<MenuEntry> entriesOf(Screen of) const {
        switch (of) {
            case Screen::Title: return titleEntries();
            case Screen::Pause: return {{"Go on"}, {"Start again"}, {"To the title"}};
            case Screen::Over: return {{"Play again"}, {"Best scores"}, {"To the title"}};
            case Screen::Scores: return {{"To the title"}};
            case Screen::Play: break;
        }
        return {};
    }

    std::vector<MenuEntry> titleEntries() const {
        std::vector<MenuEntry> entries{{"Play"}};
        for (const Option& option : options)
            entries.push_back({option.label.empty() ? option.name : option.label, next.options.at(option.name)});
        entries.push_back({"Best scores"});
        entries.push_back({"Quit"});
        return entries;
    }

    void begin() {
        if (rounds > 0) next.seed = seeds.bits();
        ++rounds;
        game = info.make(next);
        goTo(Screen::Play);
    }

    void end() {
        const std::int64_t score = game->progress().score;
        const auto place = std::upper_bound(scores.begin(), scores.end(), score, std::greater<>());
        rank = score > 0 ? static_cast<int>(place - scores.begin()) : -1;
        if (rank >= 0) scores.insert(place, score);
        if (scores.size() > mostScores) scores.resize(mostScores);
        if (rank >= static_cast<int>(mostScores)) rank = -1;
        goTo(Screen::Over);
    }

    void update(const Input& input) {
        switch (screen) {
            case Screen::Play: updatePlay(input); break;
            case Screen::Title:
                updateMenu(input);
                // Only where the title stays: the show is not needed when a round begins.
                if (screen == Screen::Title) show.update();
                break;
            case Screen::Over:
                if (since >= overDelay) updateMenu(input);
                break;
            default: updateMenu(input);
        }
    }

    void updatePlay(const Input& input) {
        if (input.pressed("pause") || input.pressed("back")) return goTo(Screen::Pause);
        game->update(input);
        for (const Cue& cue : game->takeCues()) cues.push_back(cue);
        if (game->progress().outcome != Outcome::Running) end();
    }

    void updateMenu(const Input& input) {
        const bool leave = screen == Screen::Pause ? input.pressed("pause") || input.pressed("back")
                                                   : input.pressed("back") && screen != Screen::Title;
        if (leave) return goTo(screen == Screen::Pause ? Screen::Play : Screen::Title);
        const Menu::Event event = menu.update(input);
        if (event == Menu::Event::None) return;
        cues.push_back({.wave = Wave::Triangle,
                        .from = 520,
                        .to = event == Menu::Event::Confirmed ? 1040.0 : 520.0,
                        .seconds = 0.06,
                        .volume = 0.3});
        if (event == Menu::Event::Confirmed)
            choose(menu.chosen());
        else if (event != Menu::Event::Moved)
            change(menu.chosen(), event == Menu::Event::Left ? -1 : 1);
    }

    void choose(int entry) {
        if (screen == Screen::Title) return chooseInTitle(entry);
        if (screen == Screen::Scores || entry == 2) return goTo(Screen::Title);
        if (entry == 1 && screen == Screen::Over) return goTo(Screen::Scores);
        if (entry == 0 && screen == Screen::Pause) return goTo(Screen::Play);
        begin();
    }

    void chooseInTitle(int entry) {
        if (entry == 0) return begin();
        if (entry == menu.size() - 2) return goTo(Screen::Scores);
        if (entry == menu.size() - 1)
            ended = true;
        else
            change(entry, 1);
    }

    bool isRoundShown() const { return game && screen != Screen::Title && screen != Screen::Scores; }
    /// The lines of the footer, after those that the debug view adds.
    std::vector<FooterLine> linesBelow(std::vector<FooterLine> footer) const {
        if (!debug || !isRoundShown()) return footer;
        if (FooterLine own = game->debugFigures(); !own.empty()) footer.insert(footer.begin(), std::move(own));
        if (const World* world = game->world()) footer.insert(footer.begin(), figuresOf(*world));
        return footer;
    }
    /// The world that the debug view shows; null: none.
    const World* worldShown() const { return debug && isRoundShown() ? game->world() : nullptr; }

    /// Draws the round, or what stands still behind a menu.
    void drawGame(Canvas& canvas) const {
        const bool title = !isRoundShown();
        if (screen != Screen::Play) canvas.setBehind(title ? Behind::Title : Behind::Menu);
        if (screen != Screen::Play && screen != Screen::Title) canvas.setBetween(1);
        if (title) return show.draw(canvas);
        game->draw(canvas);
        if (!debug) return;
        canvas.layer(debugLayer);
        canvas.look(canvas.camera());
        game->drawDebug(canvas);
        if (const World* world = worldShown()) games::drawDebug(canvas, *world);
    }

    void change(int entry, int step) {
        const Option& option = options[static_cast<std::size_t>(entry - 1)];
        std::string& value = next.options[option.name];
        value = choiceBehind(option, value, step);
        menu.entry(entry).value = value;
    }
};

Session::Session(const GameInfo& info, const SessionSetup& setup) : state_(std::make_unique<State>(info, setup)) {}
Session::~Session() = default;

void Session::update(Buttons buttons) {
    state_->update(Input(state_->actions, buttons, state_->before));
    state_->before = buttons;
    ++state_->ticks;
    ++state_->since;
}

void Session::draw(Canvas& canvas, std::vector<FooterLine> footer) const {
    const double between = canvas.between();
    canvas.clear(state_->info.theme.background);
    drawFooter(canvas, state_->linesBelow(std::move(footer)), state_->info.theme);
    state_->drawGame(canvas);
    canvas.setBetween(between);
    canvas.layer(menuLayer);
    canvas.screen();
    drawScreen(canvas, {*this, state_->menu, state_->since, state_->rank});
}

std::vector<Buttons> Session::pressesAt(const Vec2& pixel, PixelSize size, std::vector<FooterLine> footer) const {
    if (screen() == Screen::Over && state_->since < overDelay) return {};
    Canvas canvas(size);
    drawFooter(canvas, state_->linesBelow(std::move(footer)), state_->info.theme);
    canvas.screen();
    const Aabb visible = canvas.visible();
    const Place place = screenPlace(visible);
    const Vec2 onScreen = visible.lower + pixel * canvas.unitsPerPixel();
    const Vec2 point = (onScreen - place.position) / place.scale.x(), top = menuTop(screen());
    Menu& menu = state_->menu;
    const int entry = menu.entryAt(point, top);
    if (entry < 0) return {};
    std::vector<Buttons> presses;
    // No button comes first: a button that is held already would not be pressed anew.
    const auto press = [&](std::string_view action) { presses.insert(presses.end(), {0, actions().button(action)}); };
    for (int at = menu.chosen(); at < entry; ++at) press("down");
    for (int at = menu.chosen(); at > entry; --at) press("up");
    const bool isOption = !menu.entry(entry).value.empty();
    press(!isOption ? "confirm" : point.x() < top.x() ? "left" : "right");
    presses.push_back(0);
    return presses;
}

std::vector<Cue> Session::takeCues() {
    return std::exchange(state_->cues, {});
}

Screen Session::screen() const {
    return state_->screen;
}
const ActionList& Session::actions() const {
    return state_->actions;
}
const GameInfo& Session::info() const {
    return state_->info;
}
std::int64_t Session::ticks() const {
    return state_->ticks;
}
bool Session::ended() const {
    return state_->ended;
}
int Session::rounds() const {
    return state_->rounds;
}
const GameSetup& Session::gameSetup() const {
    return state_->next;
}
const Game* Session::game() const {
    return state_->game.get();
}
Progress Session::progress() const {
    return state_->game ? state_->game->progress() : Progress{};
}

std::uint64_t Session::hash() const {
    Hash hash;
    hash.add(static_cast<int>(state_->screen)).add(state_->ticks).add(state_->rounds).add(state_->menu.chosen());
    if (state_->game) hash.add(state_->game->hash());
    return hash.value();
}

const std::vector<std::int64_t>& Session::scores() const {
    return state_->scores;
}
void Session::listKeys(int action, std::vector<Key> keys) {
    state_->info.actions.at(static_cast<std::size_t>(action)).keys = std::move(keys);
}
void Session::showDebug(bool shown) {
    state_->debug = shown;
}
bool Session::debugShown() const {
    return state_->debug;
}

}  // namespace plumb::games
