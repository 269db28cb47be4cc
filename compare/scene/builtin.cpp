// SPDX-License-Identifier: MIT
#include <compare/scene/builtin.h>

#include <algorithm>

#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

std::vector<Scene> builtinScenes() {
    std::vector<Scene> scenes{
        freeFall(),
        projectile(),
        projectileDamped(),
        spinFree(),
        projectileFan(),
        projectileFanDrag(),
        movingTarget(),
        terminalSpeed(),
        twoBodyOrbit(),
        buoyantBox(),
        magnetCatch(),
        bounce08(),
        bounce1(),
        wallTouch(),
        headOn1(),
        headOn05(),
        headOn0(),
        oblique1(),
        oblique08(),
        slipLandingSticks(),
        slipLandingSlips(),
        bulletWall(),
        blockSlides(),
        blockSticks(),
        discRolls(),
        discRollsDown(),
        ringRollsDown(),
        slideToRoll(),
        tipBelow(),
        tipAbove(),
        conveyor(),
        terrainBox(),
        terrainDisc(),
        terrainCapsule(),
        tileFloor(),
        tileWall(),
        moverWall(),
        platformRide(),
        mazeLap(),
        jump1985(),
        jumpModern(),
        steering(),
        wrapHeadOn(),
        wrapBilliard(),
        pendulum45(),
        pendulum150(),
        pendulumStep(),
        rodPendulum90(),
        doublePendulum(),
        doublePendulumMinute(),
        pendulumHorizontal(),
        doubleFourBar(),
        hangingChain(),
        springUndamped(),
        springsDamped(),
        atwoodMachine(),
        cradleOne(),
        cradleTwo(),
        cradleGap(),
        ballisticPendulum(),
        catenary(),
        loadedChain(),
        bridgeUnderLoad(),
        breakingBridge(),
        carOverHills(),
        cartOfATon(),
        nineCarts(),
        ragdoll(),
        dollOnBoulders(),
        ropeHeapsUp(),
        scissorLift(),
        gearTrain(),
        sensorGate(),
        oneWayPlatform(),
        boxAtRest(),
        stackOfTen(),
        smallPyramid(),
        tallStack(),
        stackAwake(),
        heavyOnLight(),
        arch(),
        dominoes(),
        elasticGas(),
        smallTumbler(),
    };
    for (Scene& scene : scenes) {
        giveTitle(scene);
        scene.answer = answerTo(scene.name);
        scene.controls = controlsOf(scene.name);
    }
    return scenes;
}

std::optional<Scene> findScene(const std::string& name) {
    for (Scene& scene : builtinScenes()) {
        if (scene.name == name) return std::move(scene);
    }
    return std::nullopt;
}

}  // namespace plumb::compare
