// SPDX-License-Identifier: GPL-3.0-or-later
// Colours for values of either sign: zero in the middle, blue below, orange above.
#pragma once

#include <QColor>
#include <vector>

class QCPColorGradient;

namespace drillwave {

/// A diverging scale, made in the OKLab space: lightness changes evenly with the magnitude and alike on both
/// sides, so that equal steps look equal; blue and orange differ also to the colour blind. Zero is as light
/// (or dark) as the background of a plot, so that an undisturbed rod looks empty.
class ColourScale {
  public:
    /// For a light or a dark background.
    static ColourScale onLight() { return ColourScale(0.975, 0.42); }
    static ColourScale onDark() { return ColourScale(0.22, 0.86); }
    /// The one that fits the background.
    static ColourScale forBackground(const QColor& background) {
        return background.lightness() < 128 ? onDark() : onLight();
    }

    /// Of value/limit; what is outside −1 … 1 has the colours of the ends, NaN is transparent.
    QRgb colour(double share) const;
    /// The same for a colour bar.
    QCPColorGradient gradient() const;

  private:
    /// OKLab lightness of zero and of the ends.
    ColourScale(double middle, double ends);

    std::vector<QRgb> m_colours;  // evenly from −1 to 1, zero in the middle
};

}  // namespace drillwave
