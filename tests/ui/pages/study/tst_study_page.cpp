// SPDX-License-Identifier: GPL-3.0-or-later
// Common features of the pages of studies, by a page that only counts.
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

#include "core/yaml/examples.h"
#include "tests/support/page_words.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/study_page.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/stale_veil.h"

using namespace drillwave;

namespace {

// Its study is the stiffness of the rock, in so many parts of work.
class StiffnessPage : public StudyPage {
  public:
    explicit StiffnessPage(Document& document)
        : StudyPage(document), m_study([this](double stiffness, const StudyFeed<double>& feed) {
              while ((m_slow || stiffness >= m_held) && !feed.stop.stop_requested()) QThread::msleep(1);
              return stiffness;
          }) {
        arrange({}, new QLabel(QStringLiteral("card")));
        addBelow(new QLabel(QStringLiteral("table")));
        watch(m_study.job());
    }
    ~StiffnessPage() override {
        m_slow = false;
        m_held = HUGE_VAL;
    }

    QString title() const override { return QStringLiteral("Stiffness"); }
    int started() const { return m_study.started(); }
    double shown() const { return m_shown; }
    void setSlow(bool slow) { m_slow = slow; }
    /// Studies of that stiffness and more do not end.
    void hold(double stiffness) { m_held = stiffness; }
    void loadStiffness(double si) { load({{findParameter("bit_rock.stiffness"), si}}); }

  protected:
    void ask() override { m_study.ask(scenario().bitRock.stiffness); }
    void present() override {
        if (const double* value = m_study.value()) m_shown = *value;
        say(QStringLiteral("k = %1").arg(m_shown));
    }
    QByteArray csv() const override { return QByteArray::number(m_shown); }
    QStringList commandWords() const override { return {QStringLiteral("gap"), QStringLiteral("--si")}; }

  private:
    std::atomic<bool> m_slow = false;
    std::atomic<double> m_held = HUGE_VAL;
    double m_shown = 0;
    StudyRunner<double, double> m_study;
};

}  // namespace

class TestStudyPage : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void aPageThatCannotBeSeenComputesNothing();
    void theSameQuestionIsAskedOnce();
    void outOfSightItsStudyStopsAndIsAskedAgainLater();
    void whatIsLateIsVeiled();
    void theVeilLiesOverAllOfTheAnswer();
    void anotherScenarioHidesTheFormerAnswer();
    void answersToEarlierQuestionsLiftTheVeil();
    void aClickIsOneUndoStep();
    void whatCannotBeTakenOverIsSaid();
    void anUnfinishedStudyIsNotWritten();
    void aStoppedStudyIsNotWritten();
    void theCommandNamesTheFileOrBringsTheScenario();
    void aShellTakesEveryWordWhole();

  private:
    std::unique_ptr<Document> m_document;
    std::unique_ptr<StiffnessPage> m_page;
};

void TestStudyPage::init() {
    m_page.reset();
    m_document = std::make_unique<Document>();
    m_document->start();
    m_page = std::make_unique<StiffnessPage>(*m_document);
}

void TestStudyPage::aPageThatCannotBeSeenComputesNothing() {
    m_document->assign(*findParameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    QCOMPARE(m_page->started(), 0);
    m_page->show();
    QTRY_COMPARE(m_page->shown(), 2e8);
    QCOMPARE(m_page->started(), 1);
}

void TestStudyPage::theSameQuestionIsAskedOnce() {
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    m_document->assign(*findParameter("bit_rock.gamma"), 0.7, m_document->newGesture());
    m_page->hide();
    m_page->show();
    QCOMPARE(m_page->started(), 1);
}

void TestStudyPage::outOfSightItsStudyStopsAndIsAskedAgainLater() {
    m_page->setSlow(true);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::running);
    m_page->hide();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    m_page->setSlow(false);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    QCOMPARE(m_page->started(), 2);
}

void TestStudyPage::whatIsLateIsVeiled() {
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    auto* veil = m_page->findChild<StaleVeil*>();
    QVERIFY(veil->isHidden());
    m_page->setSlow(true);
    m_document->assign(*findParameter("bit_rock.stiffness"), 3e8, m_document->newGesture());
    QTRY_VERIFY(veil->isVisible());
    QVERIFY(!m_page->plot()->isCurrent());
    m_page->setSlow(false);
    QTRY_VERIFY(veil->isHidden());
    QVERIFY(m_page->plot()->isCurrent());
    QCOMPARE(m_page->shown(), 3e8);
}

void TestStudyPage::theVeilLiesOverAllOfTheAnswer() {
    m_page->resize(600, 500);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    m_page->setSlow(true);
    m_document->assign(*findParameter("bit_rock.stiffness"), 3e8, m_document->newGesture());
    auto* veil = m_page->findChild<StaleVeil*>();
    QTRY_VERIFY(veil->isVisible());
    QVERIFY(veil->geometry().contains(m_page->plot()->geometry()));
    for (const QLabel* part : m_page->findChildren<QLabel*>()) {
        const QRect area(part->mapTo(m_page.get(), QPoint(0, 0)), part->size());
        QVERIFY2(veil->geometry().intersects(area), qPrintable(part->text()));
        if (part->text() == QStringLiteral("card") || part->text() == QStringLiteral("table"))
            QVERIFY(veil->geometry().contains(area) && !part->isEnabled());
    }
    m_page->setSlow(false);
    QTRY_VERIFY(veil->isHidden());
    for (const QLabel* part : m_page->findChildren<QLabel*>()) QVERIFY(part->isEnabled());
}

void TestStudyPage::anotherScenarioHidesTheFormerAnswer() {
    m_page->resize(600, 500);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    m_page->setSlow(true);
    QCOMPARE(m_document->startFrom(findExample("t51_soft_rock")->text, QStringLiteral("other")), QString());
    auto* veil = m_page->findChild<StaleVeil*>();
    QVERIFY(veil->isVisible());
    QCOMPARE(pageWords(*m_page), QString());
    // Nothing shows through.
    const QColor window = m_page->palette().color(QPalette::Window);
    const QPoint corner = veil->geometry().bottomLeft() + QPoint(2, -2);
    QCOMPARE(m_page->grab().toImage().pixelColor(corner).value(), window.value());
    m_page->setSlow(false);
    QTRY_VERIFY(veil->isHidden());
}

// While a value is dragged every answer is of an earlier one: what follows the hand is not stale.
void TestStudyPage::answersToEarlierQuestionsLiftTheVeil() {
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    m_page->hold(3e8);
    m_page->loadStiffness(3e8);
    m_page->loadStiffness(4e8);  // waits for the one before
    auto* veil = m_page->findChild<StaleVeil*>();
    veil->show();  // as after a moment; the first study may be stopped for the second then
    bool wasLifted = false;
    const auto lifted = [&] { return wasLifted = wasLifted || veil->isHidden(); };
    m_page->hold(3.5e8);
    QTRY_VERIFY(lifted());
    QCOMPARE(m_page->shown(), 3e8);
    QVERIFY(!m_page->plot()->isCurrent());
    m_page->hold(HUGE_VAL);
    QTRY_COMPARE(m_page->shown(), 4e8);
    QTRY_VERIFY(veil->isHidden());
}

void TestStudyPage::aClickIsOneUndoStep() {
    m_page->loadStiffness(4e8);
    QCOMPARE(m_document->undoStack().count(), 1);
    m_page->loadStiffness(5e8);
    QCOMPARE(m_document->undoStack().count(), 2);
    QCOMPARE(m_document->scenario().bitRock.stiffness, 5e8);
    QVERIFY2(m_document->undoStack().undoText().contains(QStringLiteral("500")),
             qPrintable(m_document->undoStack().undoText()));
}

void TestStudyPage::whatCannotBeTakenOverIsSaid() {
    m_page->loadStiffness(-1);
    QCOMPARE(m_document->undoStack().count(), 0);
    QVERIFY2(pageWords(*m_page).contains(QStringLiteral("must be")), qPrintable(pageWords(*m_page)));
    m_page->loadStiffness(5e8);
    QVERIFY(!pageWords(*m_page).contains(QStringLiteral("must be")));
}

void TestStudyPage::anUnfinishedStudyIsNotWritten() {
    m_page->setSlow(true);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::running);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    m_page->setSlow(false);
    QTRY_COMPARE(m_page->activity()->state(), StudyState::finished);
    QVERIFY(m_page->exports().first().obstacle().isEmpty());
    QCOMPARE(m_page->exports().first().csv(), QByteArray::number(m_page->shown()));
}

void TestStudyPage::aStoppedStudyIsNotWritten() {
    m_page->setSlow(true);
    m_page->show();
    QTRY_COMPARE(m_page->activity()->state(), StudyState::running);
    m_page->activity()->cancel();
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    QVERIFY(!m_page->plot()->isCurrent());
}

void TestStudyPage::theCommandNamesTheFileOrBringsTheScenario() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a rod.yaml"));
    QVERIFY(m_document->save(path).isEmpty());
    QCOMPARE(m_page->command(), QStringLiteral("drillwave gap '%1' --si -o -").arg(path));
    m_page->loadStiffness(5e8);
    const QString command = m_page->command();
    QVERIFY2(command.startsWith(QStringLiteral("drillwave gap - --si -o - <<'END'\n")), qPrintable(command));
    QVERIFY2(command.contains(QStringLiteral("500 MN/m")), qPrintable(command));
    QVERIFY(command.endsWith(QStringLiteral("\nEND\n")));
    m_page->copyCommand();
    QCOMPARE(QGuiApplication::clipboard()->text(), command);
}

void TestStudyPage::aShellTakesEveryWordWhole() {
    QCOMPARE(shellWord(QStringLiteral("beta=0.1:10:log")), QStringLiteral("beta=0.1:10:log"));
    QCOMPARE(shellWord(QStringLiteral("10 MN/m")), QStringLiteral("'10 MN/m'"));
    QCOMPARE(shellWord(QStringLiteral("it's")), QStringLiteral("'it'\\''s'"));
    QCOMPARE(shellWord(QString()), QStringLiteral("''"));
}

QTEST_MAIN(TestStudyPage)
#include "tst_study_page.moc"
