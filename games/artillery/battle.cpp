// SPDX-License-Identifier: MIT
#include <games/artillery/battle.h>

#include <algorithm>

#include <games/frame/game.h>
#include <plumb/record/state_hash.h>

namespace plumb::games::artillery {
namespace {

/// From the middle of the island outwards, for either crew [m].
constexpr std::array<double, 4> lots{9, 15, 21, 27};
constexpr double driest = 1.6;  ///< nobody is put lower than that above the sea [m]

}  // namespace

Battle::Battle(const BattleSetup& setup) : setup_(setup), random_(setup.seed), terrain_(random_) {
    openWorld();
    build(random_);
    first_ = random_.integer(0, 1);
    beginTurn();
}

Battle::Battle(const BattleSetup& setup, Terrain ground, const std::array<double, 2>& places)
    : setup_(setup), random_(setup.seed), terrain_(std::move(ground)) {
    openWorld();
    for (int crew = 0; crew < 2; ++crew) addGunner(crew, places[static_cast<std::size_t>(crew)], 0);
    beginTurn();
}

void Battle::openWorld() {
    world_ = World({.gravity = {0, -gravity}, .hitSpeed = 3});
    const BodyId earth = world_.add({.type = BodyType::Static, .shapes = {terrain_.shape()}});
    ground_ = world_.body(earth).shapes().front();
    air_ = world_.addField({.law = Drag{.linear = dragRate * shellMass}, .filter = {.category = Air, .mask = Shot}});
    water_ = world_.addField({.law = Pool{}, .filter = {.category = Sea, .mask = Thing | Person}});
    setSea(0);
    for (auto& crew : rounds_)
        for (std::size_t i = 0; i < weapons.size(); ++i) crew[i] = weapons[i].rounds;
}

/// Either crew has four lots: a tower with a gunner on it, something else that is built, and a gunner on each of the
/// other two, in any order. Something stands in the middle, if that is dry.
void Battle::build(Random& random) {
    const std::array<const Building*, 4> kinds{&wall, &powderStore, &gate, &pyramid};
    const auto any = [&] { return kinds[static_cast<std::size_t>(random.integer(0, 3))]; };
    for (int crew = 0; crew < 2; ++crew) {
        std::array<int, 4> uses{0, 1, 2, 3};
        for (int i = 3; i > 0; --i)
            std::swap(uses[static_cast<std::size_t>(i)], uses[static_cast<std::size_t>(random.integer(0, i))]);
        for (std::size_t i = 0; i < lots.size(); ++i) {
            const double x = (crew == 0 ? -1 : 1) * (lots[i] + random.uniform(-0.8, 0.8));
            if (uses[i] == 0) {
                buildAt(watchtower, x);
                addGunner(crew, x, watchtower.top);
            } else if (uses[i] == 1) {
                buildAt(*any(), x);
            } else {
                terrain_.flatten(x, 1, std::max(driest, terrain_.heightAt(x)));
                addGunner(crew, x, 0);
            }
        }
    }
    const double middle = random.uniform(-3, 3);
    if (terrain_.heightAt(middle) > driest) buildAt(*any(), middle);
    world_.set(ground_, terrain_.shape());
}

void Battle::buildAt(const Building& building, double x) {
    const double floor = std::max(driest, terrain_.heightAt(x));
    terrain_.flatten(x, building.halfWidth, floor);
    for (const Piece& piece : building.pieces)
        props_.push_back({world_.add(pieceDef(piece.kind, Vec2(x, floor) + piece.at)), piece.kind});
}

void Battle::addGunner(int crew, double x, double above) {
    const Vec2 middle(x, terrain_.heightAt(x) + above + gunnerHalf + 0.01);
    const int facing = crew == 0 ? 1 : -1;
    gunners_.push_back(
        {.body = world_.add(gunnerDef(middle)), .crew = crew, .aim = {.facing = facing}, .last = middle});
}

void Battle::setWind(double wind) {
    wind_ = wind;
    FieldDef air = world_.field(air_);
    std::get<Drag>(air.law).wind = {wind, 0};
    world_.set(air_, air);
}

void Battle::setSea(double level) {
    sea_ = level;
    FieldDef water = world_.field(water_);
    water.law = Pool{.fluid = {.density = 1, .surface = {0, level}, .gravity = {0, -gravity}}, .drag = 2};
    world_.set(water_, water);
}

Vec2 Battle::middleOf(const Gunner& gunner) const {
    return gunner.alive ? world_.body(gunner.body).position() : gunner.last;
}

int Battle::healthOf(int crew) const {
    int health = 0;
    for (const Gunner& gunner : gunners_)
        if (gunner.crew == crew) health += gunner.health;
    return health;
}

int Battle::roundsLeft(int crew, int weapon) const {
    const auto kind = static_cast<std::size_t>(weapon);
    return weapons[kind].rounds == 0 ? -1 : rounds_[static_cast<std::size_t>(crew)][kind];
}

Gunner* Battle::gunnerOf(BodyId body) {
    for (Gunner& gunner : gunners_)
        if (gunner.alive && gunner.body == body) return &gunner;
    return nullptr;
}

Forecast Battle::forecastOf(const Aim& aim, int weapon, int ticks) const {
    return forecast(world_, shellDef(middleOf(gunner()), aim, weapons[static_cast<std::size_t>(weapon)]), ticks,
                    tickSeconds);
}

void Battle::addTo(Hash& hash) const {
    Random next = random_;
    hash.add(stateHash(world_)).add(next.bits()).add(wind_).add(sea_);
    terrain_.addTo(hash);
    for (const Gunner& one : gunners_)
        hash.add(one.health)
            .add(one.alive)
            .add(one.aim.facing)
            .add(one.aim.elevation)
            .add(one.aim.charge)
            .add(one.weapon);
    for (const Prop& prop : props_) hash.add(prop.fuse).add(static_cast<int>(prop.kind));
    for (const auto& crew : rounds_)
        for (const int rounds : crew) hash.add(rounds);
    if (shell_) hash.add(shell_->weapon).add(shell_->age);
    for (const int number : {static_cast<int>(phase_), phaseTicks_, turn_, first_, active_, lastOfCrew_[0],
                             lastOfCrew_[1], aimHeld_, walkHeld_, walkLeft_, calm_, winner_})
        hash.add(number);
    hash.add(charging_).add(std::uint64_t{buttonsOf(before_)});
}

}  // namespace plumb::games::artillery
