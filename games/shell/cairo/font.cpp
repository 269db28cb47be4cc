// SPDX-License-Identifier: MIT
#include <games/shell/cairo/font.h>

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb::games {
namespace {

constexpr const char* family = "Inter";

using Pattern = std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Destroy<cairo_font_options_destroy>>;
using ScaledFont = std::unique_ptr<cairo_scaled_font_t, Destroy<cairo_scaled_font_destroy>>;

int fontconfigWeight(Weight weight) {
    switch (weight) {
        case Weight::Regular: return FC_WEIGHT_MEDIUM;  // light on dark looks thinner than it is
        case Weight::Bold: return FC_WEIGHT_BOLD;
        case Weight::Heavy: return FC_WEIGHT_BLACK;
    }
    return FC_WEIGHT_REGULAR;
}

CairoFace faceOf(Weight weight) {
    const Pattern wanted(FcPatternCreate());
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, fontconfigWeight(weight));
    FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultMatch;
    const Pattern found(FcFontMatch(nullptr, wanted.get(), &result));
    if (!found) throw std::runtime_error("fontconfig finds no font; on Debian, install fonts-inter");
    return CairoFace(cairo_ft_font_face_create_for_pattern(found.get()));
}

ScaledFont scaled(cairo_font_face_t* face, double size) {
    cairo_matrix_t toFont, identity;
    cairo_matrix_init_scale(&toFont, size, size);
    cairo_matrix_init_identity(&identity);
    // The widths do not depend on the pixels, so a text keeps its proportions at any size.
    const FontOptions options(cairo_font_options_create());
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    ScaledFont font(cairo_scaled_font_create(face, &toFont, &identity, options.get()));
    if (cairo_scaled_font_status(font.get()) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("cannot make a font of " + std::to_string(size) + " pixels");
    return font;
}

double advanceOf(cairo_scaled_font_t* font, const char* text) {
    cairo_text_extents_t extents;
    cairo_scaled_font_text_extents(font, text, &extents);
    return extents.x_advance;
}

double heightOf(cairo_scaled_font_t* font, const char* text) {
    cairo_text_extents_t extents;
    cairo_scaled_font_text_extents(font, text, &extents);
    return -extents.y_bearing;
}

std::vector<cairo_glyph_t> glyphsOf(cairo_scaled_font_t* font, const std::string& text) {
    cairo_glyph_t* made = nullptr;
    int count = 0;
    const auto status = cairo_scaled_font_text_to_glyphs(font, 0, 0, text.data(), static_cast<int>(text.size()), &made,
                                                         &count, nullptr, nullptr, nullptr);
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error("\"" + text + "\": " + cairo_status_to_string(status));
    std::vector<cairo_glyph_t> glyphs(made, made + count);
    cairo_glyph_free(made);
    return glyphs;
}

/// The indices of the ten digits in the font.
std::array<unsigned long, 10> figuresOf(cairo_scaled_font_t* font) {
    const std::vector<cairo_glyph_t> glyphs = glyphsOf(font, "0123456789");
    std::array<unsigned long, 10> figures{};
    for (std::size_t i = 0; i < figures.size() && i < glyphs.size(); ++i) figures[i] = glyphs[i].index;
    return figures;
}

/// Gives every digit the width of a 0 and centres it there. Returns the new width of the text.
double evenFigures(cairo_scaled_font_t* font, std::vector<cairo_glyph_t>& glyphs, double width) {
    const std::array<unsigned long, 10> figures = figuresOf(font);
    const double room = advanceOf(font, "0");
    double shift = 0;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        const double next = i + 1 < glyphs.size() ? glyphs[i + 1].x : width;
        const double spare = room - (next - glyphs[i].x);
        glyphs[i].x += shift;
        if (std::find(figures.begin(), figures.end(), glyphs[i].index) == figures.end()) continue;
        glyphs[i].x += spare / 2;
        shift += spare;
    }
    return width + shift;
}

}  // namespace

Fonts::Fonts() {
    for (const Weight weight : {Weight::Regular, Weight::Bold, Weight::Heavy}) {
        const auto i = static_cast<std::size_t>(weight);
        faces_[i] = faceOf(weight);
        constexpr double large = 200;
        capHeights_[i] = heightOf(scaled(faces_[i].get(), large).get(), "H") / large;
    }
}

Glyphs Fonts::set(cairo_t* context, const std::string& text, Weight weight, double size, double fitWidth) const {
    const auto i = static_cast<std::size_t>(weight);
    // Only few sizes, so that a slowly growing text does not need new glyphs each time.
    const auto rounded = [](double value) { return std::max(1.0, std::round(value * 4) / 4); };
    const auto setAt = [&](double at) {
        const ScaledFont font = scaled(faces_[i].get(), at);
        Glyphs set{glyphsOf(font.get(), text), 0, capHeights_[i] * at, at};
        set.width = evenFigures(font.get(), set.glyphs, advanceOf(font.get(), text.c_str()));
        cairo_set_scaled_font(context, font.get());
        return set;
    };
    Glyphs glyphs = setAt(rounded(size));
    // The first size may have been rounded up by part of a quarter pixel; this one is rounded down.
    if (fitWidth > 0 && glyphs.width > fitWidth)
        glyphs = setAt(std::max(1.0, std::floor(glyphs.size * fitWidth / glyphs.width * 4) / 4));
    return glyphs;
}

}  // namespace plumb::games
