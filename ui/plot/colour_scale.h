// SPDX-License-Identifier: GPL-3.0-or-later
// Colours for values: of either sign, about a level, or from small to large.
#pragma once

#include <QColor>
#include <vector>

class QCPColorGradient;

namespace drillwave {

/// A scale of shares −1 … 1, made in the OKLab space: lightness changes evenly, so that equal steps look
/// equal; blue and orange differ also to the colour blind.
class ColourScale {
  public:
    /// For values of either sign, on a light or a dark background: blue below, orange above, alike in
    /// lightness on both sides. Zero is as light (or dark) as the background of a plot, so that an
    /// undisturbed rod looks empty.
    static ColourScale onLight() { return ColourScale(Kind::sides, 0.42, 0.975, 0.42); }
    static ColourScale onDark() { return ColourScale(Kind::sides, 0.86, 0.22, 0.86); }
    /// For values on either side of a level: dark blue below, light orange above, hardly any colour at the
    /// level. Lightness grows all the way, so that it can be read in grey, too.
    static ColourScale aboutLevel() { return ColourScale(Kind::sides, 0.3, 0.66, 0.95); }
    /// From dark blue over green to light yellow, likewise.
    static ColourScale ramp() { return ColourScale(Kind::ramp, 0.28, 0.605, 0.93); }
    /// The one that fits the background.
    static ColourScale forBackground(const QColor& background) {
        return background.lightness() < 128 ? onDark() : onLight();
    }

    /// Of value/limit; what is outside −1 … 1 has the colours of the ends, NaN is transparent.
    QRgb colour(double share) const;
    /// The same for a colour bar.
    QCPColorGradient gradient() const;

  private:
    enum class Kind { sides, ramp };
    /// OKLab lightness of −1, 0 and 1.
    ColourScale(Kind kind, double below, double middle, double above);

    std::vector<QRgb> m_colours;  // evenly from −1 to 1, zero in the middle
};

}  // namespace drillwave
