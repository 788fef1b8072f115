// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of values of either sign.
#include <QColor>
#include <QTest>
#include <cmath>

#include "ui/plot/colour_scale.h"

using namespace drillwave;

namespace {

// Relative luminance (WCAG 2).
double luminance(QRgb colour) {
    const auto linear = [](int byte) {
        const double value = byte / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

// CIE lightness, 0 … 100.
double lightness(QRgb colour) {
    const double y = luminance(colour);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

}  // namespace

class TestColourScale : public QObject {
    Q_OBJECT

  private slots:
    void zeroIsInTheMiddleAndHasNoColour() {
        for (const ColourScale& scale : {ColourScale::onLight(), ColourScale::onDark()}) {
            const QColor zero = QColor::fromRgb(scale.colour(0));
            QVERIFY(zero.saturation() < 12);
        }
        QVERIFY(lightness(ColourScale::onLight().colour(0)) > 95);
        QVERIFY(lightness(ColourScale::onDark().colour(0)) < 15);
    }

    void bothSidesAreEquallyFarFromZeroAndChangeEvenly() {
        for (const ColourScale& scale : {ColourScale::onLight(), ColourScale::onDark()}) {
            const double zero = lightness(scale.colour(0)), whole = lightness(scale.colour(1)) - zero;
            QVERIFY(std::abs(whole) > 40);
            for (double share = 0.05; share <= 1; share += 0.05) {
                const double up = (lightness(scale.colour(share)) - zero) / whole;
                const double down = (lightness(scale.colour(-share)) - zero) / whole;
                // The scale is even in the lightness of Oklab, from which that of CIE departs by so much on
                // the way to a strong blue and orange.
                QVERIFY2(std::abs(up - down) < 0.12, QByteArray::number(share).constData());
                QVERIFY2(std::abs(up - share) < 0.15, QByteArray::number(share).constData());
            }
        }
    }

    // Blue against orange: who sees no red or no green still sees these apart, by their blue.
    void theSignsDifferForTheColourBlind() {
        for (const ColourScale& scale : {ColourScale::onLight(), ColourScale::onDark()})
            for (const double share : {0.4, 0.6, 0.8, 1.0}) {
                const QRgb below = scale.colour(-share), above = scale.colour(share);
                QVERIFY(qBlue(below) - qBlue(above) > 50);
                QVERIFY(qBlue(below) > qRed(below) && qRed(above) > qBlue(above));
            }
    }

    void outsideAreTheColoursOfTheEndsAndNothingIsTransparent() {
        const ColourScale scale = ColourScale::onLight();
        QCOMPARE(scale.colour(7), scale.colour(1));
        QCOMPARE(scale.colour(-7), scale.colour(-1));
        QCOMPARE(qAlpha(scale.colour(std::nan(""))), 0);
        QCOMPARE(qAlpha(scale.colour(0.3)), 255);
    }

    void theBarShowsTheSameColours() {
        const ColourScale scale = ColourScale::onDark();
        QCPColorGradient bar = scale.gradient();
        for (const double share : {-1.0, -0.5, 0.0, 0.25, 1.0}) {
            const QRgb shown = bar.color(share, QCPRange(-1, 1)), expected = scale.colour(share);
            QVERIFY(std::abs(qRed(shown) - qRed(expected)) < 4);
            QVERIFY(std::abs(qGreen(shown) - qGreen(expected)) < 4);
            QVERIFY(std::abs(qBlue(shown) - qBlue(expected)) < 4);
        }
    }
};

QTEST_MAIN(TestColourScale)
#include "tst_colour_scale.moc"
