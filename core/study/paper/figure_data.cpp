// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/paper/figure_data.h"

#include <algorithm>

#include "core/text/handy_text.h"

namespace drillwave {

namespace {

std::string wideTable(const FigurePanel& panel) {
    std::string csv = panel.xKey;
    for (const FigureCurve& curve : panel.curves) csv += "," + curve.key;
    csv += '\n';
    for (std::size_t i = 0; i < panel.curves.front().x.size(); ++i) {
        appendNumber(csv, panel.curves.front().x[i]);
        for (const FigureCurve& curve : panel.curves) {
            csv += ',';
            appendNumber(csv, curve.y[i]);
        }
        csv += '\n';
    }
    return csv;
}

std::string longTable(const FigurePanel& panel) {
    std::string csv = "curve," + panel.xKey + "," + panel.yKey + "\n";
    for (const FigureCurve& curve : panel.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            csv += curve.key + ",";
            appendNumber(csv, curve.x[i]);
            csv += ',';
            appendNumber(csv, curve.y[i]);
            csv += '\n';
        }
    return csv;
}

}  // namespace

std::string panelCsv(const FigurePanel& panel) {
    const auto sameAbscissas = [&](const FigureCurve& curve) { return curve.x == panel.curves.front().x; };
    return std::ranges::all_of(panel.curves, sameAbscissas) ? wideTable(panel) : longTable(panel);
}

}  // namespace drillwave
