// SPDX-License-Identifier: GPL-3.0-or-later
// The line that says how far a study is.
#include <QLabel>
#include <QStatusBar>
#include <QTest>

#include "ui/job/study_status.h"

using namespace drillwave;

namespace {

class FakeStudy : public StudyActivity {
  public:
    void set(StudyState state, StudyProgress progress) {
        m_state = state;
        m_progress = progress;
        emit changed();
    }
    bool isCurrent() const override { return false; }
    void cancel() override { set(StudyState::stopped, m_progress); }
    void resume() override { set(StudyState::running, {}); }
    void forget() override { cancel(); }
};

}  // namespace

class TestStudyStatus : public QObject {
    Q_OBJECT

  private slots:
    void progressIsACountAndTheTimeLeft_data();
    void progressIsACountAndTheTimeLeft();
    void aStudyIsShownAfterAMoment();
    void aShortStudyIsNeverSeen();
    void cancelStopsTheStudyAndSaysHowFarItWas();
    void aStoppedStudySaysHowLongAllOfItTakes();
    void anotherPageShowsItsOwnStudy();
    void theLineKeepsItsPlace();
    void aNarrowLineDoesWithoutTheName();
};

void TestStudyStatus::progressIsACountAndTheTimeLeft_data() {
    QTest::addColumn<int>("done");
    QTest::addColumn<int>("wanted");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("text");
    QTest::newRow("half way") << 750 << 1500 << 2.0 << "750/1500 · 2 s left";
    QTest::newRow("too early to tell") << 10 << 1500 << 0.1 << "10/1500";
    QTest::newRow("nothing done") << 0 << 1500 << 5.0 << "0/1500";
    QTest::newRow("no total") << 640 << 0 << 2.0 << "640 · 320/s";
    QTest::newRow("no total, just begun") << 3 << 0 << 0.1 << "3";
    QTest::newRow("minutes") << 10 << 1000 << 5.0 << "10/1000 · 9 min left";
    QTest::newRow("done") << 1500 << 1500 << 5.0 << "1500/1500";
}

void TestStudyStatus::progressIsACountAndTheTimeLeft() {
    QFETCH(int, done);
    QFETCH(int, wanted);
    QFETCH(double, seconds);
    QLocale locale = QLocale::c();
    QTEST(progressText({std::size_t(done), std::size_t(wanted)}, seconds, locale), "text");
}

void TestStudyStatus::aStudyIsShownAfterAMoment() {
    FakeStudy study;
    StudyStatus status;
    status.setPatience(std::chrono::milliseconds(1));
    status.follow(&study, QStringLiteral("COR–gap"));
    QCOMPARE(status.text(), QString());
    study.set(StudyState::running, {640, 1500});
    QTRY_VERIFY(!status.button()->isHidden());
    QVERIFY2(status.text().startsWith(QStringLiteral("COR–gap 640/1500")), qPrintable(status.text()));
    QCOMPARE(status.findChild<QProgressBar*>()->value(), 42);
    study.set(StudyState::running, {700, 0});  // nobody knows how many any more
    QVERIFY(status.findChild<QProgressBar*>()->isHidden());
    study.set(StudyState::finished, {1500, 1500});
    QCOMPARE(status.text(), QString());
    QVERIFY(status.button()->isHidden());
}

void TestStudyStatus::aShortStudyIsNeverSeen() {
    FakeStudy study;
    StudyStatus status;
    status.setPatience(std::chrono::hours(1));
    status.follow(&study, QStringLiteral("COR–gap"));
    for (std::size_t i = 0; i < 100; ++i) study.set(StudyState::running, {i, 100});
    QCoreApplication::processEvents();
    QCOMPARE(status.text(), QString());
    QVERIFY(status.button()->isHidden());
}

void TestStudyStatus::cancelStopsTheStudyAndSaysHowFarItWas() {
    FakeStudy study;
    StudyStatus status;
    status.setPatience(std::chrono::milliseconds(0));
    status.follow(&study, QStringLiteral("Map"));
    study.set(StudyState::running, {5, 9});
    QTRY_VERIFY(!status.button()->isHidden());
    status.button()->click();
    QCOMPARE(study.state(), StudyState::stopped);
    QCOMPARE(status.text(), QString("Map stopped 5/9"));
    QCOMPARE(status.button()->text(), QString("Solve all"));
    // Another page and back: the study is still stopped, and can still be resumed.
    status.follow(nullptr, {});
    QVERIFY(status.button()->isHidden());
    status.follow(&study, QStringLiteral("Map"));
    QCOMPARE(status.text(), QString("Map stopped 5/9"));
    status.button()->click();
    QCOMPARE(study.state(), StudyState::running);
    QTRY_COMPARE(status.button()->text(), QString("Cancel"));
}

void TestStudyStatus::aStoppedStudySaysHowLongAllOfItTakes() {
    const QLocale locale = QLocale::c();
    QCOMPARE(resumeText({250, 1000}, 10, locale), QString("Solve all (40 s)"));
    QCOMPARE(resumeText({10, 1000}, 10, locale), QString("Solve all (17 min)"));
    QCOMPARE(resumeText({10, 0}, 10, locale), QString("Solve all"));
    QCOMPARE(resumeText({0, 1000}, 10, locale), QString("Solve all"));
    QCOMPARE(resumeText({10, 1000}, 0, locale), QString("Solve all"));
}

void TestStudyStatus::anotherPageShowsItsOwnStudy() {
    FakeStudy first;
    auto second = std::make_unique<FakeStudy>();
    StudyStatus status;
    status.setPatience(std::chrono::milliseconds(0));
    status.follow(&first, QStringLiteral("Map"));
    first.set(StudyState::running, {5, 9});
    QTRY_VERIFY(!status.text().isEmpty());
    status.follow(second.get(), QStringLiteral("Thrust"));
    QCOMPARE(status.text(), QString());
    first.set(StudyState::running, {6, 9});
    QCoreApplication::processEvents();
    QCOMPARE(status.text(), QString());
    second->set(StudyState::running, {1, 2});
    QTRY_VERIFY(status.text().startsWith(QStringLiteral("Thrust")));
    status.follow(nullptr, {});
    QCOMPARE(status.text(), QString());
    // A page that goes takes its study along.
    status.follow(second.get(), QStringLiteral("Thrust"));
    second.reset();
    status.button()->click();
}

void TestStudyStatus::theLineKeepsItsPlace() {
    FakeStudy study;
    StudyStatus status;
    status.setPatience(std::chrono::milliseconds(0));
    status.follow(&study, QStringLiteral("Map"));
    const int height = status.sizeHint().height();
    study.set(StudyState::running, {5, 9});
    QTRY_VERIFY(!status.button()->isHidden());
    QCOMPARE(status.sizeHint().height(), height);
    const int width = status.sizeHint().width();
    study.set(StudyState::running, {9, 9});
    QCOMPARE(status.sizeHint().width(), width);
}

void TestStudyStatus::aNarrowLineDoesWithoutTheName() {
    FakeStudy study;
    QStatusBar line;
    auto* beside = new QLabel(QStringLiteral("solved in 12.3 µs, error 1e-14"));
    line.addWidget(beside);
    auto* status = new StudyStatus;
    status->setPatience(std::chrono::milliseconds(0));
    line.addPermanentWidget(status);
    const QString name = QStringLiteral("Efficiency–stiffness");
    status->follow(&study, name);
    line.resize(1600, line.sizeHint().height());
    line.show();
    study.set(StudyState::running, {640, 1500});
    QTRY_VERIFY(!status->button()->isHidden());
    QVERIFY(status->text().startsWith(name));
    // All but the name has room, and stays.
    line.resize(status->sizeHint().width() + beside->sizeHint().width() - 20, line.height());
    study.set(StudyState::running, {700, 1500});
    QVERIFY2(status->text().startsWith(QStringLiteral("700/1500")), qPrintable(status->text()));
    line.resize(1600, line.height());
    study.set(StudyState::running, {800, 1500});
    QVERIFY(status->text().startsWith(name));
}

QTEST_MAIN(TestStudyStatus)
#include "tst_study_status.moc"
