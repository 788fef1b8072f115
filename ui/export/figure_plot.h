// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of the paper drawn from its data.
#pragma once

#include <QByteArray>
#include <QString>

#include "core/study/paper/figure_data.h"

namespace drillwave {

/// The panels below each other, in a format of plotFormats(), on white, text in the C locale; 160 mm wide.
/// Requires a QApplication (any platform, also offscreen). Empty when it could not be drawn.
QByteArray drawFigure(const Figure& figure, const QString& format);

}  // namespace drillwave
