// SPDX-License-Identifier: MIT
#include <games/maze/maze_game.h>

#include <algorithm>
#include <charconv>

#include <games/maze/art/palette.h>
#include <games/maze/art/scene.h>
#include <games/maze/sounds.h>
#include <plumb/math/check.h>

namespace plumb::games::maze {
namespace {

constexpr int extraLifeAt = 10'000;
constexpr int mostLevels = 1000;

/// The value of an option that is a whole number.
int numberIn(const GameSetup& setup, const std::string& name, int least) {
    const std::string& text = setup.option(name);
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || number < least || number > mostLevels)
        refuse("--" + name, "\"" + text + "\" is not a whole number from " + std::to_string(least) + " to " +
                                std::to_string(mostLevels));
    return number;
}

}  // namespace

MazeGame::MazeGame(const GameSetup& setup)
    : seed_(setup.seed),
      levelsToWin_(numberIn(setup, "levels", 0)),
      level_(numberIn(setup, "level", 1)),
      chase_(level_, seed_) {
    begin(Phase::Intro);
    keepTrail();
}

int MazeGame::ticksOf(Phase phase) {
    switch (phase) {
        case Phase::Intro: return 210;
        case Phase::Ready: return 110;
        case Phase::Caught: return 50;
        case Phase::Dying: return 90;
        case Phase::Cleared: return 150;
        case Phase::Play: break;
    }
    return 0;
}

void MazeGame::begin(Phase phase) {
    phase_ = phase;
    phaseTicks_ = 0;
    const Cues cues = phase == Phase::Intro     ? introTune()
                      : phase == Phase::Caught  ? caughtSound()
                      : phase == Phase::Cleared ? clearedSound()
                                                : Cues{};
    for (const Cue& cue : cues) play(cue);
}

void MazeGame::update(const Input& input) {
    const std::optional<Direction> wanted = steering_.update(input);
    keepTrail();
    ++ticks_;
    ++phaseTicks_;
    ++sinceExtraLife_;
    for (Trace& trace : traces_) ++trace.age;
    std::erase_if(traces_, [](const Trace& trace) { return trace.age > Trace::longest; });
    if (phase_ == Phase::Play)
        runChase(wanted);
    else if (phaseTicks_ >= ticksOf(phase_))
        endPhase();
}

void MazeGame::endPhase() {
    switch (phase_) {
        case Phase::Caught: return begin(Phase::Dying);
        case Phase::Dying: return nextLife();
        case Phase::Cleared: return nextLevel();
        default: return begin(Phase::Play);
    }
}

void MazeGame::nextLife() {
    if (--lives_ == 0) {
        progress_.outcome = Outcome::Lost;
        return;
    }
    chase_.beginLifeAfterDeath();
    keepTrail();
    begin(Phase::Ready);
}

void MazeGame::nextLevel() {
    if (++cleared_ == levelsToWin_) {
        progress_.outcome = Outcome::Won;
        return;
    }
    chase_ = Chase(++level_, seed_);
    keepTrail();
    begin(Phase::Ready);
}

void MazeGame::runChase(std::optional<Direction> wanted) {
    chase_.step(wanted);
    for (const ChaseEvent& event : chase_.events()) take(event);
    hum();
    if (chase_.cleared()) return begin(Phase::Cleared);
    if (chase_.playerCaught()) begin(Phase::Caught);
}

void MazeGame::take(const ChaseEvent& event) {
    Cues cues;
    switch (event.kind) {
        case Happening::Dot: cues = dotSound(dotsHeard_++); break;
        case Happening::Power: cues = powerSound(); break;
        case Happening::HunterCaught: cues = hunterSound(event.points); break;
        case Happening::Fruit:
            cues = fruitSound();
            fruitEaten_.push_back(chase_.rules().fruit.kind);
            break;
        default: break;
    }
    for (const Cue& cue : cues) play(cue);
    traces_.push_back({event});
    win(event);
}

void MazeGame::win(const ChaseEvent& event) {
    const std::int64_t before = progress_.score;
    progress_.score += event.points;
    if (before >= extraLifeAt || progress_.score < extraLifeAt) return;
    ++lives_;
    sinceExtraLife_ = 0;
    for (const Cue& cue : extraLifeSound()) play(cue);
}

void MazeGame::keepTrail() {
    trail_.player = chase_.playerPosition();
    for (const Who who : everyone) trail_.hunters[indexOf(who)] = chase_.hunter(who).position();
}

void MazeGame::hum() {
    if (chase_.frozen() || --humRest_ > 0) return;
    const bool fright = chase_.frightFrames() > 0;
    const double urgency = static_cast<double>(chase_.dotsEaten()) / (chase_.dotsEaten() + chase_.dotsLeft());
    for (const Cue& cue : maze::hum(urgency, fright)) play(cue);
    humRest_ = humTicks(urgency, fright);
}

void MazeGame::draw(Canvas& canvas) const {
    drawScene(canvas, *this);
}

void MazeGame::drawDebug(Canvas& canvas) const {
    drawPlans(canvas, chase_);
}

std::vector<std::string> MazeGame::debugFigures() const {
    const auto& hunters = chase_.hunters();
    const auto inLanes = std::count_if(hunters.begin(), hunters.end(), [](const Hunter& h) { return h.isInLanes(); });
    return {std::to_string(chase_.dotsLeft()) + " crumbs left",
            std::string(chase_.mode() == HunterMode::Chase ? "cats chase" : "cats rest in their corners"),
            std::to_string(inLanes) + " of 4 in the lanes",
            "fright: " + std::to_string(chase_.frightFrames() / framesPerSecond) + " s"};
}

std::string MazeGame::verdict() const {
    const std::optional<Who> catcher = chase_.catcher();
    return catcher ? std::string(lookOf(*catcher).name) + " got you" : "All crumbs!";
}

std::uint64_t MazeGame::hash() const {
    Hash hash;
    hash.add(level_).add(lives_).add(cleared_).add(progress_.score).add(static_cast<int>(progress_.outcome));
    hash.add(static_cast<int>(phase_)).add(phaseTicks_);
    steering_.addTo(hash);
    chase_.addTo(hash);
    return hash.value();
}

}  // namespace plumb::games::maze
