// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of studies as files: in every format, the same bytes every time, whatever the locale.
#include <QImage>
#include <QTest>

#include "core/report/gap_report.h"
#include "core/report/proof_answer.h"
#include "core/study/proof/stability_cases.h"
#include "ui/export/study_pictures.h"

using namespace drillwave;

namespace {

const StudyAnswer& gap() {
    static const StudyAnswerPtr answer =
        gapStudy().run({Scenario(), {{"gap-mean", "0.5 mm"}, {"gap-deviation", "0.1 mm"}}}, {});
    return *answer;
}

StudyAnswerPtr stability() {
    std::vector<StabilityCase> cases = stabilityCases();
    cases.resize(20);
    return stabilityAnswer(checkStability(cases, 1, {}, [](const StabilityReport&) {}));
}

}  // namespace

class TestStudyPictures : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyFormatIsDrawn_data();
    void everyFormatIsDrawn();
    void pngAndSvgAreTheSameBytesEveryTime();
    void aStopEndsTheDrawing();
};

void TestStudyPictures::everyFormatIsDrawn_data() {
    using Draw = std::function<Pictures(const PictureOrder&)>;
    QTest::addColumn<Draw>("draw");
    QTest::newRow("gap") << Draw([](const PictureOrder& order) { return drawStudy(gap(), order); });
    QTest::newRow("stability") << Draw(
        [](const PictureOrder& order) { return drawStudy(*stability(), order); });
    QTest::newRow("accuracy") << Draw([](const PictureOrder& order) {
        return drawStudy(*studyAccuracy(Scenario(), {100, 200}, {}), order);
    });
}

void TestStudyPictures::everyFormatIsDrawn() {
    QFETCH(std::function<Pictures(const PictureOrder&)>, draw);
    const Pictures pictures = draw({"it", {"png", "svg", "pdf"}, {}});
    QCOMPARE(pictures.problem, QString());
    QCOMPARE(pictures.files.size(), std::size_t{3});
    QCOMPARE(pictures.files[0].name, std::string("it.png"));
    const QImage image = QImage::fromData(QByteArray::fromStdString(pictures.files[0].bytes));
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    int coloured = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) coloured += image.pixelColor(x, y).saturation() > 150;
    QVERIFY2(coloured > 200, qPrintable(QString::number(coloured)));
    QVERIFY(pictures.files[1].bytes.find("<svg") != std::string::npos);
    QVERIFY(pictures.files[2].bytes.starts_with("%PDF-"));
    QVERIFY(!draw({"it", {"gif"}, {}}).problem.isEmpty());
}

void TestStudyPictures::pngAndSvgAreTheSameBytesEveryTime() {
    const PictureOrder order{"gap", {"png", "svg"}, {}};
    const Pictures first = drawStudy(gap(), order);
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    const Pictures second = drawStudy(gap(), order);
    for (std::size_t i = 0; i < 2; ++i) QVERIFY(first.files[i].bytes == second.files[i].bytes);
}

void TestStudyPictures::aStopEndsTheDrawing() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(drawStudy(gap(), {"gap", {"png"}, stop.get_token()}).files.empty());
}

QTEST_MAIN(TestStudyPictures)
#include "tst_study_pictures.moc"
