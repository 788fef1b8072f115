#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/wave/exact_solver.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/plot_style.h"

using namespace drillwave;

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Impact solved(const Scenario& scenario, Detail detail = Detail::histories) {
    return ExactSolver().solve(pulseForceOf(scenario), groupsOf(scenario), detail);
}

QString textsOf(const QByteArray& svg) {
    QXmlStreamReader xml(svg);
    QString texts;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::Characters)
            texts += xml.text().toString().trimmed() + QLatin1Char('\n');
    return texts;
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
    void init();
    void everyFormatIsWritten();
    void thePngShowsFourPlotsOnWhite();
    void theSvgNamesFourPlotsWithTheirUnits();
    void pngAndSvgAreTheSameBytesEveryTime();
    void filesDoNotDependOnTheLocale();
    void anExistingFileIsOverwrittenOnlyOnRequest();
    void failuresAreToldInOneLine_data();
    void failuresAreToldInOneLine();

  private:
    Scenario m_scenario;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestPlotExport::init() {
    QLocale::setDefault(QLocale::c());
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestPlotExport::everyFormatIsWritten() {
    QString problem;
    const QString folder = m_folder->filePath(QStringLiteral("new/plots"));
    const QStringList written =
        writeBlowPlots(m_scenario, solved(m_scenario), folder, plotFormats(), false, &problem);
    QCOMPARE(problem, QString());
    QCOMPARE(written.size(), 6);
    for (const QString& path : written) QVERIFY2(bytesOf(path).size() > 2000, qPrintable(path));
    QVERIFY(bytesOf(folder + QStringLiteral("/blow.pdf")).startsWith("%PDF-"));
}

void TestPlotExport::thePngShowsFourPlotsOnWhite() {
    QString problem;
    writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), {QStringLiteral("png")}, false,
                   &problem);
    const QImage image(m_folder->filePath(QStringLiteral("blow.png")));
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    QVERIFY(image.width() * 25.4 / 180 >= 150);  // 180 mm wide at 150 dpi or more
    const PlotStyle style = PlotStyle::forPaper();
    for (int plot = 0; plot < 4; ++plot)
        QVERIFY2(count(image, style.lines[0], plot / 4.0, (plot + 1) / 4.0) > 300,
                 qPrintable(QString::number(plot)));
    for (int wave = 1; wave < 4; ++wave) QVERIFY(count(image, style.lines[wave], 0, 0.25) > 50);
}

void TestPlotExport::theSvgNamesFourPlotsWithTheirUnits() {
    QString problem;
    writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), {QStringLiteral("svg")}, false,
                   &problem);
    const QString texts = textsOf(bytesOf(m_folder->filePath(QStringLiteral("blow.svg"))));
    for (const char* text :
         {"waves at x/L = 0.50", "N₀ₚ", "N₁ₙ", "N₂ₚ", "N₃ₙ", "N [kN]", "impact force F", "F [kN]",
          "impulse of the impact force I", "I [N s]", "momentum of the rod p", "p [N s]", "time t [ms]"})
        QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    writeBlowPlots(scenario, solved(scenario), m_folder->path(), {QStringLiteral("svg")}, true, &problem);
    const QString dimensionless = textsOf(bytesOf(m_folder->filePath(QStringLiteral("blow.svg"))));
    QVERIFY(dimensionless.contains(QStringLiteral("F / F₀")));
    QVERIFY(dimensionless.contains(QStringLiteral("time t / t₀")));
}

void TestPlotExport::pngAndSvgAreTheSameBytesEveryTime() {
    QString problem;
    const QStringList formats{QStringLiteral("png"), QStringLiteral("svg")};
    const QString first = m_folder->filePath(QStringLiteral("1"));
    const QString second = m_folder->filePath(QStringLiteral("2"));
    writeBlowPlots(m_scenario, solved(m_scenario), first, formats, false, &problem);
    writeBlowPlots(m_scenario, solved(m_scenario), second, formats, false, &problem);
    for (const char* name : {"/blow.png", "/blow.svg", "/rock.png", "/rock.svg"}) {
        QVERIFY(!bytesOf(first + QLatin1String(name)).isEmpty());
        QCOMPARE(bytesOf(first + QLatin1String(name)), bytesOf(second + QLatin1String(name)));
    }
}

void TestPlotExport::filesDoNotDependOnTheLocale() {
    QString problem;
    const QStringList formats{QStringLiteral("svg")};
    writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), formats, false, &problem);
    const QByteArray plain = bytesOf(m_folder->filePath(QStringLiteral("rock.svg")));
    QVERIFY(textsOf(plain).contains(QStringLiteral("0.5")));
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), formats, true, &problem);
    QCOMPARE(bytesOf(m_folder->filePath(QStringLiteral("rock.svg"))), plain);
}

void TestPlotExport::anExistingFileIsOverwrittenOnlyOnRequest() {
    const QString path = m_folder->filePath(QStringLiteral("rock.png"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("mine");
    file.close();
    QString problem;
    const QStringList formats{QStringLiteral("png")};
    QCOMPARE(writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), formats, false, &problem),
             QStringList());
    QVERIFY2(problem.contains(QStringLiteral("rock.png")), qPrintable(problem));
    QCOMPARE(bytesOf(path), QByteArray("mine"));
    QCOMPARE(writeBlowPlots(m_scenario, solved(m_scenario), m_folder->path(), formats, true, &problem).size(),
             2);
    QCOMPARE(problem, QString());
}

void TestPlotExport::failuresAreToldInOneLine_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("format");
    QTest::addColumn<bool>("histories");
    QTest::addColumn<QString>("says");
    QTest::newRow("unknown format") << ""
                                    << "gif" << true << "png, svg, pdf";
    QTest::newRow("a file in place of the folder") << "file"
                                                   << "png" << true << "cannot be made";
    QTest::newRow("no histories") << ""
                                  << "png" << false << "histories";
}

void TestPlotExport::failuresAreToldInOneLine() {
    QFETCH(QString, folder);
    QFETCH(QString, format);
    QFETCH(bool, histories);
    QFETCH(QString, says);
    QFile file(m_folder->filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    QString problem;
    const Impact impact = solved(m_scenario, histories ? Detail::histories : Detail::summary);
    const QStringList written =
        writeBlowPlots(m_scenario, impact, m_folder->filePath(folder), {format}, false, &problem);
    QCOMPARE(written, QStringList());
    QVERIFY2(problem.contains(says), qPrintable(problem));
    QVERIFY(!problem.contains(QLatin1Char('\n')));
}

QTEST_MAIN(TestPlotExport)
#include "tst_plot_export.moc"
