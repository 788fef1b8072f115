// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_names.h"

#include <QRegularExpression>

namespace drillwave {
namespace {

// "force F" of "force F [kN]" and of "force F / F₀".
QString withoutUnit(QString label, const QString& otherwise) {
    static const QRegularExpression unit(QStringLiteral(R"(\s*(\[[^\]]*\]|/\s\S+)$)"));
    label.remove(unit);
    return label.isEmpty() ? otherwise : label;
}

}  // namespace

QString xLabelOf(const QCPAbstractPlottable& curve) {
    const QString label = curve.keyAxis()->label();
    if (!label.isEmpty()) return label;
    QString lowest;
    for (const QCPAxisRect* rect : curve.parentPlot()->axisRects())
        if (const QCPAxis* axis = rect->axis(QCPAxis::atBottom); axis && !axis->label().isEmpty())
            lowest = axis->label();
    return lowest;
}

QString xNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning) {
    return meaning.xName.isEmpty() ? withoutUnit(xLabelOf(curve), QStringLiteral("x")) : meaning.xName;
}

QString yNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning) {
    return meaning.yName.isEmpty() ? withoutUnit(curve.valueAxis()->label(), QStringLiteral("y"))
                                   : meaning.yName;
}

}  // namespace drillwave
