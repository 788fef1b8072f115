// SPDX-License-Identifier: GPL-3.0-or-later
// How a picture of a page is to be saved.
#pragma once

#include <QSize>
#include <QString>

#include "ui/plot/plot_rendering.h"

namespace drillwave {

struct PictureChoice {
    QString format = QStringLiteral("png");  ///< one of plotFormats()
    Millimetres size{180, 120};
    double dpi = 300;  ///< counts for PNG only

    /// Pixels of a PNG.
    QSize pixels() const;
    /// Why no such picture can be made; empty when it can.
    QString problem() const;
};

/// The choice made last, or one for a picture of that width/height.
PictureChoice rememberedPictureChoice(double aspectRatio);
void remember(const PictureChoice& choice);

}  // namespace drillwave
