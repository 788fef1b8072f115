// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise polynomials: values, jumps, integrals, and what is cut off.
#include <QTest>

#include "core/numeric/piecewise.h"

using namespace drillwave;

class TestPiecewise : public QObject {
    Q_OBJECT

  private slots:
    void evaluatesEachPieceFromItsStart() {
        PiecewisePolynomial f;
        f.append(2, 2, std::vector<double>{1, 2});  // 1 + x
        f.append(1, 4, std::vector<double>{0, 4});  // x − 2
        QCOMPARE(f.end(), 3.0);
        QCOMPARE(f(0.0), 1.0);
        QCOMPARE(f(1.5), 2.5);
        QCOMPARE(f(2.0), 0.0);  // right-continuous at the jump
        QCOMPARE(f(2.5), 0.5);
        QCOMPARE(f(-0.1), 0.0);
        QCOMPARE(f(3.0), 0.0);
    }

    void integratesOverPieces() {
        PiecewisePolynomial f;
        f.append(2, 2, std::vector<double>{1, 2});
        f.append(1, 1, std::vector<double>{});
        f.append(1, 1, std::vector<double>{0, 1});
        QCOMPARE(f.integral(0.0), 0.0);
        QCOMPARE(f.integral(2.0), 4.0);
        QCOMPARE(f.integral(3.0), 4.0);
        QCOMPARE(f.integral(4.0), 4.5);
        QCOMPARE(f.integral(99.0), 4.5);
    }

    void anEmptyFunctionIsZero() {
        const PiecewisePolynomial f;
        QCOMPARE(f(1.0), 0.0);
        QCOMPARE(f.integral(1.0), 0.0);
    }
};

QTEST_GUILESS_MAIN(TestPiecewise)
#include "tst_piecewise.moc"
