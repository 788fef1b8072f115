// SPDX-License-Identifier: GPL-3.0-or-later
// The strip below a plot that reads a curve between the cursors.
#pragma once

#include <qcustomplot.h>

#include <QFrame>
#include <QLocale>

#include "ui/plot/curve_reading.h"

class QComboBox;
class QLabel;

namespace drillwave {

/// What the cursors say about a curve, in words: "A 1.2 ms · B 3.4 ms · Δ 2.2 ms · at A 10 kN …". A cursor
/// that is not placed has an x of NaN.
QString readingText(const CursorReading& reading, const CurveMeaning& meaning, const QLocale& locale);

/// Names the curve, to be chosen among the visible ones, and what is read from it.
class CursorBar : public QFrame {
    Q_OBJECT

  public:
    explicit CursorBar(QWidget* parent);

    /// The curves to choose from; `chosen` is one of them, or nullptr when there are none.
    void setCurves(const QList<QCPGraph*>& curves, const QCPGraph* chosen);
    void setText(const QString& text);
    QString text() const;

  signals:
    void curveChosen(QCPGraph* curve);
    void closed();

  private:
    QComboBox* m_choice;
    QLabel* m_text;
    QList<QCPGraph*> m_curves;
};

}  // namespace drillwave
