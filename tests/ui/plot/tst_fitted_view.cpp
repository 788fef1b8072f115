// SPDX-License-Identifier: GPL-3.0-or-later
// Fitted until somebody zooms: what counts as that, and what does not.
#include <QSignalSpy>
#include <QTest>

#include "ui/plot/fitted_view.h"

using namespace drillwave;

class TestFittedView : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void aRangeThatIsChangedIsChosen();
    void fittingAndAdjustingAreNobodysChoice();
    void adjustingKeepsWhatWasChosen();
    void inAnEmptyViewNothingIsChosen();

  private:
    std::unique_ptr<QCustomPlot> m_plot;
    std::unique_ptr<FittedView> m_view;
};

void TestFittedView::init() {
    m_plot = std::make_unique<QCustomPlot>();
    m_view = std::make_unique<FittedView>();
    m_view->watch(m_plot->xAxis);
}

void TestFittedView::aRangeThatIsChangedIsChosen() {
    QSignalSpy chosen(m_view.get(), &FittedView::chosen);
    QVERIFY(m_view->isFitted());
    m_plot->yAxis->setRange(2, 3);  // of another view
    QVERIFY(m_view->isFitted());
    m_plot->xAxis->setRange(2, 3);
    QVERIFY(!m_view->isFitted());
    QCOMPARE(chosen.count(), 1);
}

void TestFittedView::fittingAndAdjustingAreNobodysChoice() {
    QSignalSpy chosen(m_view.get(), &FittedView::chosen);
    m_view->adjust([this] { m_plot->xAxis->setRange(2, 3); });
    QVERIFY(m_view->isFitted());
    m_view->fit([this] {
        m_plot->xAxis->setRange(4, 5);
        m_view->adjust([this] { m_plot->xAxis->setRange(6, 7); });
        m_plot->xAxis->setRange(8, 9);
    });
    QVERIFY(m_view->isFitted());
    QCOMPARE(chosen.count(), 0);
}

void TestFittedView::adjustingKeepsWhatWasChosen() {
    m_plot->xAxis->setRange(2, 3);
    m_view->adjust([this] { m_plot->xAxis->setRange(4, 5); });
    QVERIFY(!m_view->isFitted());
    m_view->fit([this] { m_plot->xAxis->setRange(0, 1); });
    QVERIFY(m_view->isFitted());
}

void TestFittedView::inAnEmptyViewNothingIsChosen() {
    m_view->setEmpty(true);
    m_plot->xAxis->setRange(2, 3);
    QVERIFY(m_view->isFitted());
    m_view->setEmpty(false);
    m_plot->xAxis->setRange(4, 5);
    QVERIFY(!m_view->isFitted());
}

QTEST_MAIN(TestFittedView)
#include "tst_fitted_view.moc"
