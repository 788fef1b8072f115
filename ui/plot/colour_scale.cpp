// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/colour_scale.h"

#include <qcustomplot.h>

#include <QtMath>
#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

constexpr int coloursPerSide = 512;
constexpr double blueHue = 252, orangeHue = 52;  // [degrees]
constexpr double rampStart = 285, rampEnd = 100;
constexpr double mostChroma = 0.15;

struct LinearRgb {
    double red, green, blue;
    bool inGamut() const { return std::min({red, green, blue}) >= 0 && std::max({red, green, blue}) <= 1; }
};

// B. Ottosson, "A perceptual color space for image processing" (2020).
LinearRgb fromOkLab(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

int gammaByte(double linear) {
    const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

// The strongest colour of that lightness and hue up to `chroma` that a screen can show.
QRgb colourOf(double lightness, double chroma, double hue) {
    const double a = std::cos(qDegreesToRadians(hue)), b = std::sin(qDegreesToRadians(hue));
    LinearRgb rgb = fromOkLab(lightness, chroma * a, chroma * b);
    while (!rgb.inGamut() && chroma > 1e-3) {
        chroma -= 1e-3;
        rgb = fromOkLab(lightness, chroma * a, chroma * b);
    }
    return qRgb(gammaByte(rgb.red), gammaByte(rgb.green), gammaByte(rgb.blue));
}

}  // namespace

ColourScale::ColourScale(Kind kind, double below, double middle, double above)
    : m_colours(2 * coloursPerSide + 1) {
    for (int i = -coloursPerSide; i <= coloursPerSide; ++i) {
        const double share = i / double(coloursPerSide), size = std::abs(share);
        const double lightness = middle + ((i < 0 ? below : above) - middle) * size;
        const double chroma = mostChroma * (kind == Kind::ramp ? 0.75 : 1 - (1 - size) * (1 - size));
        const double hue = kind == Kind::ramp ? rampStart + (rampEnd - rampStart) * (share + 1) / 2
                           : i < 0            ? blueHue
                                              : orangeHue;
        m_colours[static_cast<std::size_t>(coloursPerSide + i)] = colourOf(lightness, chroma, hue);
    }
}

const ColourScale& ColourScale::onLight() {
    static const ColourScale scale(Kind::sides, 0.42, 0.975, 0.42);
    return scale;
}

const ColourScale& ColourScale::onDark() {
    static const ColourScale scale(Kind::sides, 0.86, 0.22, 0.86);
    return scale;
}

const ColourScale& ColourScale::aboutLevel() {
    static const ColourScale scale(Kind::sides, 0.3, 0.66, 0.95);
    return scale;
}

const ColourScale& ColourScale::ramp() {
    static const ColourScale scale(Kind::ramp, 0.28, 0.605, 0.93);
    return scale;
}

QRgb ColourScale::colour(double share) const {
    if (std::isnan(share)) return 0;
    const double place = coloursPerSide * (1 + std::clamp(share, -1.0, 1.0));
    return m_colours[static_cast<std::size_t>(std::lround(place))];
}

QCPColorGradient ColourScale::gradient() const {
    constexpr int stops = 64;
    QCPColorGradient gradient;
    QMap<double, QColor> colours;
    for (int i = 0; i <= stops; ++i)
        colours[double(i) / stops] = QColor::fromRgb(colour(2.0 * i / stops - 1));
    gradient.setColorStops(colours);
    return gradient;
}

}  // namespace drillwave
