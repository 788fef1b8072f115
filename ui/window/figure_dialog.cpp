// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/figure_dialog.h"

#include <qcustomplot.h>

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/study/paper/figures.h"
#include "ui/export/figure_plot.h"
#include "ui/plot/plot_style.h"
#include "ui/text/number_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr int exactDigits = 6;

/// Returns the numbers that the paper prints with a figure.
std::vector<Discrepancy> numbersOf(int figure) {
    std::vector<Discrepancy> all = discrepancies();
    const std::string name = "Fig. " + std::to_string(figure);
    std::erase_if(all, [&](const Discrepancy& number) { return !number.place.ends_with(name); });
    return all;
}

}  // namespace

FigureDialog::FigureDialog(int number, QWidget* parent)
    : QDialog(parent), m_figure(paperFigure(number)), m_plot(new QCustomPlot(this)) {
    setWindowTitle(tr("Figure %1 of the paper").arg(number));
    setObjectName(QStringLiteral("paperFigure"));
    auto* caption = new QLabel(figureText(m_figure.caption), this);
    caption->setWordWrap(true);
    m_plot->setAccessibleName(figureText(m_figure.caption));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(caption);
    layout->addWidget(m_plot, 3);
    if (const std::vector<Discrepancy> numbers = numbersOf(number); !numbers.empty())
        layout->addWidget(makeTable(numbers), 1);
    else
        layout->addWidget(new QLabel(tr("The paper prints no number with this figure."), this));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    draw();
    resize(900, 800);
}

QTableWidget* FigureDialog::makeTable(const std::vector<Discrepancy>& numbers) {
    const QStringList headings{tr("number"), tr("printed"), tr("exact"), tr("remark")};
    auto* table = new QTableWidget(static_cast<int>(numbers.size()), static_cast<int>(headings.size()), this);
    table->setObjectName(QStringLiteral("printedNumbers"));
    table->setAccessibleName(tr("Numbers that the paper prints with this figure"));
    table->setHorizontalHeaderLabels(headings);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    for (int row = 0; row < table->rowCount(); ++row) {
        const Discrepancy& number = numbers[static_cast<std::size_t>(row)];
        QString remark = figureText(number.explanation);
        if (!number.agrees()) remark.prepend(remark.isEmpty() ? tr("differs") : tr("differs: "));
        const QStringList cells{figureText(number.quantity),
                                localText(QString::fromStdString(number.printed), locale()),
                                numberText(number.computed, exactDigits, locale()), remark};
        for (int column = 0; column < cells.size(); ++column)
            table->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
    table->horizontalHeader()->setStretchLastSection(true);
    table->resizeColumnsToContents();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // remarks may be long
    return table;
}

void FigureDialog::draw() {
    layOutPanels(*m_plot, m_figure.panels, PlotStyle::forScreen(palette(), font()), locale());
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void FigureDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) draw();
}

}  // namespace drillwave
