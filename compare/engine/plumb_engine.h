// SPDX-License-Identifier: MIT
// How is a scene run in Plumb itself?
#pragma once
#include <compare/engine/engine.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb::compare {

Engine plumbEngine(const SolverSettings& solver = {});

}  // namespace plumb::compare
