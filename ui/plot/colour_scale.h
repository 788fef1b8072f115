// SPDX-License-Identifier: GPL-3.0-or-later
// Colours for values: of either sign, about a level, or from small to large.
#pragma once

#include <QColor>
#include <vector>

#include "ui/text/lightness.h"

class QCPColorGradient;

namespace drillwave {

/// Scale of colours for numbers from −1 to 1 (shares). Lightness changes evenly in the OKLab colour space, so
/// that equal steps look equal. Colour-blind readers can distinguish blue from orange. Each scale is computed
/// once, on first use.
class ColourScale {
  public:
    /// Returns the scale for values of either sign on a light background: blue below zero, orange above. Both
    /// sides have the same lightness. Zero is almost as light as the background of a plot, so that an
    /// undisturbed rod looks empty.
    static const ColourScale& onLight();
    /// Returns the scale for values of either sign on a dark background, where zero is as dark as the
    /// background.
    static const ColourScale& onDark();
    /// Returns the scale for values on either side of a level: dark blue below, light orange above, almost no
    /// colour at the level. Lightness increases throughout, so that the scale also works in greyscale.
    static const ColourScale& aboutLevel();
    /// Returns a scale for values without a special level, such as zero. It runs from dark blue through green
    /// to light yellow, with lightness increasing throughout.
    static const ColourScale& ramp();
    /// Returns onDark() if the background of the plot is dark, onLight() if it is light.
    static const ColourScale& forBackground(const QColor& background) {
        return isDark(background) ? onDark() : onLight();
    }

    /// Returns the colour of a number between −1 (first colour) and 1 (last colour). Numbers outside get the
    /// colour of the nearer end; NaN gives transparent.
    QRgb colour(double share) const;
    /// Returns the whole scale, from −1 to 1, as the gradient of a colour bar.
    QCPColorGradient gradient() const;

  private:
    enum class Kind { sides, ramp };
    /// Computes the colours from their OKLab lightness (0 black, 1 white) at the numbers −1 (`below`), 0
    /// (`middle`) and 1 (`above`).
    ColourScale(Kind kind, double below, double middle, double above);

    std::vector<QRgb> m_colours;  // colours at equal steps from −1 to 1, with zero in the middle
};

}  // namespace drillwave
