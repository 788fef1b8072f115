// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a blow as files: what is in them, in which size, and the same bytes every time.
#include <QImage>
#include <QTest>

#include "core/blow/blow.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/svg_texts.h"
#include "ui/export/plot_export.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"

using namespace drillwave;

namespace {

using Formats = std::vector<std::string>;
const Formats allFormats(pictureFormats.begin(), pictureFormats.end());

Blow solved(const Scenario& scenario, Detail detail = Detail::histories) {
    return solveBlow(scenario, {}, detail);
}

// The one of that name; empty when there is none.
QByteArray picture(const Pictures& pictures, const char* name) {
    for (const NamedFile& file : pictures.files)
        if (file.name == name) return QByteArray::fromStdString(file.bytes);
    return {};
}

QString textsOf(const QByteArray& svg) {
    return test::svgTexts(svg).join(QLatin1Char('\n'));
}

// Pixels of that very colour in a band of rows.
int count(const QImage& image, QColor color, double from, double to) {
    int found = 0;
    for (int y = int(from * image.height()); y < int(to * image.height()); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y) == color) ++found;
    return found;
}

}  // namespace

class TestPlotExport : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyFormatIsDrawn();
    void thePngShowsFourPlotsOnWhite();
    void theSvgNamesFourPlotsWithTheirUnits();
    void aStringHasAllPictures();
    void pngAndSvgAreTheSameBytesEveryTime();
    void filesDoNotDependOnTheLocale();
    void aStopEndsTheDrawing();
    void failuresAreToldInOneLine_data();
    void failuresAreToldInOneLine();

  private:
    Pictures drawn(const Formats& formats) const { return drawBlowPlots(solved(m_scenario), formats); }
    Scenario m_scenario;
};

void TestPlotExport::everyFormatIsDrawn() {
    const Pictures pictures = drawn(allFormats);
    QCOMPARE(pictures.problem, QString());
    QCOMPARE(pictures.files.size(), std::size_t{12});
    for (const NamedFile& file : pictures.files) QVERIFY2(file.bytes.size() > 2000, file.name.c_str());
    QVERIFY(picture(pictures, "blow.pdf").startsWith("%PDF-"));
}

void TestPlotExport::thePngShowsFourPlotsOnWhite() {
    const QImage image = QImage::fromData(picture(drawn({"png"}), "blow.png"));
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    QVERIFY(image.width() * 25.4 / 180 >= 150);  // 180 mm wide at 150 dpi or more
    const PlotStyle style = PlotStyle::forPaper();
    for (int plot = 0; plot < 4; ++plot)
        QVERIFY2(count(image, style.lines[0], plot / 4.0, (plot + 1) / 4.0) > 300,
                 qPrintable(QString::number(plot)));
    for (int wave = 1; wave < 4; ++wave) QVERIFY(count(image, style.lines[wave], 0, 0.25) > 50);
}

void TestPlotExport::theSvgNamesFourPlotsWithTheirUnits() {
    const Formats svg{"svg"};
    const QString texts = textsOf(picture(drawn(svg), "blow.svg"));
    for (const char* text :
         {"waves at x/L = 0.50", "N0p", "N1n", "N2p", "N3n", "N, tension + [kN]", "impact force F", "F [kN]",
          "impulse of the impact force I", "I [N s]", "momentum of the rod p", "p [N s]", "time t [ms]"})
        QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    const QString dimensionless = textsOf(picture(drawBlowPlots(solved(scenario), svg), "blow.svg"));
    QVERIFY(dimensionless.contains(QStringLiteral("F / F0")));
    QVERIFY(dimensionless.contains(QStringLiteral("time t / t0")));
}

void TestPlotExport::aStringHasAllPictures() {
    const Blow blow = solved(parseScenario(findExample("r32_string")->text, "r32_string").scenario);
    const Pictures pictures = drawBlowPlots(blow, {"svg"});
    QCOMPARE(pictures.problem, QString());
    QCOMPARE(pictures.files.size(), std::size_t{4});
    for (const char* name : {"wave_picture.svg", "rod.svg"})
        QVERIFY2(textsOf(picture(pictures, name)).contains(QStringLiteral("hammer at x < 0")), name);
    const QString texts = textsOf(picture(pictures, "wave_picture.svg"));
    for (const char* text : {"force N (tension positive) [kN]", "hammer", "coupling", "rod"})
        QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
}

void TestPlotExport::pngAndSvgAreTheSameBytesEveryTime() {
    const Formats formats{"png", "svg"};
    const Pictures first = drawn(formats);
    const Pictures second = drawn(formats);
    for (const char* name : {"blow.png", "blow.svg", "rock.png", "rock.svg", "wave_picture.png",
                             "wave_picture.svg", "rod.png", "rod.svg"}) {
        QVERIFY(!picture(first, name).isEmpty());
        QCOMPARE(picture(first, name), picture(second, name));
    }
}

void TestPlotExport::filesDoNotDependOnTheLocale() {
    const Formats formats{"svg"};
    const QByteArray plain = picture(drawn(formats), "rock.svg");
    QVERIFY(textsOf(plain).contains(QStringLiteral("0.5")));
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    QCOMPARE(picture(drawn(formats), "rock.svg"), plain);
}

void TestPlotExport::aStopEndsTheDrawing() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(drawBlowPlots(solved(m_scenario), allFormats, stop.get_token()).files.empty());
}

void TestPlotExport::failuresAreToldInOneLine_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<bool>("histories");
    QTest::addColumn<QString>("says");
    QTest::newRow("unknown format") << "gif" << true << "png, svg, pdf";
    QTest::newRow("no histories") << "png" << false << "histories";
}

void TestPlotExport::failuresAreToldInOneLine() {
    QFETCH(QString, format);
    QFETCH(bool, histories);
    QFETCH(QString, says);
    const Blow blow = solved(m_scenario, histories ? Detail::histories : Detail::ledger);
    const Pictures pictures = drawBlowPlots(blow, {format.toStdString()});
    QVERIFY(pictures.files.empty());
    QVERIFY2(pictures.problem.contains(says), qPrintable(pictures.problem));
    QVERIFY(!pictures.problem.contains(QLatin1Char('\n')));
}

QTEST_MAIN(TestPlotExport)
#include "tst_plot_export.moc"
