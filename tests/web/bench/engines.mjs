// SPDX-License-Identifier: MIT
// How does each engine build a scene? Each gives step() and heights(), of the bodies that move. All at their defaults,
// but that nothing sleeps.
import { createRequire } from 'node:module';
import { pathToFileURL, fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const packages = `${root}build/bench-node/node_modules/`;
const require = createRequire(`${root}build/bench-node/package.json`);
const dt = 1 / 60;

async function plumb() {
  const { load } = await import(pathToFileURL(`${root}build/web/package/plumb.js`));
  const { World, box, circle, segment } = await load();
  return scene => {
    const world = new World({ gravity: [0, -10], sleeping: false });
    const filter = scene.touch ? {} : { category: 2, mask: 1 };
    const ids = scene.bodies.map(b => world.add({
      type: b.fixed ? 'static' : 'dynamic', position: [b.x, b.y], angle: b.angle ?? 0,
      shapes: (b.lines ? b.lines.map(([x1, y1, x2, y2]) => segment([x1, y1], [x2, y2])) : [b.box ? box(b.box) : circle(b.disc)])
        .map(shape => ({ ...shape, filter })) }));
    for (const [a, b, x, y] of scene.hinges) world.join({ revolute: { bodyA: ids[a], bodyB: ids[b], anchor: [x, y] } });
    return { step: () => world.step(dt), heights: () => ids.map(id => world.body(id).position()[1]) };
  };
}

const box2d = flavour => async () => {
  const { default: create } = await import(pathToFileURL(`${packages}box2d3-wasm/build/dist/es/${flavour}/Box2D.${flavour}.mjs`));
  const m = await create({ pthreadCount: 1 });
  const vec = (x, y) => new m.b2Vec2(x, y);
  return scene => {
    const worldDef = m.b2DefaultWorldDef();
    worldDef.gravity = vec(0, -10);
    worldDef.enableSleep = false;
    const world = m.b2CreateWorld(worldDef);
    const ids = scene.bodies.map(b => {
      const def = m.b2DefaultBodyDef();
      def.type = b.fixed ? m.b2BodyType.b2_staticBody : m.b2BodyType.b2_dynamicBody;
      def.position = vec(b.x, b.y);
      def.rotation = m.b2MakeRot(b.angle ?? 0);
      const body = m.b2CreateBody(world, def), shape = m.b2DefaultShapeDef();
      if (!scene.touch) {
        const filter = shape.filter;
        filter.categoryBits = 2;
        filter.maskBits = 1;
        shape.filter = filter;
      }
      for (const [x1, y1, x2, y2] of b.lines ?? []) {
        const segment = new m.b2Segment();
        segment.point1 = vec(x1, y1);
        segment.point2 = vec(x2, y2);
        m.b2CreateSegmentShape(body, shape, segment);
      }
      if (b.box) m.b2CreatePolygonShape(body, shape, m.b2MakeBox(...b.box));
      if (b.disc) {
        const circle = new m.b2Circle();
        circle.center = vec(0, 0);
        circle.radius = b.disc;
        m.b2CreateCircleShape(body, shape, circle);
      }
      return body;
    });
    for (const [a, b, x, y] of scene.hinges) {
      const def = m.b2DefaultRevoluteJointDef(), base = def.base;
      base.bodyIdA = ids[a];
      base.bodyIdB = ids[b];
      const frame = body => {
        const local = new m.b2Transform();
        local.p = vec(x - scene.bodies[body].x, y - scene.bodies[body].y);
        local.q = m.b2MakeRot(0);
        return local;
      };
      base.localFrameA = frame(a);
      base.localFrameB = frame(b);
      def.base = base;
      m.b2CreateRevoluteJoint(world, def);
    }
    return { step: () => m.b2World_Step(world, dt, 4), heights: () => ids.map(id => m.b2Body_GetPosition(id).y) };
  };
};

async function rapier() {
  const { default: R } = await import(pathToFileURL(`${packages}@dimforge/rapier2d-simd-compat/rapier.mjs`));
  await R.init();
  return scene => {
    const world = new R.World({ x: 0, y: -10 });
    world.timestep = dt;
    const bodies = scene.bodies.map(b => {
      const def = b.fixed ? R.RigidBodyDesc.fixed() : R.RigidBodyDesc.dynamic();
      const body = world.createRigidBody(def.setTranslation(b.x, b.y).setRotation(b.angle ?? 0).setCanSleep(false));
      const shapes = (b.lines ?? []).map(([x1, y1, x2, y2]) => R.ColliderDesc.segment({ x: x1, y: y1 }, { x: x2, y: y2 }));
      if (b.box) shapes.push(R.ColliderDesc.cuboid(...b.box));
      if (b.disc) shapes.push(R.ColliderDesc.ball(b.disc));
      for (const shape of shapes) world.createCollider(scene.touch ? shape : shape.setCollisionGroups(0x00020001), body);
      return body;
    });
    for (const [a, b, x, y] of scene.hinges) {
      const local = body => ({ x: x - scene.bodies[body].x, y: y - scene.bodies[body].y });
      world.createImpulseJoint(R.JointData.revolute(local(a), local(b)), bodies[a], bodies[b], false);
    }
    return { step: () => world.step(), heights: () => bodies.map(body => body.translation().y) };
  };
}

async function planck() {
  const p = require('planck');
  return scene => {
    const world = new p.World({ gravity: p.Vec2(0, -10), allowSleep: false });
    const bodies = scene.bodies.map(b => {
      const body = world.createBody({ type: b.fixed ? 'static' : 'dynamic', position: p.Vec2(b.x, b.y), angle: b.angle ?? 0 });
      const shapes = (b.lines ?? []).map(([x1, y1, x2, y2]) => new p.Edge(p.Vec2(x1, y1), p.Vec2(x2, y2)));
      if (b.box) shapes.push(new p.Box(...b.box));
      if (b.disc) shapes.push(new p.Circle(b.disc));
      const filter = scene.touch ? {} : { filterCategoryBits: 2, filterMaskBits: 1 };
      for (const shape of shapes) body.createFixture({ shape, density: 1, friction: 0.6, ...filter });
      return body;
    });
    for (const [a, b, x, y] of scene.hinges) world.createJoint(new p.RevoluteJoint({}, bodies[a], bodies[b], p.Vec2(x, y)));
    return { step: () => world.step(dt), heights: () => bodies.map(body => body.getPosition().y) };
  };
}

async function matter() {
  const { Engine, Bodies, Composite, Constraint, Body } = require('matter-js');
  return scene => {  // its gravity is 0.001 a ms^2 at scale 1: 10 m/s^2 in metres is 1e-5
    const engine = Engine.create({ gravity: { x: 0, y: -1, scale: 1e-5 }, enableSleeping: false });
    const filter = scene.touch ? {} : { collisionFilter: { category: 2, mask: 1 } };
    const bodies = scene.bodies.map(b => {
      const options = { isStatic: b.fixed === true, slop: 0.005, ...filter };
      if (b.lines) {
        const parts = b.lines.map(([x1, y1, x2, y2]) => Bodies.rectangle((x1 + x2) / 2, y1 - 0.5, x2 - x1, 1, { isStatic: true }));
        Composite.add(engine.world, parts);
        return null;
      }
      const body = b.box ? Bodies.rectangle(b.x, b.y, 2 * b.box[0], 2 * b.box[1], options) : Bodies.circle(b.x, b.y, b.disc, options);
      Body.setAngle(body, b.angle ?? 0);
      Composite.add(engine.world, body);
      return body;
    });
    for (const [a, b, x, y] of scene.hinges) {
      const point = body => ({ x: x - scene.bodies[body].x, y: y - scene.bodies[body].y });
      Composite.add(engine.world, Constraint.create({ bodyA: bodies[a], bodyB: bodies[b], pointA: point(a), pointB: point(b), length: 0 }));
    }
    return { step: () => Engine.update(engine, 1000 * dt), heights: () => bodies.map(body => body?.position.y ?? 0) };
  };
}

export const engines = { plumb, 'box2d3-wasm': box2d('deluxe'), 'box2d3-wasm, plain': box2d('compat'), rapier, planck, 'matter-js': matter };

/** The files that a page loads of each, for their sizes. */
export const filesOf = {
  plumb: ['plumb.wasm', 'plumb.js'].map(name => `${root}build/web/package/${name}`),
  'box2d3-wasm': ['deluxe/Box2D.deluxe.wasm', 'deluxe/Box2D.deluxe.mjs'].map(name => `${packages}box2d3-wasm/build/dist/es/${name}`),
  'box2d3-wasm, plain': ['compat/Box2D.compat.wasm', 'compat/Box2D.compat.mjs'].map(name => `${packages}box2d3-wasm/build/dist/es/${name}`),
  rapier: [`${packages}@dimforge/rapier2d-simd-compat/rapier.mjs`],
  planck: [`${packages}planck/dist/planck.min.js`],
  'matter-js': [`${packages}matter-js/build/matter.min.js`],
};
