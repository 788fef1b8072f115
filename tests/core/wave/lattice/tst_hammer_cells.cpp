// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer force over the steps of a lattice.
#include <QTest>

#include "core/numeric/compensated_sum.h"
#include "core/wave/lattice/hammer_cells.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestHammerCells : public QObject {
    Q_OBJECT

  private slots:
    void impulseIsKeptByStepsThatDoNotDivideThePulse_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("step");
        for (const PulseShape shape : {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine,
                                       PulseShape::trapezoid, PulseShape::exponential, PulseShape::piston})
            for (const double step : {0.001, 0.01, 0.0123456789, 1 / 3.0, 0.7, 60.0})
                QTest::addRow("%s, step %g", std::string(name(shape)).c_str(), step)
                    << static_cast<int>(shape) << step;
    }

    void impulseIsKeptByStepsThatDoNotDivideThePulse() {
        QFETCH(int, shape);
        QFETCH(double, step);
        const PulseForce pulse = pulseForceOf(static_cast<PulseShape>(shape), 2);
        HammerCells cells(pulse, step);
        CompensatedSum<double> sum;
        double most = 0;
        for (int i = 0; !cells.ended(); ++i) {
            const double mean = cells.next();
            QVERIFY(mean >= 0);
            // the mean of step i lies where the force does: at the middle to second order
            if (step < 0.002) {
                const double middle = (i + 0.5) * step;
                QVERIFY(std::abs(mean - pulse(middle)) < 1e-5);
            }
            sum += mean;
            most = std::max(most, mean);
        }
        // rounding of the times at which the steps meet
        QVERIFY2(std::abs(sum * step - 1) < 1e-14, qPrintable(QString::number(sum * step - 1)));
        QVERIFY(most <= pulse.peak * (1 + 1e-12));
        QCOMPARE(cells.next(), 0.0);
    }

    void aConstantForceIsExactlyConstant() {
        // noise of a difference of impulses would make a rock at rest load and unload
        const PulseForce pulse = pulseForceOf(PulseShape::rectangular);
        HammerCells cells(pulse, 0.001);
        for (int i = 0; i < 1000; ++i) QCOMPARE(cells.next(), 1.0);
        QCOMPARE(cells.next(), 0.0);
        QVERIFY(cells.ended());
    }

    void nothingActsInTheReferenceCase() {
        HammerCells cells(pulseForceOf(PulseShape::rigidBody), 0.1);
        QVERIFY(cells.ended());
        QCOMPARE(cells.next(), 0.0);
    }
};

QTEST_GUILESS_MAIN(TestHammerCells)
#include "tst_hammer_cells.moc"
