// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog with a figure of the paper, computed again, and the numbers printed in the paper beside the exact
// ones.
#pragma once

#include <QDialog>
#include <vector>

#include "core/study/paper/discrepancies.h"
#include "core/study/paper/figure_data.h"

class QCustomPlot;
class QTableWidget;

namespace drillwave {

class FigureDialog : public QDialog {
    Q_OBJECT

  public:
    /// Creates the dialog for figure `number` of the paper, and computes this figure within a few hundredths
    /// of a second. The numbers are those of core/study/paper/figures.h.
    explicit FigureDialog(int number, QWidget* parent = nullptr);

    const Figure& figure() const { return m_figure; }

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void draw();
    QTableWidget* makeTable(const std::vector<Discrepancy>& numbers);

    Figure m_figure;
    QCustomPlot* m_plot;
};

}  // namespace drillwave
