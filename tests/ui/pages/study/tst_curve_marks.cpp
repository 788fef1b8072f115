// SPDX-License-Identifier: GPL-3.0-or-later
// The words beside the marks of a curve: off its lines, and off the markers of other things.
#include <QTest>

#include "ui/plot/curve_marks.h"

using namespace drillwave;

namespace {

/// A plot whose only curve has two points, with the words of a mark in its middle.
struct Plot {
    QCustomPlot plot;
    QCPGraph* graph = plot.addGraph();
    CurveMarks marks{graph};

    Plot(QPointF from, QPointF to) {
        plot.resize(600, 400);
        plot.xAxis->setRange(0, 10);
        plot.yAxis->setRange(0, 10);
        graph->setData({from.x(), to.x()}, {from.y(), to.y()});
        marks.present({{CurveMark::Kind::extreme, (from + to) / 2}}, {}, {});
        plot.replot();
        plot.replot();  // words are placed once the axes are
    }
    QCPItemText& words() const {
        for (int i = 0; i < plot.itemCount(); ++i)
            if (auto* text = qobject_cast<QCPItemText*>(plot.item(i))) return *text;
        qFatal("there are no words");
    }
    /// Where they stand, without the space about them.
    QRectF box() const {
        const QMarginsF space(words().padding());
        return QRectF(words().topLeft->pixelPosition(), words().bottomRight->pixelPosition())
            .marginsRemoved(space);
    }
    QPointF pixel(QPointF at) const { return graph->coordsToPixels(at.x(), at.y()); }
};

}  // namespace

class TestCurveMarks : public QObject {
    Q_OBJECT

  private slots:
    void wordsKeepOffALineBetweenItsPoints_data() {
        QTest::addColumn<QPointF>("from");
        QTest::addColumn<QPointF>("to");
        QTest::newRow("rising") << QPointF(0, 3) << QPointF(10, 7);
        QTest::newRow("falling") << QPointF(0, 7) << QPointF(10, 3);
    }
    void wordsKeepOffALineBetweenItsPoints() {
        QFETCH(QPointF, from);
        QFETCH(QPointF, to);
        const Plot drawn(from, to);
        QVERIFY(drawn.words().visible());
        for (int i = 0; i <= 1000; ++i) {
            const double share = i / 1000.0;
            QVERIFY(!drawn.box().contains(drawn.pixel(from + share * (to - from))));
        }
    }

    /// Marks an extreme with kinks on either side of it.
    void wordsKeepOffOtherMarksOfTheirCurve() {
        Plot drawn({0, 5}, {10, 5});
        const QPointF extreme(5, 5);
        drawn.marks.present({{CurveMark::Kind::extreme, extreme}}, {}, {});
        drawn.plot.replot();
        drawn.plot.replot();
        const QPointF middle = drawn.box().center();
        const QPointF there(drawn.plot.xAxis->pixelToCoord(middle.x()),
                            drawn.plot.yAxis->pixelToCoord(middle.y()));
        drawn.marks.present({{CurveMark::Kind::extreme, extreme}, {CurveMark::Kind::kink, there}}, {}, {});
        drawn.plot.replot();
        drawn.plot.replot();
        QVERIFY(!drawn.words().visible() || !drawn.box().contains(middle));
    }

    void wordsKeepOffMarkersOfOtherThings() {
        Plot drawn({0, 3}, {10, 7});
        const QPointF centre = drawn.box().center();
        auto* marker = new QCPItemTracer(&drawn.plot);
        marker->setStyle(QCPItemTracer::tsCircle);
        marker->setSize(11);
        marker->setClipAxisRect(drawn.plot.axisRect());
        marker->position->setType(QCPItemPosition::ptAbsolute);
        marker->position->setCoords(centre);
        drawn.plot.replot();
        QVERIFY(!drawn.words().visible() || !drawn.box().contains(centre));
    }
};

QTEST_MAIN(TestCurveMarks)
#include "tst_curve_marks.moc"
