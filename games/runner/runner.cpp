// SPDX-License-Identifier: MIT
#include <games/runner/runner.h>

#include <algorithm>

#include <games/frame/canvas.h>
#include <games/runner/buttons.h>
#include <games/runner/draw.h>
#include <games/runner/event.h>
#include <games/runner/level_text.h>
#include <games/runner/levels.h>

namespace plumb::games::runner {
namespace {

constexpr int introTicks = 110, dyingTicks = 80, clearedTicks = 210;
constexpr int leastCardTicks = 20;  ///< a card stays for this time before a button leads on
constexpr int coinPoints = 100, sunPoints = 1000, stompPoints = 200, secondPoints = 50, lifePoints = 500;
constexpr int coinsForLife = 50;

std::vector<std::shared_ptr<const Level>> levelsOf(const GameSetup& setup) {
    const std::string& file = setup.option("level");
    if (!file.empty()) return {std::make_shared<const Level>(levelIn(file))};
    std::vector<std::shared_ptr<const Level>> levels;
    for (const LevelText& level : builtInLevels())
        levels.push_back(std::make_shared<const Level>(readLevel(level.text, level.file)));
    return levels;
}

}  // namespace

Runner::Runner(const GameSetup& setup) : setup_(setup), levels_(levelsOf(setup)) {
    const std::string& from = setup.option("from");
    if (levels_.size() > 1) number_ = std::min(levels_.size(), static_cast<std::size_t>(from.front() - '0')) - 1;
    beginLevel();
}

void Runner::enter(Part part) {
    part_ = part;
    partTicks_ = 0;
}

void Runner::beginLevel() {
    const StageSetup setup{setup_.option("profile"), setup_.seed * 16 + number_};
    stage_ = std::make_unique<Stage>(levels_[number_], setup);
    suns_.clear();
    for (const Treasure& treasure : stage_->treasures())
        if (treasure.kind == ThingKind::Sun) suns_.push_back(false);
    levelTicks_ = 0;
    effects_.clear();
    view_.reset(*stage_);
    trail_.keep(stage_->world());
    enter(Part::Intro);
}

void Runner::update(const Input& input) {
    ++partTicks_;
    const bool leadsOn = input.pressed("jump") && partTicks_ > leastCardTicks;
    trail_.keep(stage_->world());
    switch (part_) {
        case Part::Intro:
            if (leadsOn || partTicks_ >= introTicks) enter(Part::Play);
            break;
        case Part::Play: updatePlay(input); break;
        case Part::Dying:
            if (partTicks_ >= dyingTicks) goOn();
            break;
        case Part::Cleared:
            if (leadsOn || partTicks_ >= clearedTicks) goOn();
            break;
    }
    view_.update(*stage_);
    effects_.update();
}

void Runner::updatePlay(const Input& input) {
    ++levelTicks_;
    stage_->update(platformInput(input.now()));
    const std::vector<Event> events = stage_->events();
    for (const Event& event : events) hear(event);
    const Vec2 velocity = stage_->hero().mover.slide().velocity;
    if (levelTicks_ % 5 == 0) effects_.trail(stage_->heroAt() + Vec2(0, 0.75), 0.2 * velocity, Color::hex(0xffb03a));
    if (stage_->isFinished())
        clear();
    else if (stage_->isOver())
        enter(Part::Dying);
}

void Runner::hear(const Event& event) {
    for (const Cue& cue : soundsOf(event)) play(cue);
    effects_.hear(event, paletteOf(stage_->level().sky));
    view_.hear(event);
    const auto points = [&](std::int64_t gained, const Color& color) {
        progress_.score += gained;
        effects_.say(event.at + Vec2(0, 0.8), std::to_string(gained), color);
    };
    const Color plain = Color::hex(0xffffff), gold = Color::hex(0xffd24a);
    switch (event.kind) {
        case EventKind::Coin: return takeCoins(1);
        case EventKind::Sun: suns_[static_cast<std::size_t>(event.strength)] = true; return points(sunPoints, gold);
        case EventKind::LampLit: return takeCoins(static_cast<int>(event.strength));
        case EventKind::Stomped: return points(stompPoints * static_cast<int>(event.strength), plain);
        case EventKind::Squashed: return points(2 * stompPoints, plain);
        case EventKind::LanternLit: effects_.say(event.at + Vec2(0, 2), "lit!", gold); return;
        default: return;
    }
}

void Runner::takeCoins(int coins) {
    progress_.score += coins * coinPoints;
    coins_ += coins;
    if (coins_ < coinsForLife) return;
    coins_ -= coinsForLife;
    ++lives_;
    effects_.say(stage_->heroAt() + Vec2(0, 1.4), "one more life", Color::hex(0xff9a4a));
}

void Runner::clear() {
    const double left = stage_->level().par - static_cast<double>(levelTicks_) * tickSeconds;
    timeBonus_ = std::max(0, static_cast<int>(left)) * secondPoints;
    const bool allSuns =
        !suns_.empty() && std::count(suns_.begin(), suns_.end(), true) == static_cast<std::ptrdiff_t>(suns_.size());
    sunBonus_ = allSuns ? 2 * sunPoints : 0;
    progress_.score += timeBonus_ + sunBonus_;
    enter(Part::Cleared);
}

void Runner::goOn() {
    if (part_ == Part::Cleared) {
        if (++number_ < levels_.size()) return beginLevel();
        --number_;
        progress_.score += lives_ * lifePoints;
        progress_.outcome = Outcome::Won;
        return;
    }
    if (--lives_ <= 0) {
        progress_.outcome = Outcome::Lost;
        return;
    }
    stage_->beginAgain();
    view_.reset(*stage_);
    effects_.clear();
    trail_.keep(stage_->world());
    enter(Part::Play);
}

void Runner::draw(Canvas& canvas) const {
    const double between = canvas.between();
    const double time = (view_.ticks() - 1 + between) * tickSeconds;
    canvas.screen();
    const Camera camera = view_.cameraIn(canvas.visible(), between);
    const Scene scene{*stage_, trail_, view_, paletteOf(stage_->level().sky), time, between, camera};
    drawBackdrop(canvas, scene);
    canvas.look(camera);
    drawPlaces(canvas, scene);
    drawLifts(canvas, scene);
    drawTiles(canvas, scene);
    drawCrates(canvas, scene);
    drawTreasures(canvas, scene);
    drawFoes(canvas, scene);
    drawHero(canvas, scene);
    drawWater(canvas, scene);
    drawNight(canvas, scene);
    drawLights(canvas, scene);
    effects_.draw(canvas);
    if (canvas.behind() == Behind::Nothing) drawCurtain(canvas, scene.at(stage_->hero().mover.body()));
    canvas.layer(hudLayer);
    if (canvas.behind() != Behind::Title)
        drawHud(canvas,
                {progress_.score, coins_, lives_, levelNumber() + 1, static_cast<double>(levelTicks_) * tickSeconds,
                 suns_, setup_.option("profile") == "1985" ? "1985" : "modern"});
    if (canvas.behind() == Behind::Nothing) drawCards(canvas);
    // The debug view is drawn with the last camera.
    canvas.look(camera);
}

void Runner::drawCurtain(Canvas& canvas, const Vec2& hero) const {
    const double since = partTicks_;
    if (part_ == Part::Dying) drawIris(canvas, hero, 1 - (since - 20) / (dyingTicks - 24));
    if (part_ == Part::Cleared) drawIris(canvas, hero, (clearedTicks - since) / 30);
    if (part_ == Part::Play && stage_->ticks() < 30)
        drawIris(canvas, hero, static_cast<double>(stage_->ticks() + 1) / 30);
    if (part_ == Part::Intro) drawIris(canvas, hero, 0.3);
}

void Runner::drawCards(Canvas& canvas) const {
    const double share = std::min(1.0, partTicks_ / 14.0);
    if (part_ == Part::Intro)
        drawCard(canvas, {stage_->level().name, {"Level " + std::to_string(levelNumber() + 1) + ": light the beacon"}},
                 share);
    if (part_ == Part::Cleared) {
        std::vector<std::string> lines{"Time " + std::to_string(levelTicks_ / 60) + " s      bonus " +
                                       std::to_string(timeBonus_)};
        if (sunBonus_ > 0) lines.push_back("All suns      bonus " + std::to_string(sunBonus_));
        drawCard(canvas, {"The beacon burns", lines}, share);
    }
}

std::uint64_t Runner::hash() const {
    Hash hash;
    hash.add(static_cast<int>(number_)).add(static_cast<int>(part_)).add(partTicks_).add(progress_.score);
    hash.add(static_cast<int>(progress_.outcome)).add(lives_).add(coins_).add(levelTicks_);
    for (const bool sun : suns_) hash.add(sun);
    return hash.add(stage_->hash()).value();
}

}  // namespace plumb::games::runner
