// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of an SVG in a form that every reader has fonts for.
#pragma once

#include <QByteArray>
#include <QString>

namespace drillwave {

/// Subscripts and superscripts of Unicode ("N₀ₚ", "10⁻⁵"), which many fonts lack, become smaller letters
/// below or above the line; ¹, ² and ³ alone stay. Texts in `family` may be set in a common font where it is
/// missing. Characters that XML may not hold are written as printable() writes them.
QByteArray withCommonText(const QByteArray& svg, const QString& family);

}  // namespace drillwave
