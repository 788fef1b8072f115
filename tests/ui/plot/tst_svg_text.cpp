// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in SVG that readers without our fonts can show.
#include <QTest>

#include "ui/plot/svg_text.h"

using namespace drillwave;

class TestSvgText : public QObject {
    Q_OBJECT

  private slots:
    void subscriptsAreLettersBelowTheLine();
    void theLineGoesOnWhereItWas();
    void commonSignsAndMarkupStay();
    void theFamilyHasCommonOnesBehindIt();
};

namespace {

QString converted(const char* text) {
    return QString::fromUtf8(withCommonText(QByteArray("<g><text x=\"1\">") + text + "</text></g>",
                                            QStringLiteral("DejaVu Sans")))
        .section(QStringLiteral("<text x=\"1\">"), 1)
        .section(QStringLiteral("</text>"), 0, 0);
}

}  // namespace

void TestSvgText::subscriptsAreLettersBelowTheLine() {
    QCOMPARE(converted("N₀ₚ"), QStringLiteral("N<tspan dy=\"0.25em\" font-size=\"70%\">0p</tspan>"));
    QCOMPARE(converted("10⁻⁵"), QStringLiteral("10<tspan dy=\"-0.5em\" font-size=\"70%\">−5</tspan>"));
}

// 0.25 em of letters of 0.7 em down, and as much up again.
void TestSvgText::theLineGoesOnWhereItWas() {
    QCOMPARE(converted("time t / t₀ [ms]"),
             QStringLiteral("time t / t<tspan dy=\"0.25em\" font-size=\"70%\">0</tspan>"
                            "<tspan dy=\"-0.175em\"> [ms]</tspan>"));
    QCOMPARE(converted("t₀ I₀"), QStringLiteral("t<tspan dy=\"0.25em\" font-size=\"70%\">0</tspan>"
                                                "<tspan dy=\"-0.175em\"> I</tspan>"
                                                "<tspan dy=\"0.25em\" font-size=\"70%\">0</tspan>"));
}

void TestSvgText::commonSignsAndMarkupStay() {
    QCOMPARE(converted("kg/m³"), QStringLiteral("kg/m³"));
    QCOMPARE(converted("a &lt; b"), QStringLiteral("a &lt; b"));
    const QByteArray title = "<title>N₀ₚ</title><path d=\"M0\"/>";
    QCOMPARE(withCommonText(title, QStringLiteral("X")), title);
}

void TestSvgText::theFamilyHasCommonOnesBehindIt() {
    QCOMPARE(withCommonText("<text font-family=\"DejaVu Sans\" font-size=\"9\">a</text>",
                            QStringLiteral("DejaVu Sans")),
             QByteArray(
                 "<text font-family=\"DejaVu Sans, Arial, Helvetica, sans-serif\" font-size=\"9\">a</text>"));
}

QTEST_GUILESS_MAIN(TestSvgText)
#include "tst_svg_text.moc"
