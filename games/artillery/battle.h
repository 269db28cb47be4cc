// SPDX-License-Identifier: MIT
// How does a battle of two crews on one island proceed, tick by tick?
#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <games/artillery/aim.h>
#include <games/artillery/happening.h>
#include <games/artillery/pieces.h>
#include <games/artillery/terrain.h>
#include <games/frame/action.h>
#include <plumb/dynamics/world.h>
#include <plumb/record/forecast.h>

namespace plumb::games::artillery {

/// Which buttons are held; the battle itself detects new presses.
struct Orders {
    bool left = false, right = false;  ///< face or walk in this direction
    bool up = false, down = false;     ///< turns the barrel
    bool fire = false;                 ///< charges while held, fires on release
    bool weapon = false;               ///< switches to the next weapon
    friend bool operator==(const Orders&, const Orders&) = default;
};

/// The bits of the game's actions, in this order.
inline Buttons buttonsOf(const Orders& orders) {
    Buttons buttons = 0;
    int bit = 0;
    for (const bool held : {orders.left, orders.right, orders.up, orders.down, orders.fire, orders.weapon})
        buttons |= Buttons{held} << bit++;
    return buttons;
}
inline Orders ordersOf(Buttons buttons) {
    const auto held = [buttons](int bit) { return ((buttons >> bit) & 1) != 0; };
    return {held(0), held(1), held(2), held(3), held(4), held(5)};
}

struct BattleSetup {
    std::uint64_t seed = 1;
    double wind = 10;   ///< highest speed, in either direction [m/s]
    int tideTurn = 16;  ///< from this turn on the sea rises
};

struct Gunner {
    BodyId body{};
    int crew = 0;  ///< 0: the left crew, 1: the right crew
    int health = fullHealth;
    bool alive = true;
    Aim aim{};
    int weapon = 0;
    int mark = 60;    ///< charge of the last shot
    Vec2 last{0, 0};  ///< last position; still valid after death [m]
};

struct Prop {
    BodyId body{};
    PieceKind kind = PieceKind::Crate;
    int fuse = -1;  ///< time until a lit keg explodes [ticks]; -1: not lit
    int crew = 0;   ///< the owner's crew, for a hat
};

struct Shell {
    BodyId body{};
    int weapon = 0;
    int age = 0;           ///< [ticks]
    bool falling = false;  ///< true once it has begun to fall
};

enum class Phase { Ready, Aim, Flight, Settle, Over };

/// The rules of the game. A plumb::World holds everything that moves: gunners, shells, crates. The wind and the sea are
/// fields of that world. This class draws nothing and plays no sound; it reports what happened in a tick as Happenings.
class Battle {
public:
    explicit Battle(const BattleSetup& setup);
    /// For tests: no buildings, and one gunner of each crew on this ground. places: the gunners' x [m].
    Battle(const BattleSetup& setup, Terrain ground, const std::array<double, 2>& places);

    void update(const Orders& orders);  ///< one tick; orders: of the crew whose turn it is
    std::vector<Happening> takeHappenings() { return std::exchange(happenings_, {}); }

    Phase phase() const { return phase_; }
    int phaseTicks() const { return phaseTicks_; }  ///< since the phase began
    int turn() const { return turn_; }              ///< counted from 1
    int crew() const { return turn_ % 2 == 1 ? first_ : 1 - first_; }
    const Gunner& gunner() const { return gunners_[static_cast<std::size_t>(active_)]; }  ///< of this turn
    int active() const { return active_; }
    bool charging() const { return charging_; }
    int walkLeft() const { return walkLeft_; }  ///< [ticks]
    int winner() const { return winner_; }      ///< valid in Phase::Over; -1: nobody is left
    double wind() const { return wind_; }       ///< positive towards +x [m/s]
    double sea() const { return sea_; }         ///< height of its surface [m]
    int tideTurn() const { return setup_.tideTurn; }
    int roundsLeft(int crew, int weapon) const;  ///< -1: unlimited
    const std::vector<Gunner>& gunners() const { return gunners_; }
    const std::vector<Prop>& props() const { return props_; }
    const std::optional<Shell>& shell() const { return shell_; }
    const Terrain& terrain() const { return terrain_; }
    const World& world() const { return world_; }
    Vec2 middleOf(const Gunner& gunner) const;
    int healthOf(int crew) const;

    /// Forecasts the shell that the current gunner would fire now with this aim. It equals the real flight to the last
    /// bit.
    Forecast forecastOf(const Aim& aim, int weapon, int ticks) const;
    /// How far the next tick of up or down turns the barrel, after the button was held for heldTicks [tenths of a
    /// degree].
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
