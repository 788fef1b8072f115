// SPDX-License-Identifier: GPL-3.0-or-later
// The icon of the program: what is still seen of it when it is small, on any ground.
#include <QTest>

#include "ui/window/program_icon.h"

using namespace drillwave;

class TestProgramIcon : public QObject {
    Q_OBJECT

  private slots:
    void thereIsOneInEveryWidth() {
        const QIcon icon = programIcon();
        QCOMPARE(icon.availableSizes().size(), qsizetype(iconWidths.size()));
        for (const int width : iconWidths) QCOMPARE(icon.pixmap(width, width).width(), width);
    }

    void partsAreToldApartInEveryWidth() {
        for (const int width : iconWidths) {
            const QImage image = programImage(width);
            const auto at = [&](double x, double y) {
                return image.pixelColor(int(x * width), int(y * width));
            };
            QVERIFY2(image.pixelColor(0, 0).alpha() < 64, "corners let the ground through");
            const QColor rod = at(0.5, 0.42);
            const QColor wave = at(0.5, 0.25);
            const QColor sky = at(0.2, 0.3);
            const QColor rock = at(0.15, 0.6);
            QVERIFY(rod.lightness() > 200 && sky.lightness() < 80);
            QVERIFY(wave.saturation() > 150 && wave.hue() > 25 && wave.hue() < 55);
            QVERIFY(rock.lightness() > sky.lightness() + 30 && rock.lightness() < rod.lightness() - 60);
        }
    }
};

QTEST_MAIN(TestProgramIcon)
#include "tst_program_icon.moc"
