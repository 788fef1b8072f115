// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of one step of a slider that is held: one check of the scenario, two copies of it at most.
#include <QTest>
#include <cstdlib>
#include <new>

#include "tests/support/panel_fixture.h"
#include "ui/form/quantity_slider.h"

using namespace drillwave;

namespace {

/// A title that no other text is as long as: every copy of a scenario allocates exactly this.
constexpr std::size_t titleLength = 7919;
int titlesCopied = 0;

}  // namespace

void* operator new(std::size_t size) {
    if (size == titleLength + 1) ++titlesCopied;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

class TestSliderStep : public QObject {
    Q_OBJECT

  private slots:
    void aStepChecksOnceAndCopiesAtMostTwice_data();
    void aStepChecksOnceAndCopiesAtMostTwice();
    void theMenuOfShapesIsRightWhenTheSliderIsLetGo();
};

void TestSliderStep::aStepChecksOnceAndCopiesAtMostTwice_data() {
    QTest::addColumn<QByteArray>("slider");
    QTest::newRow("physical") << QByteArray("bit_rock.gamma.slider");
    QTest::newRow("group") << QByteArray("beta.slider");
}

void TestSliderStep::aStepChecksOnceAndCopiesAtMostTwice() {
    QFETCH(QByteArray, slider);
    PanelFixture fixture;
    fixture.document.setTitle(QString(titleLength, QLatin1Char('t')));
    auto& held = fixture.find<QuantitySlider>(slider.constData());
    held.setSliderDown(true);
    int steps = 0;
    for (const double part : {0.3, 0.5, 0.4, 0.6}) {
        const Scenario before = fixture.document.scenario();
        fixture.checks = 0;
        titlesCopied = 0;
        held.setSliderPosition(held.minimum() + static_cast<int>(part * (held.maximum() - held.minimum())));
        QCOMPARE(fixture.checks, 1);
        QVERIFY2(titlesCopied >= 1 && titlesCopied <= 2, qPrintable(QString::number(titlesCopied)));
        if (fixture.document.scenario() != before) ++steps;
    }
    QCOMPARE(steps, 4);
    held.setSliderDown(false);
}

void TestSliderStep::theMenuOfShapesIsRightWhenTheSliderIsLetGo() {
    PanelFixture fixture;
    QVERIFY(PanelFixture::choose(fixture.find<QComboBox>("pulse.shape"), QStringLiteral("trapezoid")));
    auto& shapes = fixture.find<QComboBox>("pulse.shape");
    const int possible = shapes.count();
    auto& held = fixture.find<QuantitySlider>("rod.length.slider");
    held.setSliderDown(true);
    held.setSliderPosition(held.maximum());
    held.setSliderDown(false);
    QVERIFY(fixture.checks > 1);
    QCOMPARE(shapes.count(), possible);
    QCOMPARE(shapes.currentText(), QStringLiteral("trapezoid"));
}

QTEST_MAIN(TestSliderStep)
#include "tst_slider_step.moc"
