// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_engine.h>
#include <compare/engine/box2d3/box2d3_engine.h>
#include <compare/engine/chipmunk/chipmunk_engine.h>
#include <compare/engine/closed_form_engine.h>
#include <compare/engine/engine.h>
#include <compare/engine/engine_settings.h>
#include <compare/engine/plumb_engine.h>

#include <algorithm>
#include <iterator>

namespace plumb::compare {

const std::vector<Engine>& knownEngines() {
    static const std::vector<Engine> list = [] {
        std::vector<Engine> all{
            plumbEngine(), box2d24Engine(), box2d3Engine(), chipmunkEngine(), closedFormEngine(),
        };
        for (Engine& engine : all) engine = takingSettings(std::move(engine));
        return all;
    }();
    return list;
}

const std::vector<Engine>& engines() {
    static const std::vector<Engine> list = [] {
        std::vector<Engine> found;
        std::ranges::copy_if(knownEngines(), std::back_inserter(found), [](const Engine& e) { return bool(e.build); });
        return found;
    }();
    return list;
}

const Engine* findKnown(std::string_view name) {
    const auto found = std::ranges::find(knownEngines(), name, &Engine::name);
    return found == knownEngines().end() ? nullptr : &*found;
}

const std::string& subjectName() {
    return std::ranges::find(knownEngines(), Role::Subject, &Engine::role)->name;
}

const std::string& rivalName() {
    return std::ranges::find(knownEngines(), true, &Engine::isRival)->name;
}

std::string columnName(const std::string& name, const std::string& version) {
    const Engine* engine = findKnown(name);
    if (!engine) return name;
    return engine->role == Role::Subject ? engine->product : engine->product + " " + version;
}

}  // namespace plumb::compare
