// SPDX-License-Identifier: MIT
// What does an engine have to offer to be compared?
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

struct BodyState {
    Vec2 position{0, 0};         ///< of the body's origin [m]
    double angle = 0;            ///< counted on through whole turns [rad]
    Vec2 velocity{0, 0};         ///< of the centre of mass [m/s]
    double angularVelocity = 0;  ///< [rad/s]
    bool present = true;         ///< false before it appears; then the rest says where it will
};

/// By place in the scene, whether a joint has broken; one that is not in the list has not.
using Broken = std::vector<bool>;

/// A part of a step.
struct Phase {
    std::string name;    ///< "pairs", "solve"
    double seconds = 0;  ///< [s]
};

/// One scene in one engine. Bodies and probes are in the scene's order.
class Simulation {
public:
    virtual ~Simulation() = default;
    /// Moves on by dt > 0 [s], in a scene's run by the same in every step. Does nothing beside the engine's own step
    /// that costs time in it: this is what is timed.
    virtual void step(double dt) = 0;
    /// An engine that keeps no count of turns counts them here, so angles are counted on when this is called after
    /// every step.
    virtual std::vector<BodyState> states() const = 0;
    /// Where the time of the last step went, as the engine tells it; phases that do not overlap.
    virtual std::vector<Phase> phases() const { return {}; }
    /// The value of each of the scene's probes now: forces as means over the last step, and what sensors have counted
    /// since the start. NaN where the engine cannot say, and of forces before the first step. What can be read from the
    /// states is NaN here.
    virtual std::vector<double> probeValues() const = 0;
    /// The state the world is in, as one number; none from an engine that has no such hash.
    virtual std::optional<std::uint64_t> stateHash() const { return {}; }
    /// Which joints have broken so far.
    virtual Broken brokenJoints() const { return {}; }
};

/// A name and a value, as the report lists them: "sub-steps", "4".
using Setting = std::pair<std::string, std::string>;

/// What part has an engine in the comparison?
enum class Role {
    Subject,  ///< whom it is about: checks bind it, and the others are held against it
    Peer,     ///< judged beside it: both have to agree, and the subject has to be as exact as the best peer
    Guest,    ///< shown beside them, never judged
    Truth,    ///< a formula: errors are distances from it
};

/// How is an engine told from the others? By colour, and also by its stroke, for those who see colours differently.
struct Look {
    std::string onLight = "#8a4f9e", onDark = "#cf9be0";  ///< colours on a light and on a dark page
    std::vector<double> dash{6, 3, 1, 3};  ///< lengths of strokes and gaps in turn; empty: one stroke [px]
    double width = 2;                      ///< [px]
    bool filled = false;                   ///< its bodies are
    bool ghost = false;                    ///< only its outlines are drawn, with a cross at the origin
};

/// What others know of an engine. Nothing outside of this folder names one.
struct EngineCard {
    std::string name;     ///< on the command line and in files: lower case, with its major version
    std::string version;  ///< in full: "2.4.1"
    std::string label;    ///< as a person calls it, without the last digits of the version
    std::string product;  ///< its name alone; with the version it heads the column of a page's table
    Role role = Role::Guest;
    Look look;
    bool isRival = false;         ///< tables of speed hold the subject against this one
    std::string missing;          ///< how to get it, where this build does not have it; empty where each build has it
    bool oneSidedChains = false;  ///< its chains are solid on the right of their direction only
};

/// A number of an engine's own, which a scene may set for it.
struct EngineNumber {
    std::string name;
    double byDefault = 0;
    double least = 0, most = 0;  ///< what it may be
};

struct BenchScene;

struct Engine : EngineCard {
    /// The numbers that matter, as this scene is run.
    std::function<std::vector<Setting>(const Scene&)> settings;
    /// Throws Unsupported when the engine has no counterpart for something in the scene. Empty where this build does
    /// not have the engine.
    std::function<std::unique_ptr<Simulation>(const Scene&)> build;
    /// The same with every body that moves at the start flagged as a bullet; empty where there is no such flag.
    std::function<Engine()> withBullets{};
    /// The same with one sub-step a step; empty where it has no sub-steps.
    std::function<Engine()> withOneSubStep{};
    /// Its own numbers: "subSteps".
    std::vector<EngineNumber> numbers{};
    /// Why it is not waited for in a scene that measures speed; empty where it is.
    std::function<std::string(const BenchScene&)> leavesOut{};
    /// What its user does from outside, where the scene has what the engine has not. A sentence each.
    std::function<std::vector<std::string>(const Scene&)> notes{};
};

struct Unsupported : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Every engine that can be in a build, in the order in which they are shown.
const std::vector<Engine>& knownEngines();
/// Those of this build.
const std::vector<Engine>& engines();

/// The known engine of a name; null when there is none.
const Engine* findKnown(std::string_view name);
/// The name of the one that the comparison is about, and of the one that tables of speed hold it against.
const std::string& subjectName();
const std::string& rivalName();
/// The head of its column in a page's table, from a name and a version: the product, and the version of all but the
/// subject. The name itself where it is not known.
std::string columnName(const std::string& name, const std::string& version);

}  // namespace plumb::compare
