// SPDX-License-Identifier: MIT
// What goes on between two crews on one island, tick by tick?
#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <games/artillery/aim.h>
#include <games/artillery/happening.h>
#include <games/artillery/orders.h>
#include <games/artillery/pieces.h>
#include <games/artillery/terrain.h>
#include <plumb/dynamics/world.h>
#include <plumb/record/forecast.h>

namespace plumb::games::artillery {

struct BattleSetup {
    std::uint64_t seed = 1;
    double wind = 10;   ///< at most, either way [m/s]
    int tideTurn = 16;  ///< from this turn on the sea rises
};

struct Gunner {
    BodyId body{};
    int crew = 0;  ///< 0: the left one; 1
    int health = fullHealth;
    bool alive = true;
    Aim aim{};
    int weapon = 0;
    int mark = 60;    ///< the charge of their last shot
    Vec2 last{0, 0};  ///< where they were seen last [m]
};

struct Prop {
    BodyId body{};
    PieceKind kind = PieceKind::Crate;
    int fuse = -1;  ///< of a keg that was set off: until it blows up [ticks]; -1: not set off
    int crew = 0;   ///< of a hat: whose
};

struct Shell {
    BodyId body{};
    int weapon = 0;
    int age = 0;           ///< [ticks]
    bool falling = false;  ///< has been, once
};

enum class Phase { Ready, Aim, Flight, Settle, Over };

/// The rules, over a plumb::World that holds all that moves: gunners, shells, crates. Wind is a field of the world, and
/// so is the sea. Draws nothing and hears nothing; what happened in a tick is told as Happenings.
class Battle {
public:
    explicit Battle(const BattleSetup& setup);
    /// On level ground, nothing built: a gunner each at these places, which are on the ground. For trials.
    Battle(const BattleSetup& setup, Terrain ground, const std::array<double, 2>& places);

    void update(const Orders& orders);  ///< one tick; the orders are those of the crew whose turn it is
    std::vector<Happening> takeHappenings() { return std::exchange(happenings_, {}); }

    Phase phase() const { return phase_; }
    int phaseTicks() const { return phaseTicks_; }  ///< since it began
    int turn() const { return turn_; }              ///< counted from 1
    int crew() const { return turn_ % 2 == 1 ? first_ : 1 - first_; }
    const Gunner& gunner() const { return gunners_[static_cast<std::size_t>(active_)]; }  ///< whose turn it is
    int active() const { return active_; }
    bool charging() const { return charging_; }
    int walkLeft() const { return walkLeft_; }  ///< [ticks]
    int winner() const { return winner_; }      ///< when over; -1: nobody is left
    double wind() const { return wind_; }       ///< to +x [m/s]
    double sea() const { return sea_; }         ///< its level [m]
    int tideTurn() const { return setup_.tideTurn; }
    int roundsLeft(int crew, int weapon) const;  ///< -1: as many as it likes
    const std::vector<Gunner>& gunners() const { return gunners_; }
    const std::vector<Prop>& props() const { return props_; }
    const std::optional<Shell>& shell() const { return shell_; }
    const Terrain& terrain() const { return terrain_; }
    const World& world() const { return world_; }
    Vec2 middleOf(const Gunner& gunner) const;
    int healthOf(int crew) const;

    /// Of the shell that the gunner in turn would fire now with that aim: to the last bit where it will be.
    Forecast forecastOf(const Aim& aim, int weapon, int ticks) const;
    /// How far holding up or down turns the barrel after it was held for so many ticks [tenths of a degree].
    static int aimStep(int heldTicks) { return heldTicks < 10 ? 1 : heldTicks < 30 ? 4 : 9; }

    void addTo(Hash& hash) const;

private:
    void openWorld();
    void build(Random& random);
    void addGunner(int crew, double x, double above);
    void beginTurn();
    void enter(Phase phase);
    void obey(const Orders& orders);
    void turnBarrel(Gunner& gunner, const Orders& orders);
    void walk(Gunner& gunner, const Orders& orders);
    void changeWeapon(Gunner& gunner);
    void fire();
    bool isCalm() const;
    void endTurn();

    void flyShell();
    void blast(const Vec2& center, const Weapon& weapon);
    void hurt(Gunner& gunner, int damage);
    void burnKegs();
    void feelHits();
    void meetTheSea();
    void buryTheDead();
    void clearAway();
    void tell(const Happening& happening) { happenings_.push_back(happening); }
    Gunner* gunnerOf(BodyId body);
    void setWind(double wind);
    void setSea(double level);

    BattleSetup setup_;
    Random random_;
    Terrain terrain_;
    World world_;
    ShapeId ground_;
    FieldId air_, water_;
    std::vector<Gunner> gunners_;
    std::vector<Prop> props_;
    std::optional<Shell> shell_;
    std::array<std::array<int, weapons.size()>, 2> rounds_{};
    Phase phase_ = Phase::Ready;
    int phaseTicks_ = 0, turn_ = 0, first_ = 0, active_ = 0;
    std::array<int, 2> lastOfCrew_{-1, -1};
    int aimHeld_ = 0, walkHeld_ = 0, walkLeft_ = 0, calm_ = 0, winner_ = -1;
    bool charging_ = false;
    double wind_ = 0, sea_ = 0;
    Orders before_;
    std::vector<Happening> happenings_;
};

}  // namespace plumb::games::artillery
