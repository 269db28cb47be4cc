// SPDX-License-Identifier: MIT
// What is each built-in scene?
#pragma once
#include <compare/scene/scene.h>

namespace plumb::compare {

// flight.cpp
Scene freeFall();
Scene projectile();
Scene projectileDamped();
Scene spinFree();

// fan.cpp
Scene projectileFan();
Scene projectileFanDrag();

// aim.cpp
Scene movingTarget();

// field.cpp
Scene terminalSpeed();
Scene twoBodyOrbit();
Scene buoyantBox();
Scene magnetCatch();

// bounce.cpp
Scene bounce08();
Scene bounce1();
Scene wallTouch();

// discs.cpp
Scene headOn1();
Scene headOn05();
Scene headOn0();
Scene oblique1();
Scene oblique08();

// incline.cpp
Scene blockSlides();
Scene blockSticks();
Scene discRolls();

// rolling.cpp
Scene discRollsDown();
Scene ringRollsDown();
Scene slideToRoll();

// landing.cpp
Scene slipLandingSticks();
Scene slipLandingSlips();

// tipping.cpp
Scene tipBelow();
Scene tipAbove();

// conveyor.cpp
Scene conveyor();

// bullets.cpp
Scene bulletWall();

// terrain.cpp
Scene terrainBox();
Scene terrainDisc();
Scene terrainCapsule();

// pendulum.cpp
Scene pendulum45();
Scene pendulum150();
Scene pendulumStep();
Scene rodPendulum90();
Scene doublePendulum();
Scene doublePendulumMinute();
Scene hangingChain();

// springs.cpp
Scene springUndamped();
Scene springsDamped();

// atwood.cpp
Scene atwoodMachine();

// cradle.cpp
Scene cradleOne();
Scene cradleTwo();
Scene cradleGap();

// ballistic_pendulum.cpp
Scene ballisticPendulum();

// benchmarks.cpp
Scene pendulumHorizontal();
Scene doubleFourBar();

// chains.cpp
Scene catenary();
Scene loadedChain();

// bridge.cpp
Scene bridgeUnderLoad();
Scene breakingBridge();

// car.cpp
Scene carOverHills();

// carts.cpp
Scene cartOfATon();
Scene nineCarts();

// ragdoll.cpp
Scene ragdoll();

// heaps.cpp
Scene ropeHeapsUp();
Scene dollOnBoulders();

// machines.cpp
Scene scissorLift();
Scene gearTrain();

// gates.cpp
Scene sensorGate();
Scene oneWayPlatform();

// stack.cpp
Scene boxAtRest();
Scene stackOfTen();
Scene smallPyramid();

// tower.cpp
Scene tallStack();
Scene stackAwake();
Scene heavyOnLight();

// arch.cpp
Scene arch();

// dominoes.cpp
Scene dominoes();

// small_tumbler.cpp
Scene smallTumbler();

// tiles.cpp
Scene tileFloor();
Scene tileWall();

// movers.cpp
Scene moverWall();
Scene platformRide();
Scene mazeLap();
Scene jump1985();
Scene jumpModern();

// steering.cpp
Scene steering();

// wrap.cpp
Scene wrapHeadOn();
Scene wrapBilliard();

// gas.cpp
Scene elasticGas();

// answers.cpp
/// The answer to a scene's question, by the scene's name. It has queries between braces: see scene/answer.h.
std::string answerTo(const std::string& scene);

// controls.cpp
/// What a page offers to change in a scene, by its name; nothing for most of them.
std::vector<SceneControl> controlsOf(const std::string& scene);

// titles.cpp
/// Gives a scene its title and group by its name. A scene that is not known here keeps its own.
void giveTitle(Scene& scene);

}  // namespace plumb::compare
