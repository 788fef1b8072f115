// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that `run` requests, and their files, with a drawer as the test wants it.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "app/command.h"

using namespace drillwave;

namespace {

using Words = std::vector<std::string>;

/// Notes what it is asked for.
class PlainDrawing : public Drawing {
  public:
    std::string figure(const Figure&, std::string_view) const override { return {}; }
    std::vector<NamedFile> blow(const Blow& blow, const Words& formats,
                                const std::stop_token&) const override {
        if (!blow.isSolved() || blow.impact.force.empty()) qFatal("nothing to draw");
        std::vector<NamedFile> files;
        for (const std::string& format : formats) files.push_back({"blow." + format, "drawn as " + format});
        return files;
    }
    std::vector<NamedFile> report(const BlowReport&, const PictureOrder&) const override { return {}; }
    std::vector<NamedFile> study(const StudyValue&, const PictureOrder& order) const override {
        std::vector<NamedFile> files;
        for (const std::string& format : order.formats)
            files.push_back({order.stem + "." + format, "drawn as " + format});
        return files;
    }
};

QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

ExitCode run(const Words& words, const Drawing* drawing) {
    return runCommand().run(parseArguments(runCommand(), words), drawing);
}

const QStringList numbers{"events.csv", "histories.csv", "scenario.yaml", "summary.json"};

}  // namespace

class TestDrawnRun : public QObject {
    Q_OBJECT

  private slots:
    void onlyPlotsAreDrawn();
    void picturesStandBesideTheNumbers();
    void otherPicturesOfAnEarlierRunGo();
    void anUnknownFormatIsRefusedBeforeTheWork();
};

void TestDrawnRun::onlyPlotsAreDrawn() {
    const Command& command = runCommand();
    QVERIFY(!command.draws(parseArguments(command, Words{"x", "-o", "out"})));
    QVERIFY(command.draws(parseArguments(command, Words{"x", "-o", "out", "--plots", "png"})));
}

void TestDrawnRun::picturesStandBesideTheNumbers() {
    const QTemporaryDir place;
    const QString folder = place.filePath("out");
    const PlainDrawing drawing;
    QCOMPARE(run({"reference_case", "-o", folder.toStdString(), "--plots", "png,pdf"}, &drawing),
             ExitCode::done);
    QCOMPARE(contents(folder), (QStringList{"blow.pdf", "blow.png"} + numbers));
    QFile picture(folder + "/blow.pdf");
    QVERIFY(picture.open(QIODevice::ReadOnly));
    QCOMPARE(picture.readAll(), QByteArray("drawn as pdf"));
}

void TestDrawnRun::otherPicturesOfAnEarlierRunGo() {
    const QTemporaryDir place;
    const std::string folder = place.filePath("out").toStdString();
    const PlainDrawing drawing;
    QCOMPARE(run({"reference_case", "-o", folder, "--plots", "png,svg"}, &drawing), ExitCode::done);
    QCOMPARE(run({"reference_case", "-o", folder, "--plots", "svg", "--force"}, &drawing), ExitCode::done);
    QCOMPARE(contents(place.filePath("out")), QStringList{"blow.svg"} + numbers);
    QCOMPARE(run({"reference_case", "-o", folder, "--force"}, nullptr), ExitCode::done);
    QCOMPARE(contents(place.filePath("out")), numbers);
}

void TestDrawnRun::anUnknownFormatIsRefusedBeforeTheWork() {
    const QTemporaryDir place;
    const std::string folder = place.filePath("out").toStdString();
    for (const char* formats : {"gif", "png,gif", "", "png,", "PNG"})
        QVERIFY_EXCEPTION_THROWN(run({"reference_case", "-o", folder, "--plots", formats}, nullptr),
                                 CommandError);
    QCOMPARE(contents(place.path()), QStringList());
}

QTEST_GUILESS_MAIN(TestDrawnRun)
#include "tst_drawn_run.moc"
