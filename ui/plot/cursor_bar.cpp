// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int digits = 6;

QString quantity(double value, const QString& unit, const QLocale& locale) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    const QString number = numberText(value, digits, locale);
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

// One unit over or times another; nothing for mere numbers.
QString joined(const QString& left, QChar sign, const QString& right) {
    if (right.isEmpty()) return left;
    return (left.isEmpty() && sign == QLatin1Char('/') ? QStringLiteral("1") : left) +
           (left.isEmpty() && sign != QLatin1Char('/') ? QString() : QString(sign)) + right;
}

}  // namespace

QString readingText(const CursorReading& reading, const CurveMeaning& meaning, const QLocale& locale) {
    const QString slopeUnit = meaning.slopeUnit.isEmpty()
                                  ? joined(meaning.yUnit, QLatin1Char('/'), meaning.xUnit)
                                  : meaning.slopeUnit;
    const QString integralUnit = meaning.integralUnit.isEmpty()
                                     ? joined(meaning.yUnit, QChar(0x00b7), meaning.xUnit)
                                     : meaning.integralUnit;
    QStringList parts;
    const auto add = [&](const QString& name, double value, const QString& unit) {
        parts.append(name + QChar(QChar::Nbsp) + quantity(value, unit, locale));
    };
    const bool hasA = !std::isnan(reading.a);
    const bool hasB = !std::isnan(reading.b);
    if (hasA) add(CursorBar::tr("A:"), reading.a, meaning.xUnit);
    if (hasA) add(CursorBar::tr("y(A)"), reading.yA, meaning.yUnit);
    if (hasB) add(CursorBar::tr("B:"), reading.b, meaning.xUnit);
    if (hasB) add(CursorBar::tr("y(B)"), reading.yB, meaning.yUnit);
    if (hasA && hasB) {
        add(CursorBar::tr("Δx"), reading.b - reading.a, meaning.xUnit);
        add(CursorBar::tr("Δy"), reading.yB - reading.yA, meaning.yUnit);
        add(CursorBar::tr("slope"), reading.slope, slopeUnit);
        add(CursorBar::tr("mean"), reading.mean, meaning.yUnit);
        add(CursorBar::tr("integral"), reading.integral, integralUnit);
    }
    return parts.join(QStringLiteral(" · "));
}

CursorBar::CursorBar(QWidget* parent)
    : QFrame(parent), m_choice(new QComboBox(this)), m_text(new QLabel(this)) {
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    m_choice->setObjectName(QStringLiteral("readCurve"));
    m_choice->setAccessibleName(tr("Curve read at the cursors"));
    m_choice->setToolTip(tr("The curve that is read; a click on a curve chooses it"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_text->setObjectName(QStringLiteral("cursorReadout"));
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setToolTip(
        tr("Values at the cursors A and B. Slope: of the straight line between them. Mean and\n"
           "integral: of the curve itself, from A to B."));
    auto* close = new QToolButton(this);
    close->setAutoRaise(true);
    close->setText(QStringLiteral("×"));
    close->setAccessibleName(tr("Remove the cursors A and B"));
    close->setToolTip(close->accessibleName());
    connect(close, &QToolButton::clicked, this, &CursorBar::closed);
    connect(m_choice, &QComboBox::activated, this,
            [this](int index) { emit curveChosen(m_curves.at(index)); });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 4, 2);
    layout->addWidget(m_choice);
    layout->addWidget(m_text, 1);
    layout->addWidget(close);
}

void CursorBar::setCurves(const QList<QCPGraph*>& curves, const QCPGraph* chosen) {
    QStringList names;
    for (const QCPGraph* curve : curves) names.append(curve->name());
    QStringList present;
    for (int i = 0; i < m_choice->count(); ++i) present.append(m_choice->itemText(i));
    m_curves = curves;
    const QSignalBlocker quiet(m_choice);
    if (names != present) {
        m_choice->clear();
        m_choice->addItems(names);
    }
    m_choice->setCurrentIndex(static_cast<int>(curves.indexOf(const_cast<QCPGraph*>(chosen))));
}

void CursorBar::setText(const QString& text) {
    m_text->setText(text);
    // The text is the name too: a name of its own would be read in its place.
    m_text->setAccessibleName(tr("Cursors: %1").arg(text));
}

QString CursorBar::text() const {
    return m_text->text();
}

}  // namespace drillwave
