// SPDX-License-Identifier: MIT
// Which fields does each part of a scene have, what are they called in a file, and which values may they have?
// There is one list per type, for reader, writer, checks and schema, so that these cannot differ. For a type of the
// kit, the list is the kit's description. A visitor offers
//   visit(Field, field)             a field,
//   visit.orInfinite(Field, field)  a number that may be infinite, of either sign,
//   visit.shape(shape)              a shape under its kind: "circle": {...},
//   visit.oneOf(variant, tags)      one alternative of a variant under its tag.
#pragma once
#include <type_traits>
#include <variant>

#include <compare/scene/fields/closed_form.h>
#include <compare/scene/fields/field.h>
#include <compare/scene/fields/mover.h>
#include <compare/scene/fields/probe.h>
#include <compare/scene/fields/tags.h>
#include <compare/scene/scene.h>
#include <plumb/dynamics/describe.h>
#include <plumb/shapes/tile_text.h>

namespace plumb::compare {

template <class T>
inline constexpr bool isVariant = false;
template <class... T>
inline constexpr bool isVariant<std::variant<T...>> = true;

/// Shows the members of a kit's definition to a visitor of fields. Ids are left out, because a scene uses names; code
/// is left out too.
template <class Visit>
struct MemberFields {
    Visit& visit;

    template <class T>
    void operator()(const Member& member, T& value) const {
        using Value = std::remove_const_t<T>;
        if constexpr (std::is_same_v<Value, Shape>)
            visit.shape(value);
        else if constexpr (isVariant<Value>)
            visit.oneOf(value, tagsOfAlternatives<Value>);
        else if constexpr (std::is_same_v<Value, double>)
            member.allowed.infinite || member.allowed.minusInfinite ? visit.orInfinite(Field{member}, value)
                                                                    : visit(Field{member}, value);
        else if constexpr (!std::is_same_v<Value, BodyId> && !std::is_same_v<Value, JointId> &&
                           !std::is_same_v<Value, ContactRule>)
            visit(Field{member}, value);
    }
};

/// A type that the kit describes. Only a magnet differs: its pull is part of its own object.
template <Described Def>
requires(!OrConst<Def, Magnet>) void fields(auto& visit, Def& def) {
    describe(def, MemberFields<std::remove_reference_t<decltype(visit)>>{visit});
}
void fields(auto& visit, OrConst<Magnet> auto& x) {
    fields(visit, x.pull);
}
void fields(auto& visit, OrConst<Shape> auto& x) {
    visit.shape(x);
}
/// A box as written in a file; it is stored as a polygon.
struct BoxFields {
    Vec2 halfSize{0.5, 0.5};  ///< [m]
    Vec2 center{0, 0};        ///< [m]
    double radius = 0;        ///< the outline lies this far outside the box [m]
};
void fields(auto& visit, OrConst<BoxFields> auto& x) {
    visit({"halfSize", "m", Allowed::positive, "half of its width, and of its height"}, x.halfSize);
    visit({"center", "m", Allowed::finite, "in the body's frame"}, x.center);
    visit({"radius", "m", Allowed::notNegative, "the outline lies so far outside of the box"}, x.radius);
}
/// A tile map as written in a file.
struct TilesFields {
    std::vector<std::string> rows = {};  ///< from top to bottom, in the letters of the standard legend
    double size = 1;                     ///< of a tile [m]
    bool wrapX = false;
    bool wrapY = false;
};
void fields(auto& visit, OrConst<TilesFields> auto& x) {
    visit(needed({"rows", "", Allowed::any, "the topmost first, a letter a tile, all of one length"}), x.rows);
    visit({"size", "m", Allowed::positive, "of a tile"}, x.size);
    visit({"wrapX", "", Allowed::any, "does it go on at its left beyond its right edge?"}, x.wrapX);
    visit({"wrapY", "", Allowed::any, "does it go on at its bottom beyond its top?"}, x.wrapY);
}
void fields(auto& visit, OrConst<SceneBody> auto& x) {
    visit(needed({"name", "", Allowed::any, "unlike the other bodies'"}), x.name);
    visit({"appears", "s", Allowed::notNegative, "not there before this, as its joints are not"}, x.appears);
    visit(
        {"renewed", "s", Allowed::notNegative, "taken out and made anew each time so long after it appeared; 0: never"},
        x.renewed);
    fields(visit, x.def);
}
void fields(auto& visit, OrConst<SceneJoint> auto& x) {
    visit(needed({"name", "", Allowed::any, "unlike the other joints'"}), x.name);
    visit({"bodyA", "", Allowed::any, "a body's name; a gear has none"}, x.bodyA);
    visit({"bodyB", "", Allowed::any, "another body's; a gear and a target have none"}, x.bodyB);
    visit({"jointA", "", Allowed::any, "of a gear: the name of a joint before it"}, x.jointA);
    visit({"jointB", "", Allowed::any, "of a gear: the name of another joint before it"}, x.jointB);
    visit.oneOf(x.def, tagsOfAlternatives<JointDef>);
}
void fields(auto& visit, OrConst<SceneField> auto& x) {
    visit(needed({"name", "", Allowed::any, "unlike the other fields'"}), x.name);
    visit({"body", "", Allowed::any, "of a magnet: the name of the body that carries it"}, x.body);
    fields(visit, x.def);
}
void fields(auto& visit, OrConst<SceneControl> auto& x) {
    visit(needed({"label", "", Allowed::any, "what it is, for a reader"}), x.label);
    visit(needed({"set", "", Allowed::any, "the paths of the fields that it sets, as check --set has them"}), x.set);
    visit({"as", "", Allowed::any, "as which number the field is shown"}, x.as);
    visit({"about", "m", Allowed::finite, "from where a vector is measured"}, x.about);
    visit({"from", "the unit", Allowed::finite, "the least that it offers"}, x.from);
    visit({"to", "the unit", Allowed::finite, "the most that it offers"}, x.to);
    visit({"step", "the unit", Allowed::positive, "from one value to the next"}, x.step);
    visit({"unit", "", Allowed::any, "as it is printed"}, x.unit);
}
void fields(auto& visit, OrConst<Scene> auto& x) {
    visit(needed({"name", "", Allowed::any, "of small letters, digits and underscores"}), x.name);
    visit({"title", "", Allowed::any, "as a reader sees it; made of the name where there is none"}, x.title);
    visit({"group", "", Allowed::any, "the heading under which it is listed"}, x.group);
    visit({"question", "", Allowed::any, "what it asks, one sentence"}, x.question);
    visit({"answer", "", Allowed::any, "to the question; between braces what is read of a run: {largest y of ball}"},
          x.answer);
    visit({"gravity", "m/s^2", Allowed::finite, "the same everywhere"}, x.gravity);
    visit({"duration", "s", Allowed::positive, "of the whole run"}, x.duration);
    visit({"dt", "s", Allowed::positive, "length of a step"}, x.dt);
    visit({"sleeping", "", Allowed::any, "may engines leave out what rests?"}, x.sleeping);
    visit(needed({"bodies", "", Allowed::any, "what there is"}), x.bodies);
    visit({"joints", "", Allowed::any, "what holds bodies together"}, x.joints);
    visit({"fields", "", Allowed::any, "what acts on bodies from afar"}, x.fields);
    visit({"movers", "", Allowed::any, "what moves bodies otherwise than Newton would"}, x.movers);
    visit({"wrap", "", Allowed::any, "does it go on at its other side?"}, x.wrap);
    visit({"closedForm", "", Allowed::any, "what the textbook says the bodies do"}, x.closedForm);
    visit({"probes", "", Allowed::any, "what is watched beside the positions"}, x.probes);
    visit({"checks", "", Allowed::any, "what must hold, and for which engine"}, x.checks);
    visit({"controls", "", Allowed::any, "what a page offers to change"}, x.controls);
    visit({"engines", "", Allowed::any,
           "by engine and path, what this engine alone is given; a path with \"solver.\" is a number of its own"},
          x.engines);
}

}  // namespace plumb::compare
