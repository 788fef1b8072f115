// SPDX-License-Identifier: GPL-3.0-or-later
#include <qcustomplot.h>

#include <QAction>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/study/paper/figures.h"
#include "tests/support/window.h"
#include "ui/window/figure_dialog.h"

using namespace drillwave;
using namespace drillwave::test;

class TestFigureDialog : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { keepSettingsIn(m_folder.path()); }
    void everyFigureOpensFromTheExamples_data();
    void everyFigureOpensFromTheExamples();
    void printedNumbersStandBesideExactOnes();

  private:
    QTemporaryDir m_folder;
};

void TestFigureDialog::everyFigureOpensFromTheExamples_data() {
    QTest::addColumn<int>("number");
    for (int number = firstPaperFigure; number <= lastPaperFigure; ++number)
        QTest::addRow("Fig. %d", number) << number;
}

// Every curve of its data that has a line is drawn, in a panel of its own with axes that hold it; the
// scenario of the window stays.
void TestFigureDialog::everyFigureOpensFromTheExamples() {
    QFETCH(int, number);
    ScriptedAnswers answers;
    const auto window = newWindow(answers);
    window->show();
    const QString before = window->windowTitle();
    const QString entry = QStringLiteral("Figure &%1: ").arg(number);
    for (QAction* action : window->findChildren<QAction*>())
        if (action->text().startsWith(entry)) action->trigger();
    const auto* dialog = window->findChild<FigureDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QCOMPARE(dialog->figure().number, number);
    QCOMPARE(window->windowTitle(), before);
    const auto* plot = dialog->findChild<QCustomPlot*>();
    QCOMPARE(plot->axisRectCount(), static_cast<int>(dialog->figure().panels.size()));
    int drawn = 0;
    for (std::size_t i = 0; i < dialog->figure().panels.size(); ++i) {
        const FigurePanel& panel = dialog->figure().panels[i];
        const QCPRange range = plot->axisRect(static_cast<int>(i))->axis(QCPAxis::atBottom)->range();
        for (const FigureCurve& curve : panel.curves) {
            if (curve.line == FigureCurve::Line::none) continue;
            const QCPGraph* graph = plot->graph(drawn++);
            QCOMPARE(graph->data()->size(), static_cast<int>(curve.x.size()));
            QVERIFY(range.contains(curve.x.front()) && range.contains(curve.x.back()));
        }
    }
    QCOMPARE(plot->graphCount(), drawn);
}

// Fig. 6 prints e of 1.414 and that of 0.971, which with one of two normalisations is elsewhere. Both numbers
// stand in the decimal sign of the reader.
void TestFigureDialog::printedNumbersStandBesideExactOnes() {
    const FigureDialog dialog(6);
    const auto* table = dialog.findChild<QTableWidget*>(QStringLiteral("printedNumbers"));
    QVERIFY(table);
    const QString point = dialog.locale().decimalPoint();
    QCOMPARE(table->item(0, 1)->text(), "1" + point + "414");
    QCOMPARE(table->item(0, 2)->text(), "1" + point + "41407");
    int different = 0;
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 3)->text().startsWith(QStringLiteral("differs"))) ++different;
    QCOMPARE(different, 2);
    QVERIFY(!FigureDialog(3).findChild<QTableWidget*>());
}

QTEST_MAIN(TestFigureDialog)
#include "tst_figure_dialog.moc"
