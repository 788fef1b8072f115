// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of the texts of an SVG file to characters that every viewer has.
#pragma once

#include <QByteArray>
#include <QString>

namespace drillwave {

/// Returns the SVG with Unicode subscripts and superscripts ("N₀ₚ", "10⁻⁵") replaced by small letters below
/// or above the line. Many fonts lack these characters; a single ¹, ² or ³ is kept. Texts in the font
/// `family` get common fonts as alternatives. Characters that XML does not allow are escaped as by
/// printable().
QByteArray withCommonText(const QByteArray& svg, const QString& family);

}  // namespace drillwave
