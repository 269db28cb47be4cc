// SPDX-License-Identifier: MIT
// What must an engine provide to be compared?
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <compare/scene/scene.h>
#include <compare/scene/state.h>

namespace plumb::compare {

/// A part of a step.
struct Phase {
    std::string name;    ///< "pairs", "solve"
    double seconds = 0;  ///< [s]
};

/// What exerts a force on a body?
enum class Cause { Normal, Friction, Joint };

/// A mean force on a body over the last step. Weight is not among them, nor what fields do: the scene says both.
struct Push {
    Cause cause = Cause::Normal;
    std::size_t body = 0;   ///< on which it acts
    std::size_t other = 0;  ///< the body, or for a joint the joint, that exerts it
    Vec2 at{0, 0};          ///< in the world [m]
    Vec2 force{0, 0};       ///< [N]
};

/// Where energy came from and went to, in the order in which an engine tells it.
inline constexpr std::array energyCauses{"forces",  "drivers", "motors",   "friction",
                                         "impacts", "damping", "breaking", "solver"};

/// Somebody pulls at a body, as with a damped spring of 5 Hz.
struct Hand {
    std::size_t body = 0;
    Vec2 grip{0, 0};    ///< in the body's frame [m]
    Vec2 target{0, 0};  ///< to which the grip is pulled, in the world [m]
};

/// One scene in one engine. Bodies and probes are in the scene's order.
class Simulation {
public:
    virtual ~Simulation() = default;
    /// Moves on by dt > 0 [s]; in a scene's run, dt is the same in every step. It does nothing that costs time except
    /// the engine's own step, because this function is timed.
    virtual void step(double dt) = 0;
    /// If an engine does not count turns, they are counted here. So angles are only right if this is called after every
    /// step.
    virtual std::vector<BodyState> states() const = 0;
    /// The time of each part of the last step, as the engine reports it. Phases do not overlap.
    virtual std::vector<Phase> phases() const { return {}; }
    /// The value of each of the scene's probes now: forces as means over the last step, and what sensors have counted
    /// since the start. NaN if the engine does not know the value, and for forces before the first step. Values that
    /// can be computed from the states are also NaN here.
    virtual std::vector<double> probeValues() const = 0;
    /// The state of the world as one number; empty if the engine has no such hash.
    virtual std::optional<std::uint64_t> stateHash() const { return {}; }
    /// Which joints have broken so far.
    virtual Broken brokenJoints() const { return {}; }
    /// The forces of the last step at contacts and joints; empty if the engine does not tell.
    virtual std::vector<Push> pushes() const { return {}; }
    /// The energy that came in (positive) or went out since the start, by each of energyCauses [J]; empty if the engine
    /// does not account for it.
    virtual std::vector<double> energyByCause() const { return {}; }
    /// From now on the hand pulls; without one, nothing does. An engine that cannot be touched ignores it.
    virtual void hold(const std::optional<Hand>&) {}
};

/// A name and a value, as listed in the report: "sub-steps", "4".
using Setting = std::pair<std::string, std::string>;

/// Which role does an engine have in the comparison?
enum class Role {
    Subject,  ///< the engine under test: checks apply to it, and the others are compared with it
    Peer,     ///< also judged: it must agree with the subject, and the subject must be as exact as the best peer
    Guest,    ///< also shown, but never judged
    Truth,    ///< a formula: errors are distances from it
};

/// How is an engine distinguished from the others? By its colour, and by its stroke for people who see colours
/// differently.
struct Look {
    std::string onLight = "#8a4f9e", onDark = "#cf9be0";  ///< its colour on a light and on a dark page
    std::vector<double> dash{6, 3, 1, 3};  ///< lengths of strokes and gaps in turn; empty: a solid line [px]
    double width = 2;                      ///< [px]
    bool filled = false;                   ///< true if its bodies are filled
    bool ghost = false;                    ///< only its outlines are drawn, with a cross at the origin
};

/// What other code knows about an engine. No code outside of this folder names an engine.
struct EngineCard {
    std::string name;     ///< on the command line and in files: lower case, with its major version
    std::string version;  ///< in full: "2.4.1"
    std::string label;    ///< the name for people, without the last digits of the version
    std::string product;  ///< its name alone; name and version are the head of its column in a page's table
    Role role = Role::Guest;
    Look look;
    bool isRival = false;         ///< tables of speed compare the subject with this engine
    std::string missing;          ///< how to get it, if this build does not have it; empty if each build has it
    bool onDemand = false;        ///< it runs only if it is named
    bool oneSidedChains = false;  ///< its chains are solid on the right of their direction only
    /// It may leave out bodies and times: their states are not numbers, and nobody has to know them.
    bool isPartial = false;
};

/// An engine's own number, which a scene may set.
struct EngineNumber {
    std::string name;
    double byDefault = 0;
    double least = 0, most = 0;  ///< the range of allowed values
};

struct BenchScene;

struct Engine : EngineCard {
    /// The important numbers with which this scene is run.
    std::function<std::vector<Setting>(const Scene&)> settings;
    /// Throws Unsupported if the engine lacks something that is in the scene. Empty if this build does not have the
    /// engine.
    std::function<std::unique_ptr<Simulation>(const Scene&)> build;
    /// The same engine, with every body that moves at the start flagged as a bullet; empty if there is no such flag.
    std::function<Engine()> withBullets{};
    /// The same engine with one sub-step a step; empty if it has no sub-steps.
    std::function<Engine()> withOneSubStep{};
    /// Its own numbers: "subSteps".
    std::vector<EngineNumber> numbers{};
    /// Why the engine is not run in a scene that measures speed; an empty text if it is run.
    std::function<std::string(const BenchScene&)> leavesOut{};
    /// What the engine's user has to do from outside, if the scene has something that the engine lacks. One sentence
    /// for each.
    std::function<std::vector<std::string>(const Scene&)> notes{};
};

/// All engines that can be in a build, in the order in which they are shown.
const std::vector<Engine>& knownEngines();
/// The engines of this build that run if none is named.
const std::vector<Engine>& engines();
/// The same, and those of these names that run only if they are named.
std::vector<Engine> enginesWith(const std::vector<std::string>& names);

/// The known engine with this name, or what is known of the one that shows a track of the user; null if there is none.
const Engine* findKnown(std::string_view name);
/// The name of the engine under test, and of the engine with which tables of speed compare it.
const std::string& subjectName();
const std::string& rivalName();
/// The head of an engine's column in a page's table: its product, and its version, except for the subject. If the
/// engine is not known, its name.
std::string columnName(const std::string& name, const std::string& version);

/// Throws std::invalid_argument for an unknown engine; it names the field, the name, and the nearest known name. An
/// engine is known even if this build does not have it.
void validateEngineNames(const Scene& scene);

}  // namespace plumb::compare
