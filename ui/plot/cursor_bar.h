// SPDX-License-Identifier: GPL-3.0-or-later
// The strip below a plot that reads a curve: between the cursors, or what is in view while there are none.
#pragma once

#include <qcustomplot.h>

#include <QFrame>
#include <QPointer>

#include "ui/plot/reading_cells.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace drillwave {

/// Names the curve, chosen among the visible ones, and shows its readings in a table. The height depends only
/// on the width, never on the text.
class CursorBar : public QFrame {
    Q_OBJECT

  public:
    explicit CursorBar(QWidget* parent);

    /// The curves to choose from; `chosen` is one of them, or nullptr when there are none.
    void setCurves(const QList<QCPGraph*>& curves, const QCPGraph* chosen);
    enum class Of { cursors, view };
    /// Requires readingCellCount cells.
    void present(const ReadingCells& cells, Of of);
    /// The cells in one line.
    QString text() const { return m_text; }
    /// Puts the table into the clipboard.
    void copy() const;
    /// Whether the user may copy it.
    void setCopyEnabled(bool enabled);
    /// [px] for a width [px]: two lines, three where that is narrow, four where
    /// the curve has a line of its own.
    int heightFor(int width) const;

  signals:
    void curveChosen(QCPGraph* curve);
    void closed();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// The cells beside the curve in five columns or in three, or in three below it.
    enum class Form { wide, usual, narrow };
    int leastWidth(Form form) const;
    Form formFor(int width) const;
    void arrange();
    void arrangeNarrow();
    void writeCells();

    QComboBox* m_choice;
    QGridLayout* m_grid;
    QList<QLabel*> m_labels;
    QToolButton* m_copy;
    QToolButton* m_close;
    Form m_form = Form::usual;
    QList<QPointer<QCPGraph>> m_curves;  // a plot may be rebuilt before it is drawn, and read, again
    ReadingCells m_cells;
    QString m_text;
};

}  // namespace drillwave
