// SPDX-License-Identifier: GPL-3.0-or-later
// Common features of the plots of all pages, which their frame gives.
#include <qcustomplot.h>

#include <QTest>

#include "ui/plot/curve_graph.h"
#include "ui/plot/study_frame.h"

using namespace drillwave;

namespace {

/// A line from 0 to 1 with a word on it.
class LinePlot : public StudyFrame {
  public:
    explicit LinePlot(QCustomPlot* plot) : StudyFrame(plot) {
        layOutAnew();
        addHeader(4);
        view(newAxisRect(*plot, Sides::free));
        plot->plotLayout()->addElement(1, 0, m_rect);
        line = addCurve(x(), y());
        addHere();
        addRunMarks();
        addRunCurves();
        word = addText(m_rect, QMargins(), Qt::AlignCenter);
        level = addLevel(m_rect);
        setStyle(PlotStyle::forPaper());
    }
    void present(double height, bool hasOtherAxes) {
        line->setData({0, 1}, {0, height});
        m_summary = QStringLiteral("a line");
        finish(hasOtherAxes);
    }
    double top() const { return y()->range().upper; }
    void zoom() { y()->setRange(0, 100); }
    bool hasHere() const { return here().place().has_value(); }

    QCPGraph* line = nullptr;
    QCPItemText* word = nullptr;
    QCPItemStraightLine* level = nullptr;

  private:
    void clear() override { line->data()->clear(); }
    void restyle() override { line->setPen(m_style.linePen(0)); }
    void setRanges() override {
        bool found = false;
        const QCPRange values = line->getValueRange(found);
        if (found) y()->setRange(values);
    }
};

}  // namespace

class TestStudyFrame : public QObject {
    Q_OBJECT

  private slots:
    void aViewStaysAsItWasChosen();
    void nothingHasItsReasonAlone();
    void wordsTakeFontAndColourOfTheStyle();
    void aLevelWithoutAValueIsHidden();
    void axesStandOnTheirLayersInOneOrder();
};

void TestStudyFrame::aViewStaysAsItWasChosen() {
    QCustomPlot plot;
    LinePlot shown(&plot);
    shown.present(2, false);
    QCOMPARE(shown.top(), 2.0);
    shown.zoom();
    shown.present(3, false);
    QCOMPARE(shown.top(), 100.0);
    shown.present(3, true);  // in other units
    QCOMPARE(shown.top(), 3.0);
    shown.zoom();
    shown.fitUnlessZoomed();
    QCOMPARE(shown.top(), 100.0);
    shown.fit();
    QCOMPARE(shown.top(), 3.0);
}

void TestStudyFrame::nothingHasItsReasonAlone() {
    QCustomPlot plot;
    LinePlot shown(&plot);
    shown.present(2, false);
    shown.setHere(0.5, 1);
    const GraphData run = GraphData::create();
    run->set({{0, 1}, {1, 1}}, true);
    shown.setRuns({{0, QStringLiteral("A"), {0.5, 1}}}, {{0, QStringLiteral("A"), run}});
    QCOMPARE(shown.runMarks().size(), 1);
    QCOMPARE(shown.runCurves().size(), 1);
    QVERIFY(shown.hasHere());
    shown.showNothing(QStringLiteral("no rod"));
    QCOMPARE(shown.textSummary(), QStringLiteral("no rod"));
    QCOMPARE(shown.line->dataCount(), 0);
    QVERIFY(shown.runMarks().isEmpty());
    QVERIFY(shown.runCurves().isEmpty());
    QVERIFY(!shown.hasHere());
    const auto* message = plot.findChild<PlotMessage*>();
    QVERIFY(message->item().visible());
    shown.present(2, false);
    QVERIFY(!message->item().visible());
}

void TestStudyFrame::wordsTakeFontAndColourOfTheStyle() {
    QCustomPlot plot;
    LinePlot shown(&plot);
    PlotStyle style = PlotStyle::forPaper();
    style.text = Qt::red;
    style.font.setPixelSize(21);
    shown.setStyle(style);
    QCOMPARE(shown.word->color(), QColor(Qt::red));
    QCOMPARE(shown.word->font().pixelSize(), 21);
    plot.removeItem(shown.word);
    shown.setStyle(PlotStyle::forPaper());  // nobody asks for the one that has gone
    QCOMPARE(shown.line->pen(), PlotStyle::forPaper().linePen(0));
}

void TestStudyFrame::aLevelWithoutAValueIsHidden() {
    QCustomPlot plot;
    const LinePlot shown(&plot);
    QVERIFY(!shown.level->visible());
    setLevel(*shown.level, 0.5);
    QVERIFY(shown.level->visible());
    QCOMPARE(shown.level->point2->coords(), QPointF(1, 0.5));
    setLevel(*shown.level, {});
    QVERIFY(!shown.level->visible());
}

void TestStudyFrame::axesStandOnTheirLayersInOneOrder() {
    QCustomPlot plot;
    const LinePlot shown(&plot);
    const QCPAxisRect& rect = *plot.axisRect();
    QList<QCPLayerable*> wanted;
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atTop, QCPAxis::atBottom})
        wanted << rect.axis(side);
    QCOMPARE(plot.layer(QStringLiteral("axes"))->children(), wanted);
}

QTEST_MAIN(TestStudyFrame)
#include "tst_study_frame.moc"
