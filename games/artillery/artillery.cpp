// SPDX-License-Identifier: MIT
#include <games/artillery/artillery.h>

#include <games/artillery/draw.h>
#include <games/artillery/happening.h>
#include <games/artillery/hud.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {
namespace {

int lineOf(const std::string& option) {
    return option == "full" ? fullLine : option == "short" ? shortLine : 0;
}

/// Plays every crew that a person with buttons would play.
class Computer final : public Player {
public:
    explicit Computer(const GameSetup& setup) {
        const Strength& strength = strengthOf(setup.option("strength"));
        for (const int crew : {0, 1}) commanders_.emplace_back(crew, strength, setup.seed * 2 + std::uint64_t(crew));
    }
    Buttons decide(const Game& game) override {
        const Match& match = static_cast<const Artillery&>(game).match();
        if (match.stage() != stage_) {
            stage_ = match.stage();
            for (Commander& commander : commanders_) commander.forget();
        }
        if (!match.isPersonsTurn()) return 0;
        return buttonsOf(commanders_[static_cast<std::size_t>(match.battle().crew())].decide(match.battle()));
    }

private:
    std::vector<Commander> commanders_;
    int stage_ = 0;
};

}  // namespace

Artillery::Artillery(const GameSetup& setup)
    : match_(setup.seed, setup.option("rival")), line_(lineOf(setup.option("line"))) {}

void Artillery::update(const Input& input) {
    ++ticks_;
    drift_ += match_.battle().wind() * tickSeconds;
    recoil_ *= 0.85;
    effects_.update();
    trail_.keep(match_.battle().world());
    if (still_ > 0) {
        --still_;
    } else {
        notice(match_.update(ordersOf(input.now())));
        if (const auto& shell = match_.battle().shell()) effects_.trail(world()->body(shell->body).position());
        traces_.update(match_.battle());
    }
    eye_.update(match_.battle());
    if (answer_.update(match_, (input.now() & ~input.before()) != 0)) play({Wave::Triangle, 240, 180, 0.09, 0.25});
    if (match_.battle().phase() == Phase::Over && match_.battle().phaseTicks() % 25 == 5) celebrate();
}

/// Fireworks over the island, in the winner's colour.
void Artillery::celebrate() {
    if (match_.battle().winner() < 0) return;
    const Vec2 at(sparks_.uniform(-24, 24), sparks_.uniform(20, 28));
    effects_.celebrate(at, crewColor(match_.battle().winner()));
    play({Wave::Noise, 2500, 400, 0.3, 0.25});
}

void Artillery::notice(const std::vector<Happening>& happenings) {
    int thuds = 0;
    for (const Happening& happening : happenings) {
        const bool isThud = happening.kind == Happening::Kind::Thud;
        if (!isThud || ++thuds <= 2)
            for (const Cue& cue : cuesOf(happening)) play(cue);
        effects_.begin(happening, paletteOf(match_.stage()));
        if (happening.kind == Happening::Kind::Exploded) {
            eye_.shake(happening.size / 5);
            eye_.lookAt(happening.at);
            still_ = static_cast<int>(happening.size);
        }
        if (happening.kind == Happening::Kind::Splashed) eye_.lookAt(happening.at);
        if (happening.kind == Happening::Kind::Fired) {
            eye_.shake(0.3);
            recoil_ = 1;
        }
    }
}

void Artillery::draw(Canvas& canvas) const {
    const Battle& battle = match_.battle();
    const Palette& palette = paletteOf(match_.stage());
    const double seconds = (static_cast<double>(ticks_) - 1 + canvas.between()) * tickSeconds;
    const Figures figures{battle, trail_, seconds, recoil_};
    const bool aiming = battle.phase() == Phase::Aim && match_.isPersonsTurn();
    canvas.screen();
    const Arrangement arrangement = arrangementIn(canvas.visible());
    const Camera camera = eye_.camera(canvas.between(), arrangement);
    drawBackdrop(canvas, camera, palette, seconds, drift_);
    canvas.look(camera);
    if (aiming) traces_.draw(canvas, battle.crew());
    drawEarth(canvas, battle.terrain(), palette);
    drawProps(canvas, figures);
    drawGunners(canvas, figures);
    drawShell(canvas, figures);
    drawSea(canvas, battle.sea(), palette, seconds);
    effects_.draw(canvas, battle.wind());
    if (aiming && line_ > 0) drawAimLine(canvas, battle, line_, seconds);
    drawTags(canvas, figures);
    effects_.drawLabels(canvas);
    canvas.layer(hudLayer);
    if (canvas.behind() != Behind::Title) drawWriting(canvas, arrangement, figures);
    canvas.look(camera);
}

void Artillery::drawWriting(Canvas& canvas, const Arrangement& arrangement, const Figures& figures) const {
    const Battle& battle = match_.battle();
    const Aabb seen = canvas.visible();
    if (battle.shell()) {
        const Vec2 at = trail_.pose(battle.world(), battle.shell()->body, canvas.between()).position;
        drawShellMark(canvas, battle, at, arrangement);
    }
    canvas.screen();
    if (arrangement.hasChart) drawChart(canvas, battle, paletteOf(match_.stage()), seen, arrangement.chartTop);
    const std::string stage(stages[static_cast<std::size_t>(match_.stage())].name);
    const std::string rivals = match_.rival() == "friend" ? "a friend" : "a " + match_.rival() + " crew";
    drawHud(canvas, {match_, stage, rivals, answer_.ticksLeft(), figures.seconds}, arrangement);
    // After the last battle the frame shows the result instead.
    if (battle.phase() == Phase::Over && match_.progress().outcome == Outcome::Running) drawEnd(canvas);
}

void Artillery::drawEnd(Canvas& canvas) const {
    const Battle& battle = match_.battle();
    const int winner = battle.winner();
    std::string line = winner == 1 && match_.rival() == "friend" ? "the island is theirs" : "the island is lost";
    if (winner == 0) line = "the island is yours";
    if (winner == 0 && !match_.isLast())
        line = "next: " + std::string(stages[static_cast<std::size_t>(match_.stage()) + 1].name);
    const std::string title =
        winner < 0 ? "Nobody is left" : "The " + std::string(crewNames[winner == 0 ? 0 : 1]) + " win";
    drawBanner(canvas, title, line, winner < 0 ? gold : crewColor(winner), match_.sinceOver() * tickSeconds);
}

std::string Artillery::verdict() const {
    const int winner = match_.battle().winner();
    if (winner < 0) return "Nobody is left";
    return "The " + std::string(crewNames[winner == 0 ? 0 : 1]) + " have won";
}

std::uint64_t Artillery::hash() const {
    Hash hash;
    match_.addTo(hash);
    hash.add(still_);
    return hash.value();
}

GameInfo info() {
    GameInfo game;
    game.title = "Artillery";
    game.about = "Two crews, one island, and the wind between them.";
    game.actions = {{"left", {Key::Left, Key::A}, {Pad::Left}, "face, walk"},
                    {"right", {Key::Right, Key::D}, {Pad::Right}, "face, walk"},
                    {"up", {Key::Up, Key::W}, {Pad::Up}, "barrel"},
                    {"down", {Key::Down, Key::S}, {Pad::Down}, "barrel"},
                    {"fire", {Key::Space}, {Pad::South}, "hold and let go: fire"},
                    {"weapon", {Key::Tab, Key::Q}, {Pad::West}, "weapon"}};
    game.options = {{"rival",
                     "Who plays the other crew; weak-to-strong: three islands, each with a stronger crew",
                     "weak-to-strong",
                     {"weak-to-strong", "weak", "fair", "strong", "friend"},
                     "Rival"},
                    {"line", "How much of the aim line is shown", "short", {"short", "full", "off"}, "Aim line"},
                    {"strength",
                     "How well --player computer aims",
                     "strong",
                     {"weak", "fair", "strong"},
                     {},
                     /* inTitle */ false}};
    game.theme = {.background = Color::hex(0x241a3a),
                  .panel = Color::hex(0x3b2a55),
                  .text = paper,
                  .quiet = Color::hex(0xc9b8d0),
                  .accent = gold};
    game.fillsUpright = true;
    game.make = [](const GameSetup& setup) { return std::make_unique<Artillery>(setup); };
    game.computer = [](const GameSetup& setup) { return std::make_unique<Computer>(setup); };
    return game;
}

}  // namespace plumb::games::artillery
