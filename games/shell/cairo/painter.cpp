// SPDX-License-Identifier: MIT
#include <games/shell/cairo/painter.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>
#include <stdexcept>

namespace plumb::games {
namespace {

cairo_matrix_t matrixOf(const Affine& affine) {
    cairo_matrix_t matrix;
    cairo_matrix_init(&matrix, affine.xAxis.x(), affine.xAxis.y(), affine.yAxis.x(), affine.yAxis.y(),
                      affine.origin.x(), affine.origin.y());
    return matrix;
}

/// A mark without area cannot be painted, and Cairo would paint nothing after it either.
bool isFlat(const Affine& affine) {
    return !(std::abs(cross(affine.xAxis, affine.yAxis)) > 1e-12);
}

void setSource(cairo_t* context, const Paint& paint, double opacity) {
    if (!paint.gradient) {
        const Color& c = paint.color;
        cairo_set_source_rgba(context, c.red, c.green, c.blue, c.alpha * opacity);
        return;
    }
    const Gradient& g = *paint.gradient;
    const CairoPattern pattern(
        g.radius > 0 ? cairo_pattern_create_radial(g.from.x(), g.from.y(), 0, g.from.x(), g.from.y(), g.radius)
                     : cairo_pattern_create_linear(g.from.x(), g.from.y(), g.to.x(), g.to.y()));
    const auto stop = [&](double at, const Color& c) {
        cairo_pattern_add_color_stop_rgba(pattern.get(), at, c.red, c.green, c.blue, c.alpha * opacity);
    };
    stop(0, g.first);
    stop(1, g.last);
    cairo_set_source(context, pattern.get());
}

void outline(cairo_t* context, const RectMark& rect) {
    const double x = rect.corner.x(), y = rect.corner.y(), w = rect.size.x(), h = rect.size.y();
    const double r = std::min({rect.radius, std::abs(w) / 2, std::abs(h) / 2});
    if (r <= 0) return cairo_rectangle(context, x, y, w, h);
    constexpr double quarter = std::numbers::pi / 2;
    cairo_arc(context, x + w - r, y + r, r, -quarter, 0);
    cairo_arc(context, x + w - r, y + h - r, r, 0, quarter);
    cairo_arc(context, x + r, y + h - r, r, quarter, 2 * quarter);
    cairo_arc(context, x + r, y + r, r, 2 * quarter, 3 * quarter);
    cairo_close_path(context);
}

void outline(cairo_t* context, const EllipseMark& ellipse) {
    if (!(ellipse.radii.x() > 0 && ellipse.radii.y() > 0)) return;
    const bool whole = ellipse.from == ellipse.to;
    cairo_save(context);
    cairo_translate(context, ellipse.center.x(), ellipse.center.y());
    cairo_scale(context, ellipse.radii.x(), ellipse.radii.y());
    if (ellipse.pie) cairo_move_to(context, 0, 0);
    if (whole || ellipse.from < ellipse.to)
        cairo_arc(context, 0, 0, 1, ellipse.from, whole ? ellipse.from + 2 * std::numbers::pi : ellipse.to);
    else
        cairo_arc_negative(context, 0, 0, 1, ellipse.from, ellipse.to);
    if (whole || ellipse.pie) cairo_close_path(context);
    cairo_restore(context);
}

void outline(cairo_t* context, const PathMark& path) {
    for (const Vec2& point : path.points) cairo_line_to(context, point.x(), point.y());
    if (path.closed) cairo_close_path(context);
}

/// The position and direction of a text, in pixels.
struct Standing {
    Vec2 at;
    Vec2 along;    ///< of length 1
    double scale;  ///< pixels per unit
};

Standing standingOf(const Mark& mark, const TextMark& text) {
    const double scale = mark.toPixels.xAxis.norm();
    Vec2 along = mark.toPixels.xAxis / scale;
    if (along.x() < 0) along = -along;  // mirrored or upside down: keep it readable
    return {mark.toPixels * text.at, along, scale};
}

/// The start of a text's baseline, from the text's position [pixels].
Vec2 startOf(const Glyphs& glyphs, const TextStyle& style) {
    const double x = style.align == Align::Left ? 0 : style.align == Align::Right ? glyphs.width : glyphs.width / 2;
    const double y = style.baseline == Baseline::Base     ? 0
                     : style.baseline == Baseline::Middle ? glyphs.capHeight / 2
                                                          : glyphs.capHeight;
    return {-x, y};
}

/// The nearest corner of a pixel.
Vec2 rounded(const Vec2& place) {
    return {std::round(place.x()), std::round(place.y())};
}

/// Puts the context's origin at the start of a text, with x along its line and pixels as units.
void stand(cairo_t* context, const Standing& standing, const Vec2& start) {
    const Vec2 down = perp(standing.along);
    Vec2 origin = standing.at + start.x() * standing.along + start.y() * down;
    // Text at whole pixels is sharp.
    if (standing.along.y() == 0) origin = rounded(origin);
    const cairo_matrix_t matrix = matrixOf({standing.along, down, origin});
    cairo_set_matrix(context, &matrix);
}

Glyphs setText(cairo_t* context, const Fonts& fonts, const TextMark& text, double scale) {
    const TextStyle& style = text.style;
    cairo_identity_matrix(context);
    return fonts.set(context, text.text, style.weight, style.size * scale, style.fitWidth * scale);
}

void paintText(cairo_t* context, const Fonts& fonts, const Mark& mark, const TextMark& text) {
    const Standing standing = standingOf(mark, text);
    if (text.style.size * standing.scale < 1) return;  // too small to be seen
    const Glyphs glyphs = setText(context, fonts, text, standing.scale);
    stand(context, standing, startOf(glyphs, text.style));
    cairo_show_glyphs(context, glyphs.glyphs.data(), static_cast<int>(glyphs.glyphs.size()));
}

void paintMark(cairo_t* context, const Fonts& fonts, const Mark& mark) {
    if (isFlat(mark.toPixels)) return;
    const cairo_matrix_t matrix = matrixOf(mark.toPixels);
    cairo_set_matrix(context, &matrix);
    setSource(context, mark.brush.paint, mark.opacity);
    if (const auto* text = std::get_if<TextMark>(&mark.shape)) return paintText(context, fonts, mark, *text);
    cairo_new_path(context);
    std::visit(
        [&](const auto& shape) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(shape)>, TextMark>) outline(context, shape);
        },
        mark.shape);
    if (mark.brush.width > 0) {
        cairo_set_line_width(context, mark.brush.width);
        cairo_stroke(context);
    } else {
        cairo_fill(context);
    }
}

void setClip(cairo_t* context, const Drawing& drawing, int clip) {
    cairo_reset_clip(context);
    if (clip < 0) return;
    const Clip& c = drawing.clips[static_cast<std::size_t>(clip)];
    const Vec2 lower = rounded(c.corner), upper = rounded(c.corner + c.size);
    cairo_identity_matrix(context);
    cairo_new_path(context);
    cairo_rectangle(context, lower.x(), lower.y(), upper.x() - lower.x(), upper.y() - lower.y());
    cairo_clip(context);
}

struct Rows {
    int from, to;
};

void paintRows(const Fonts& fonts, const Drawing& drawing, std::span<const Mark* const> marks, const PixelView& to,
               Rows rows, bool quick) {
    std::uint32_t* first = to.pixels + static_cast<std::ptrdiff_t>(rows.from) * (to.stride / 4);
    const CairoSurface surface = surfaceOf({first, {to.size.width, rows.to - rows.from}, to.stride});
    cairo_surface_set_device_offset(surface.get(), 0, -rows.from);
    const CairoContext context(cairo_create(surface.get()));
    cairo_set_antialias(context.get(), quick ? CAIRO_ANTIALIAS_FAST : CAIRO_ANTIALIAS_GOOD);
    cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
    int clip = -1;
    for (const Mark* mark : marks) {
        if (mark->clip != clip) setClip(context.get(), drawing, clip = mark->clip);
        paintMark(context.get(), fonts, *mark);
    }
    const cairo_status_t status = cairo_status(context.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("paint: ") + cairo_status_to_string(status));
}

}  // namespace

void Painter::paint(const Drawing& drawing, const PixelView& to) const {
    paint(drawing, drawing.inOrder(), to);
}

void Painter::paint(const Drawing& drawing, std::span<const Mark* const> marks, const PixelView& to) const {
    if (!(drawing.size == to.size)) throw std::runtime_error("the drawing has another size than the picture");
    const int bands = std::clamp(settings_.threads, 1, to.size.height);
    const auto rowOf = [&](int band) { return to.size.height * band / bands; };
    std::vector<std::future<void>> others;
    for (int band = 1; band < bands; ++band)
        others.push_back(std::async(std::launch::async, [&, band] {
            paintRows(fonts_, drawing, marks, to, {rowOf(band), rowOf(band + 1)}, settings_.quick);
        }));
    paintRows(fonts_, drawing, marks, to, {0, rowOf(1)}, settings_.quick);
    for (std::future<void>& other : others) other.get();
}

Aabb Painter::boxOf(const Mark& mark) const {
    Picture none({1, 1});
    const CairoSurface surface = surfaceOf(none.view());
    const CairoContext context(cairo_create(surface.get()));
    const auto& text = std::get<TextMark>(mark.shape);
    const Standing standing = standingOf(mark, text);
    const Glyphs glyphs = setText(context.get(), fonts_, text, standing.scale);
    cairo_text_extents_t ink;
    cairo_glyph_extents(context.get(), glyphs.glyphs.data(), static_cast<int>(glyphs.glyphs.size()), &ink);
    stand(context.get(), standing, startOf(glyphs, text.style));
    const double top = std::min(ink.y_bearing, 0.0), bottom = std::max(ink.y_bearing + ink.height, 0.0);
    std::optional<Aabb> box;
    for (const Vec2& corner : {Vec2(0, top), Vec2(0, bottom), Vec2(glyphs.width, top), Vec2(glyphs.width, bottom)}) {
        Vec2 p = corner;
        cairo_user_to_device(context.get(), &p.x(), &p.y());
        box = box ? merge(*box, {p, p}) : Aabb{p, p};
    }
    return *box;
}

}  // namespace plumb::games
