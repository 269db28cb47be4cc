// SPDX-License-Identifier: MIT
#include <games/frame/debug_view.h>

#include <games/frame/screens.h>

namespace plumb::games {

void drawDebug(Canvas& canvas, const World& world, const DebugView& view) {
    canvas.layer(debugLayer);
    canvas.look(canvas.camera());
    if (!view.boxes) return;
    for (const BodyId body : world.bodies())
        for (const ShapeId shape : world.body(body).shapes()) {
            const Aabb box = aabbOf(world.shape(shape).shape, world.body(body).pose());
            canvas.rect(box.lower, box.upper - box.lower,
                        stroke(Color::hex(0x40ff40).faded(0.5), canvas.unitsPerPixel()));
        }
}

}  // namespace plumb::games
