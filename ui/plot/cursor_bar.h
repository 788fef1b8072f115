// SPDX-License-Identifier: GPL-3.0-or-later
// The strip below a plot that shows readings of a curve at the cursors A and B, or in the view if neither is
// placed.
#pragma once

#include <qcustomplot.h>

#include <QFrame>
#include <QPointer>

#include "ui/plot/reading_cells.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace drillwave {

class CurveChoice;

/// Strip with a list to choose one of the visible curves and a table of the readings of that curve. Its
/// height depends only on its width, never on the text.
class CursorBar : public QFrame {
    Q_OBJECT

  public:
    explicit CursorBar(QWidget* parent);

    /// Sets the curves that the list of the strip offers. `chosen` is the one to select, or nullptr if the
    /// list is empty.
    void setCurves(const QList<QCPGraph*>& curves, const QCPGraph* chosen);
    /// Source of the readings in the table: the cursors A and B, or the part of the curve in view.
    enum class Of { cursors, view };
    /// Shows the readings in the table; `of` says whether they are those at the cursors or those of the curve
    /// in view. Requires exactly readingCellCount cells.
    void present(const ReadingCells& cells, Of of);
    /// Returns all readings of the table in one line of text.
    QString text() const { return m_text; }
    /// Copies the table with all digits to the clipboard, as tab-separated text.
    void copy() const;
    /// Enables or disables the button of the strip that copies the readings.
    void setCopyEnabled(bool enabled);
    /// Returns the height [px] that the strip needs at this width [px]. It has two lines of text, or three if
    /// it is narrower. In the narrowest form the list of curves takes a further line.
    int heightFor(int width) const;

  signals:
    void curveChosen(QCPGraph* curve);
    void closed();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Arrangement of the table beside the list of curves: in five columns (`wide`) or three (`usual`), or in
    /// three columns below the list (`narrow`).
    enum class Form { wide, usual, narrow };
    int leastWidth(Form form) const;
    Form formFor(int width) const;
    void arrange();
    void arrangeNarrow();
    void fitChoice();
    void writeCells();

    CurveChoice* m_choice;
    QGridLayout* m_grid;
    QList<QLabel*> m_labels;
    QToolButton* m_copy;
    QToolButton* m_close;
    Form m_form = Form::usual;
    QList<QPointer<QCPGraph>> m_curves;  // curves to choose from; the plot may delete them
    ReadingCells m_cells;
    QString m_text;
};

}  // namespace drillwave
