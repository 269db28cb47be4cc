// SPDX-License-Identifier: MIT
#include <games/artillery/battle.h>

#include <algorithm>

#include <games/frame/game.h>
#include <plumb/record/state_hash.h>

namespace plumb::games::artillery {
namespace {

/// Distances of each crew's building sites from the middle of the island [m].
constexpr std::array<double, 4> lots{9, 15.2, 21.4, 27.6};
constexpr double seaDensity = 3.7;  ///< [kg/m^2]
constexpr double driest = 1.6;      ///< least height of a site above the sea [m]

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

/// Each crew has four sites in random order: a tower with a gunner on it, another building, and two sites with only a
/// gunner. One more building stands in the middle if the ground there is dry.
void Battle::build(Random& random) {
    struct Site {
        const Building* building;
        int crew;  ///< of the gunner there; -1: no gunner
        Plot plot;
    };
    std::vector<Site> sites;
    const auto addSite = [&](const Building* building, int crew, double x) {
        const double halfWidth = building ? building->halfWidth : 1;
        sites.push_back({building, crew, {x, halfWidth, std::max(driest, terrain_.heightAt(x))}});
    };
    const std::array<const Building*, 4> kinds{&wall, &powderStore, &gate, &pyramid};
    const auto any = [&] { return kinds[static_cast<std::size_t>(random.integer(0, 3))]; };
    for (int crew = 0; crew < 2; ++crew) {
        std::array<std::size_t, 4> order{0, 1, 2, 3};
        for (std::size_t i = 3; i > 0; --i)
            std::swap(order[i], order[static_cast<std::size_t>(random.integer(0, int(i)))]);
        for (std::size_t i = 0; i < lots.size(); ++i) {
            const double x = (crew == 0 ? -1 : 1) * (lots[i] + random.uniform(-0.4, 0.4));
            addSite(order[i] == 0 ? &watchtower : order[i] == 1 ? any() : nullptr, order[i] == 1 ? -1 : crew, x);
        }
    }
    const double middle = random.uniform(-2.5, 2.5);
    if (terrain_.heightAt(middle) > driest) addSite(any(), -1, middle);
    std::vector<Plot> plots;
    for (const Site& site : sites) plots.push_back(site.plot);
    terrain_.level(plots);
    world_.shape(ground_).set(terrain_.shape());
    for (const Site& site : sites) {
        const Vec2 floor(site.plot.x, site.plot.height);
        if (site.building)
            for (const Piece& piece : site.building->pieces)
                props_.push_back({world_.add(pieceDef(piece.kind, floor + piece.at)), piece.kind});
        if (site.crew >= 0) addGunner(site.crew, floor.x(), site.building ? site.building->top : 0);
    }
}

void Battle::addGunner(int crew, double x, double above) {
    const Vec2 middle(x, terrain_.heightAt(x) + above + gunnerHalf + 0.01);
    const int facing = crew == 0 ? 1 : -1;
    gunners_.push_back(
        {.body = world_.add(gunnerDef(middle)), .crew = crew, .aim = {.facing = facing}, .last = middle});
}

void Battle::setWind(double wind) {
    wind_ = wind;
    FieldDef air = world_.field(air_).def();
    std::get<Drag>(air.law).wind = {wind, 0};
    world_.field(air_).set(air);
}

void Battle::setSea(double level) {
    sea_ = level;
    FieldDef water = world_.field(water_).def();
    water.law = Pool{.fluid = {.density = seaDensity, .surface = {0, level}, .gravity = {0, -gravity}}, .drag = 5};
    // The region ends a little above the surface: shapes above it need no check.
    water.region = boxPolygon({2 * worldEdge, 20}, {0, level + 1.5 - 20});
    world_.field(water_).set(water);
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
