// SPDX-License-Identifier: MIT
// What is each scene that measures speed?
// The six large ones, junkyard, compounds, washer and rain are Box2D 3.2's own benchmarks (Erin Catto, MIT licence).
// They use the same numbers (sizes, places, materials and steps), but none of its code.
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

// pyramids.cpp
Scene largePyramid();   ///< 100 rows on a floor: 5,051 bodies
Scene manyPyramids();   ///< 20 x 20 pyramids on 20 floors: 22,001 bodies
Scene pyramids(int n);  ///< pyramids of 55 boxes in a square, as many as n boxes allow

// joint_grid.cpp
Scene jointGrid();  ///< 100 x 100 discs that hang on each other: 10,000 bodies, 19,794 hinges
Scene net(int n);   ///< the same of n x n discs
Scene truss32();    ///< 32 bays of rods, with a ton at the middle: 66 bodies, 128 rods
Scene cloth20();    ///< 20 x 20 discs that hang from a fixed row: 400 bodies, 741 rods

// tumbler.cpp
Scene tumblerOf2025();  ///< a turning box with 2,025 small ones inside: 2,027 bodies

// spinner.cpp
Scene spinner();  ///< a paddle in a ring full of capsules, discs and boxes: 6,078 bodies

// small.cpp: about what a small game has on its screen, with this number of bodies.
Scene small20();
Scene small50();
Scene small200();

// heaps.cpp
Scene junkyard();   ///< 8,000 pentagons that a kinematic box pushes to and fro: 8,002 bodies
Scene compounds();  ///< 3,000 bodies of two triangles each fall into a shaft: 3,001 bodies
Scene washer();     ///< a turning kinematic drum with 8,100 small boxes: 8,101 bodies

// rain.cpp
Scene rain();  ///< 1,000 dolls of eleven bones fall on five floors and are made anew one after another: 11,001 bodies

// dolls.cpp
Scene dolls100();    ///< 100 of the scene ragdoll's dolls in a pit: 1,001 bodies, 900 hinges
Scene dolls(int n);  ///< n of them fall 2.5 m, side by side
Scene rope60();      ///< 60 boxes hinged end to end fall in a heap
Scene bridge20();    ///< the scene bridge_under_load, with sleeping off

// crowds.cpp
Scene pile(int n);  ///< n boxes and discs in a heap of 40 layers
Scene pit(int n);   ///< n bodies fall into a pit 18 m wide: half discs that bounce, half boxes that do not
Scene gas(int n);   ///< n elastic discs that fill 40 % of a world that wraps, without gravity
Scene smash();      ///< a heavy box hits 9,600 small sleeping ones: 9,601 bodies

// movers.cpp: with 1,000 movers, the milliseconds of a step are the microseconds of one mover.
Scene gridMovers();
Scene platformMovers();

}  // namespace plumb::compare
