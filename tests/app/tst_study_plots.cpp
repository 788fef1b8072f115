// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of studies, written without a display: which files, what is in them, what is refused.
#include <QTest>

#include <QDir>
#include <QImage>
#include <QTemporaryDir>

#include "tests/support/program.h"
#include "tests/support/svg_texts.h"

using namespace drillwave::test;

namespace {

QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

/// Without spaces: words in two scripts are written apart.
QString packed(QString text) {
    return text.remove(QChar(QChar::Nbsp)).remove(QLatin1Char(' '));
}

QString textsOf(const QByteArray& svg) {
    return packed(svgTexts(svg).join(QString()));
}

/// Pixels of one of the four colours of curves on paper, the light ones of areas not among them.
int curvePixels(const QImage& image) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb rgb = image.pixel(x, y) & 0xffffff;
            if (rgb == 0x0b62a8 || rgb == 0xb8430a || rgb == 0x00725a || rgb == 0x86358a) ++found;
        }
    return found;
}

}  // namespace

class TestStudyPlots : public QObject {
    Q_OBJECT

  private slots:
    void everyStudyIsDrawn_data();
    void everyStudyIsDrawn();
    void picturesSpeakTheLanguageOfTheCommand();
    void numbersAreTheSameWithPictures();
    void picturesStandBesideTheFile();
    void picturesRespectWhatIsThere();
    void aSweepNamesItsCurves();
    void figuresComeInTheFormatsOfChoice();
    void accuracyIsDrawnIntoItsFolder();
    void accuracyOfAStringIsDrawnIntoItsFolder();
    void aRecordWithItsModelIsDrawnIntoItsFolder();
    void whatCannotBeDrawnIsRefused_data();
    void whatCannotBeDrawnIsRefused();

  private:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QTemporaryDir m_folder;
};

void TestStudyPlots::everyStudyIsDrawn_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QStringList>("texts");  // that a picture holds
    const QString drill = example("t38_medium_rock");
    QTest::newRow("gap") << QStringList{"gap", drill} << QStringList{"gap d [mm]", "COR e", "mean"};
    QTest::newRow("thrust") << QStringList{"thrust", drill, "--along", "drill.blow_frequency=20Hz:100Hz"}
                            << QStringList{"feed force [kN]", "enough in all cases", "fully elastic rock",
                                           "worst gap", "installed 8"};
    QTest::newRow("thrust of a string")
        << QStringList{"thrust", example("t38_string"), "--along", "drill.blow_frequency=20Hz:100Hz:21"}
        << QStringList{"feed force [kN]", "this blow", "rigid rock", "installed"};
    QTest::newRow("gap, scattered") << QStringList{"gap", drill, "--gap-deviation", "0.3 mm"}
                                    << QStringList{"scattered gap", "feed force enough for 95 % of gaps"};
    QTest::newRow("drill") << QStringList{"drill", drill, "--blows", "30", "--cells", "10"}
                           << QStringList{"gap at the blow [mm]", "next gap [mm]", "share of the energy [%]"};
    QTest::newRow("drill, scan") << QStringList{"drill",   drill, "--scan",  "drill.thrust=3kN:8kN:6",
                                                "--blows", "30",  "--cells", "10"}
                                 << QStringList{"penetration rate", "installed feed force [kN]", "(1+2e)"};
    QTest::newRow("sweep") << QStringList{"sweep",     drill,
                                          "--vary",    "rod.length=3m:6m:40",
                                          "--outputs", "cor,peak_force",
                                          "--si"}
                           << QStringList{"length L [m]", "peak force [N]"};
}

void TestStudyPlots::everyStudyIsDrawn() {
    QFETCH(QStringList, words);
    QFETCH(QStringList, texts);
    const QTemporaryDir folder;
    const QString file = folder.filePath("study.csv");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    const Finished finished = run(words + QStringList{"-o", file, "--plots", "png,svg,pdf"}, environment);
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    const QImage image(folder.filePath("study.png"));
    QVERIFY(image.width() > 1000);
    QVERIFY2(curvePixels(image) > 1500, qPrintable(QString::number(curvePixels(image))));
    const QString drawn = textsOf(read(folder.filePath("study.svg")));
    for (const QString& text : texts) QVERIFY2(drawn.contains(packed(text)), qPrintable(text + "\n" + drawn));
    QVERIFY(read(folder.filePath("study.pdf")).startsWith("%PDF-"));
    QVERIFY(read(folder.filePath("study.pdf")).size() > 4000);
}

void TestStudyPlots::picturesSpeakTheLanguageOfTheCommand() {
    const QTemporaryDir folder;
    const auto drawn = [&](const char* name, const QStringList& words) {
        const QString out = folder.filePath(QString::fromLatin1(name));
        const Finished finished = run(words + QStringList{"--plots", "svg", "--language", "de", "-o", out});
        return finished.exitCode == 0 ? out : QString::fromUtf8(finished.error);
    };
    const QString drill = example("t38_medium_rock");
    const QString gap = textsOf(read(drawn("gap.csv", {"gap", drill}).replace(".csv", ".svg")));
    for (const char* text : {"Spaltd[mm]", "Stoßzahle", "0,5"})
        QVERIFY2(gap.contains(QString::fromUtf8(text)), qPrintable(text + ("\n" + gap)));
    const QString blow = textsOf(read(drawn("blow", {"run", drill}) + "/blow.svg"));
    for (const char* text : {"Zeitt[ms]", "0,5"})
        QVERIFY2(blow.contains(QString::fromUtf8(text)), qPrintable(text + ("\n" + blow)));
    // The figures of the paper are in its own, and what scripts read is as ever.
    const QString figures = textsOf(read(drawn("figures", {"figures"}) + "/fig4.svg"));
    QVERIFY2(figures.contains("0.5") && !figures.contains("0,5"), qPrintable(figures));
    QVERIFY(read(folder.filePath("gap.csv")).contains("0.5"));
}

void TestStudyPlots::numbersAreTheSameWithPictures() {
    const QString drill = example("t38_medium_rock");
    for (const QStringList& words :
         {QStringList{"gap", drill}, QStringList{"sweep", drill, "--vary", "gamma=0.1:1:10"}}) {
        const QString plain = path("plain.csv"), drawn = path("drawn.csv");
        QCOMPARE(run(words + QStringList{"-o", plain, "--force"}).exitCode, 0);
        QCOMPARE(run(words + QStringList{"-o", drawn, "--force", "--plots", "png"}).exitCode, 0);
        QCOMPARE(read(drawn), read(plain));
    }
}

void TestStudyPlots::picturesStandBesideTheFile() {
    const QTemporaryDir folder;
    const QStringList words{"sweep", example("paper_fig4a"), "--vary", "beta=0.1:1:5", "--plots", "png,svg",
                            "-o"};
    QCOMPARE(run(words + QStringList{folder.filePath("a.csv")}).exitCode, 0);
    QCOMPARE(filesIn(folder.path()), (QStringList{"a.csv", "a.csv.yaml", "a.png", "a.svg"}));
    // The record says how the rows were made, not how they were drawn.
    QVERIFY(!read(folder.filePath("a.csv.yaml")).contains("plots"));
    QCOMPARE(run(words + QStringList{folder.filePath("b.txt")}).exitCode, 0);
    QVERIFY(filesIn(folder.path()).contains("b.txt.png"));
}

void TestStudyPlots::picturesRespectWhatIsThere() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("a.csv"), picture = folder.filePath("a.png");
    QFile there(picture);
    QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
    there.close();
    const QStringList words{"gap", example("paper_fig4a"), "-o", file, "--plots", "png"};
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.error.contains("a.png: exists already"), refused.error.constData());
    QCOMPARE(filesIn(folder.path()), QStringList{"a.png"});
    QCOMPARE(read(picture), QByteArray("mine"));
    QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
    QVERIFY(read(picture).startsWith("\x89PNG"));
}

void TestStudyPlots::aSweepNamesItsCurves() {
    const QString file = path("family.csv");
    const Finished finished = run({"sweep", example("paper_fig4a"), "--vary", "gamma=0.1,0.2,0.3,0.5,1",
                                   "beta=0.1:10:60:log", "-o", file, "--plots", "svg", "--force"});
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    const QString texts = textsOf(read(path("family.svg")));
    QVERIFY2(texts.contains("stiffnessβ"), qPrintable(texts));
    for (const char* gamma : {"0.1", "0.2", "0.3", "0.5", "1"})
        QVERIFY2(texts.contains(QStringLiteral("elasticityγ=%1").arg(gamma)), qPrintable(texts));
}

void TestStudyPlots::figuresComeInTheFormatsOfChoice() {
    const QString folder = path("figures");
    const Finished finished = run({"figures", "-o", folder, "--plots", "png"});
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    QCOMPARE(QDir(folder).entryList({"fig*.png"}).size(), 6);
    QVERIFY(QDir(folder).entryList({"*.svg", "*.pdf"}).isEmpty());
    QVERIFY(read(folder + "/index.html").contains("src=\"fig3.png\""));
}

void TestStudyPlots::accuracyIsDrawnIntoItsFolder() {
    const QString folder = path("accuracy");
    const QStringList words{
        "accuracy", example("paper_fig4a"), "--segments", "100,200", "-o", folder, "--plots", "png,pdf"};
    const Finished finished = run(words);
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    QCOMPARE(filesIn(folder), (QStringList{"accuracy.csv", "accuracy.pdf", "accuracy.png"}));
    QVERIFY(curvePixels(QImage(folder + "/accuracy.png")) > 200);
    QCOMPARE(run(words).exitCode, 4);
}

void TestStudyPlots::aRecordWithItsModelIsDrawnIntoItsFolder() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("rock"), scenario = example("identify/rod");
    QString record = scenario;
    record.replace(QStringLiteral(".yaml"), QStringLiteral(".csv"));
    const Finished finished = run({"identify", scenario, "--signals", record, "--gauge", "top+bottom@1.83m",
                                   "-o", out, "--plots", "png,svg"});
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    const QImage image(out + "/match.png");
    QVERIFY(image.width() > 1000);
    QVERIFY2(curvePixels(image) > 1500, qPrintable(QString::number(curvePixels(image))));
    const QString drawn = textsOf(read(out + "/match.svg"));
    for (const char* text : {"residual", "penetration U", "model"})
        QVERIFY2(drawn.contains(packed(QString::fromLatin1(text))), qPrintable(drawn));
}

void TestStudyPlots::accuracyOfAStringIsDrawnIntoItsFolder() {
    const QString folder = path("string");
    const Finished finished =
        run({"accuracy", example("t38_string"), "-o", folder, "--plots", "svg", "--force"});
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    QCOMPARE(filesIn(folder), (QStringList{"accuracy.csv", "accuracy.svg"}));
    const QString texts = textsOf(read(folder + "/accuracy.svg"));
    for (const char* text : {"error of the efficiency", "polynomial cells (studies)", "plain lattice"})
        QVERIFY2(texts.contains(packed(QString::fromLatin1(text))), qPrintable(texts));
}

void TestStudyPlots::whatCannotBeDrawnIsRefused_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArray>("says");
    const QString paper = example("paper_fig4a");
    const QStringList sweep{"sweep", paper, "--plots", "png", "-o", path("refused.csv"), "--vary"};
    const auto row = [](const char* name, const QStringList& words, const char* says) {
        QTest::newRow(name) << words << 2 << QByteArray(says);
    };
    row("without a file", {"gap", paper, "--plots", "png"}, "add -o FILE.csv");
    row("on standard output", {"gap", paper, "--plots", "png", "-o", "-"}, "add -o FILE.csv");
    row("beside a device", {"gap", paper, "--plots", "png", "-o", "/dev/null"},
        "needs a file to store pictures beside");
    row("another format", {"gap", paper, "--plots", "gif", "-o", path("x.csv")}, "choose from png, svg, pdf");
    row("accuracy on standard output", {"accuracy", paper, "--plots", "png", "-o", "-"}, "add -o DIR");
    row("stability without a folder", {"stability", "--plots", "png"}, "add -o DIR");
    row("figures on standard output", {"figures", "--plots", "png", "-o", "-"}, "add -o DIR");
    row("three axes", sweep + QStringList{"beta=1,2", "gamma=0.5,1", "tau=1,2"}, "one axis or two, not 3");
    row("no axis of numbers", sweep + QStringList{"pulse.shape=rectangular,half_sine"},
        "no axis has two or more numeric values");
    row("too many curves", sweep + QStringList{"beta=1:2:17", "gamma=0.1:1:18"}, "at most 16 curves");
    row("too many outputs", sweep + QStringList{"beta=1:2:10", "--outputs", "all"}, "at most 8 outputs");
    row("a part", sweep + QStringList{"beta=1:2:10", "--shard", "1/2"}, "leave out --shard");
}

void TestStudyPlots::whatCannotBeDrawnIsRefused() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QByteArray, says);
    const Finished finished = run(words);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(finished.error.contains(says), finished.error.constData());
    QCOMPARE(finished.error.count('\n'), 1);
    QVERIFY(!QFile::exists(path("refused.csv")));
}

QTEST_GUILESS_MAIN(TestStudyPlots)
#include "tst_study_plots.moc"
