// SPDX-License-Identifier: MIT
// What does a page ask of a scene that runs while somebody looks at it?
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/engine/engine.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {

/// One scene, its settings, and a run of it in each engine. The runs go on together, tick by tick.
class Live {
public:
    /// Throws std::invalid_argument, as validate does.
    explicit Live(Scene scene);

    /// The scene with all that was set.
    const Scene& scene() const { return scene_; }
    /// The same to be kept: if something was set, without checks of what its author worked out for the scene as it was.
    Scene sceneToKeep() const;
    /// What was set, as "dt = 1/120", in the order in which it was set.
    std::vector<std::string> changed() const;
    /// Sets one field, as withField does; an earlier value of the same field is forgotten. Throws std::invalid_argument
    /// and changes nothing if the scene is then not valid.
    void set(const FieldSetting& setting);
    /// The scene as it was.
    void reset();

    /// A track that somebody brings is shown beside the engines from the next start on. Throws std::invalid_argument if
    /// it is not one of this scene, and as ownTrackFrom does.
    void bring(std::string_view csv, const std::string& file);
    /// Begins the runs anew, with engines of these names; all of this build if there are none. Nobody pulls any more.
    void start(std::vector<std::string> engines = {});
    /// Goes on until all runs have this tick or are over, or the time is used up; at least one tick if there is one.
    /// Infinite time: until the end [ms].
    void advance(std::size_t tick, double milliseconds);
    /// The last tick that all runs have; that of the end for those that are over.
    std::size_t tick() const;
    bool isOver() const;
    std::size_t lastTick() const { return static_cast<std::size_t>(stepCount(scene_)); }

    std::size_t runCount() const { return runs_.size(); }
    /// Not after resultOfRuns.
    const Observation& seen(std::size_t run) const { return runs_.at(run).seen(); }
    /// The forces at a tick; none at the start, nor in scenes of more than 100 bodies.
    const std::vector<Push>& pushes(std::size_t run, std::size_t tick) const;

    /// From the step after this tick on the hand pulls in all engines, or without one nobody does. What the runs did
    /// later is forgotten: they are made again, with all earlier pulls.
    void hold(std::size_t tick, const std::optional<Hand>& hand);
    /// Somebody has pulled since the start: the runs are no longer those of the scene alone.
    bool wasHeld() const { return !pulls_.empty(); }

    /// Measures and judges the runs, which must be over, and ends them. inDetail: as RunOptions says.
    SceneResult resultOfRuns(bool inDetail);

private:
    struct Pull {
        std::size_t tick;
        std::optional<Hand> hand;
    };
    void begin();
    std::vector<Engine> wanted() const;
    void stepTo(std::size_t tick);

    Scene original_, scene_;
    std::vector<FieldSetting> settings_{};
    std::vector<std::string> engines_{};
    std::vector<Run> runs_{};
    std::vector<std::vector<std::vector<Push>>> pushes_{};  // [run][tick]
    std::optional<Engine> brought_{};                       // made of a track
    std::vector<Pull> pulls_{};                             // by tick
    std::size_t tick_ = 0;
};

}  // namespace plumb::compare
