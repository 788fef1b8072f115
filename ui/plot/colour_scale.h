// SPDX-License-Identifier: GPL-3.0-or-later
// Colours for values: of either sign, about a level, or from small to large.
#pragma once

#include <QColor>
#include <vector>

#include "ui/text/lightness.h"

class QCPColorGradient;

namespace drillwave {

/// A scale of shares −1 … 1, made in the OKLab space: lightness changes evenly, so that equal steps look
/// equal; blue and orange differ also to the colour blind. Each is made once, on first use.
class ColourScale {
  public:
    /// For values of either sign, on a light or a dark background: blue below, orange above, alike in
    /// lightness on both sides. Zero is as light (or dark) as the background of a plot, so that an
    /// undisturbed rod looks empty.
    static const ColourScale& onLight();
    static const ColourScale& onDark();
    /// For values on either side of a level: dark blue below, light orange above, hardly any colour at the
    /// level. Lightness grows all the way, so that it can be read in grey, too.
    static const ColourScale& aboutLevel();
    /// From dark blue over green to light yellow; lightness grows all the way.
    static const ColourScale& ramp();
    /// The one that fits the background.
    static const ColourScale& forBackground(const QColor& background) {
        return isDark(background) ? onDark() : onLight();
    }

    /// Returns the colour of value/limit; outside −1 … 1 that of the ends, transparent for NaN.
    QRgb colour(double share) const;
    /// Returns the colours for a colour bar.
    QCPColorGradient gradient() const;

  private:
    enum class Kind { sides, ramp };
    /// OKLab lightness of −1, 0 and 1.
    ColourScale(Kind kind, double below, double middle, double above);

    std::vector<QRgb> m_colours;  // evenly from −1 to 1, zero in the middle
};

}  // namespace drillwave
