// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/run_graphs.h"

namespace drillwave {

QString runLegend(const QString& title, qsizetype runs) {
    constexpr qsizetype few = 3;
    constexpr qsizetype mostLetters = 24;
    if (runs > few) return title.left(1);
    return title.size() > mostLetters ? title.left(mostLetters - 1) + QStringLiteral("…") : title;
}

}  // namespace drillwave
