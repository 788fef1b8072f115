// SPDX-License-Identifier: GPL-3.0-or-later
// The page Identify with several records: the list, the next blow, and the answer of `drillwave identify`.
#include <QComboBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/report/identify_report.h"
#include "tests/support/import_fixture.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "tests/support/window_parts.h"
#include "ui/pages/design/design_card.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/identify/gauge_fields.h"
#include "ui/pages/identify/identify_page.h"
#include "ui/pages/identify/record_list.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/window/file_menu.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

const QString examples = QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/examples/identify/");

QStringList holeRecords(int count = 5) {
    QStringList paths;
    for (int i = 1; i <= count; ++i) paths << examples + QStringLiteral("hole_%1.csv").arg(i);
    return paths;
}

}  // namespace

class TestIdentifyList : public QObject, private test::ImportFixture {
    Q_OBJECT

  private slots:
    void init();
    void cleanup() { m_page.reset(); }
    void recordsAreListedWithTheAnswerOfTheCommand();
    void theTableOfRecordsIsThatOfTheCommand();
    void theNextBlowIsABandAlongTheRecords();
    void aChosenRowShowsItsRecord();
    void aRemovedRecordChangesTheAnswer();
    void twoRecordsHaveNoBandAndSayWhy();
    void aRefusedRecordSaysItsReason();
    void anUnreadableRecordCanBeRemoved();
    void anAddedRecordIsListedOnce();
    void oneRecordAfterSeveralShowsItsRock();
    void theRockOfAllRecordsIsUsed();
    void allBlowsAreOfTheCommand();
    void aCancelledListGoesOn();
    void severalFilesGoThroughOneDialog();
    void drawsAreDesignedWithAsByTheCommand();
    void noDrawsSayWhy();

  private:
    void open(const QStringList& paths);
    void typeDistance(IdentifyPage& page) const;
    bool isDone() const {
        return m_page->activity()->state() == StudyState::finished && m_page->activity()->isCurrent();
    }
    QString words() const { return pageWords(*m_page); }
    RecordList& list() const { return *m_page->findChild<RecordList*>(QStringLiteral("records")); }
    QTableWidget& values() const { return *m_page->findChild<QTableWidget*>(QStringLiteral("values")); }
    QString remarks() const { return m_page->findChild<QLabel*>(QStringLiteral("remarks"))->text(); }
    const IdentifyReport& report() const { return m_page->answer()->report; }
    /// The copied command in the folder of the examples, where it names files as the page does.
    test::Finished runCommand(const QString& more = {}) const {
        return test::shell(m_page->command().remove(examples) + more, examples);
    }
    void remove(int row) const { qobject_cast<QToolButton*>(list().cellWidget(row, 3))->click(); }
    /// Counts the panels that are shown; the others take no room.
    int panels() const {
        int count = 0;
        for (const QCPAxisRect* rect : m_page->plot()->axisRects()) {
            if (rect->visible()) ++count;
            if (!rect->visible() && rect->height() > 1) return -1;
        }
        return count;
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<IdentifyPage> m_page;
};

void TestIdentifyList::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_page.reset();
    m_document = std::make_unique<Document>();
    QCOMPARE(m_document->open(examples + QStringLiteral("hole.yaml")), QString());
    m_page = std::make_unique<IdentifyPage>(*m_document);
    m_page->resize(1100, 900);
    m_page->show();
}

void TestIdentifyList::typeDistance(IdentifyPage& page) const {
    auto* edit = page.findChild<QuantityField*>(QStringLiteral("distance1"))->findChild<QLineEdit*>();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("1.83 m"));
}

void TestIdentifyList::open(const QStringList& paths) {
    m_page->openRecords(paths);
    typeDistance(*m_page);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
}

void TestIdentifyList::recordsAreListedWithTheAnswerOfTheCommand() {
    m_page->openRecords(holeRecords());
    QCOMPARE(list().rowCount(), 5);  // before there is an answer
    QVERIFY(list().isVisible());
    open(holeRecords());
    QCOMPARE(list().rowCount(), 5);
    QCOMPARE(list().currentRow(), 0);
    for (int row = 0; row < 5; ++row) {
        QCOMPARE(list().item(row, 0)->text(), QStringLiteral("hole_%1.csv").arg(row + 1));
        QCOMPARE(list().item(row, 1)->text(), QStringLiteral("agrees"));
        QVERIFY(list().item(row, 2)->text().endsWith(QStringLiteral(" %")));
    }
    QVERIFY2(m_page->command().contains(QStringLiteral("--signals ") + holeRecords().join(u' ')),
             qPrintable(m_page->command()));
    const test::Finished text = runCommand();
    QVERIFY2(text.exitCode == 0, text.error.constData());
    QCOMPARE(QString::fromUtf8(text.out), QString::fromStdString(identifyText(report())));
    for (const char* label : {"answer", "words"}) {
        const QString words = m_page->findChild<QLabel*>(QString::fromLatin1(label))->text().simplified();
        QVERIFY2(!words.isEmpty() && QString::fromUtf8(text.out).simplified().contains(words),
                 qPrintable(words));
    }
    const QJsonObject json = QJsonDocument::fromJson(runCommand(QStringLiteral(" --json")).out).object();
    const QJsonArray records = json[QStringLiteral("records")].toArray();
    QCOMPARE(records.size(), 5);
    for (int i = 0; i < 5; ++i)
        QCOMPARE(
            records[i].toObject()[QStringLiteral("parameters")].toArray()[0].toObject()["value"].toDouble(),
            report().findings.records[std::size_t(i)].parameters[0].value);
    QCOMPARE(values().rowCount(), 6);
    QCOMPARE(values().item(3, 0)->text(), QStringLiteral("next blow:\nstiffness"));
    QVERIFY(values().item(3, 2)->data(Qt::UserRole).isValid());
}

void TestIdentifyList::theTableOfRecordsIsThatOfTheCommand() {
    open(holeRecords());
    const PageExport records = m_page->exports()[2];
    QCOMPARE(records.obstacle(), QString());
    const QString folder = m_folder.filePath(QStringLiteral("rock"));
    QVERIFY(runCommand(QStringLiteral(" --force -o ") + folder).exitCode == 0);
    for (const auto& [index, name] : {std::pair(0, "match.csv"), {1, "posterior.csv"}, {2, "records.csv"}}) {
        QFile file(folder + u'/' + QLatin1String(name));
        QVERIFY2(file.open(QIODevice::ReadOnly), name);
        QCOMPARE(m_page->exports()[index].csv(), file.readAll());
    }
    open(holeRecords(1));
    QVERIFY(!m_page->exports()[2].obstacle().isEmpty());
}

void TestIdentifyList::theNextBlowIsABandAlongTheRecords() {
    open(holeRecords());
    const StudyFigure figure = identifyFigure(report().findings, report().findings.main());
    QCOMPARE(figure.panels.size(), std::size_t(4));
    QCOMPARE(panels(), 4);
    for (const std::size_t panel : {std::size_t{2}, std::size_t{3}}) {
        const NextBlowParameter& next = report().findings.nextBlow[panel - 2];
        const FigureSeries& band = figure.panels[panel].series[0];
        QCOMPARE(band.y, (std::vector{next.low, next.low, next.high, next.high}));
        // Every value is in the band; a bar of four lines with a gap after each stands for every record.
        QCOMPARE(figure.panels[panel].series[1].x.size(), std::size_t(5 * 4 * 3));
        for (const RecordAnswer& record : report().findings.records) {
            const double value = record.find(next.key)->value;
            QVERIFY(value > next.low && value < next.high);
        }
    }
}

void TestIdentifyList::aChosenRowShowsItsRecord() {
    open(holeRecords());
    const int started = m_page->started();
    const QString first = values().item(0, 1)->text();
    list().setCurrentCell(2, 0);
    QCOMPARE(m_page->started(), started);
    QVERIFY2(words().contains(QStringLiteral("hole_3.csv: ")), qPrintable(words()));
    QVERIFY(values().item(0, 1)->text() != first);
    QCOMPARE(values().item(0, 1)->text(), QStringLiteral("158.8 MN/m"));
    // The next blow is that of all records.
    QCOMPARE(values().item(3, 1)->text(), QStringLiteral("121.8 MN/m"));
    const auto measured = m_page->figureFrame().graph(0)->data();
    QVERIFY(measured->size() > 0);
    const double end = (measured->constEnd() - 1)->value;
    list().setCurrentCell(1, 0);
    QVERIFY((m_page->figureFrame().graph(0)->data()->constEnd() - 1)->value != end);
}

void TestIdentifyList::aRemovedRecordChangesTheAnswer() {
    open(holeRecords());
    const NextBlowParameter before = report().findings.nextBlow[0];
    QVERIFY(!remarks().contains(QStringLiteral("fewer than five records")));
    remove(2);
    QCOMPARE(list().rowCount(), 4);
    QVERIFY(!m_page->command().contains(QStringLiteral("hole_3.csv")));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QCOMPARE(report().findings.records.size(), std::size_t(4));
    QVERIFY(report().findings.nextBlow[0].value < before.value);  // the stiffest rock has gone
    QVERIFY2(remarks().contains(QStringLiteral("fewer than five records")), qPrintable(remarks()));
    QCOMPARE(QString::fromUtf8(runCommand().out), QString::fromStdString(identifyText(report())));
    list().setCurrentCell(1, 0);
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Delete);
    QCOMPARE(list().rowCount(), 3);
}

void TestIdentifyList::twoRecordsHaveNoBandAndSayWhy() {
    open(holeRecords(2));
    QVERIFY(report().findings.nextBlow.empty());
    QCOMPARE(values().rowCount(), 3);
    const StudyFigure figure = identifyFigure(report().findings, report().findings.main());
    QVERIFY(figure.panels[2].series[0].x.empty());
    QVERIFY(!figure.panels[2].series[1].x.empty());
    QVERIFY2(remarks().contains(QStringLiteral("fewer than five records")), qPrintable(remarks()));
}

void TestIdentifyList::aRefusedRecordSaysItsReason() {
    QByteArray still = "time [us],strain [microstrain]\n";
    for (int i = 0; i < 1000; ++i) still += QByteArray::number(1.5 * i) + (i % 2 == 0 ? ",1\n" : ",-1\n");
    open(holeRecords(3) << write(QStringLiteral("still.csv"), still));
    QVERIFY(report().findings.records[3].refusal);
    QVERIFY2(list().item(3, 1)->text().startsWith(QStringLiteral("refused: ")),
             qPrintable(list().item(3, 1)->text()));
    QCOMPARE(list().item(3, 2)->text(), QString());
    QCOMPARE(values().rowCount(), 6);
    list().setCurrentCell(3, 0);
    QVERIFY2(words().contains(QStringLiteral("still.csv: ")), qPrintable(words()));
    QVERIFY(!values().isVisible());
    QVERIFY(list().isVisible());
    list().setCurrentCell(0, 0);
    QVERIFY(values().isVisible());
}

void TestIdentifyList::anUnreadableRecordCanBeRemoved() {
    m_page->openRecords(holeRecords(3)
                        << write(QStringLiteral("other.csv"), "time [us],force [kN]\n0,1\n1,2\n"));
    typeDistance(*m_page);
    QTRY_COMPARE_WITH_TIMEOUT(m_page->activity()->state(), StudyState::failed, 60000);
    QVERIFY2(words().contains(QStringLiteral("other.csv")), qPrintable(words()));
    QCOMPARE(list().rowCount(), 4);
    QVERIFY(list().isVisible() && list().isEnabled());
    remove(3);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QCOMPARE(list().rowCount(), 3);
}

void TestIdentifyList::anAddedRecordIsListedOnce() {
    open(holeRecords(2));
    const int started = m_page->started();
    m_page->addRecords(holeRecords(3));
    QCOMPARE(list().rowCount(), 3);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QCOMPARE(report().findings.records.size(), std::size_t(3));
    QCOMPARE(m_page->started(), started + 1);
    // The file may have changed.
    m_page->addRecords(holeRecords(1));
    QCOMPARE(list().rowCount(), 3);
    QCOMPARE(m_page->started(), started + 2);
}

void TestIdentifyList::oneRecordAfterSeveralShowsItsRock() {
    open(holeRecords(3));
    QCOMPARE(panels(), 4);
    open(holeRecords(1));
    QVERIFY(!list().isVisible());
    m_page->plot()->replot();
    QCOMPARE(panels(), 3);
    open(holeRecords(3));
    QCOMPARE(panels(), 4);
}

void TestIdentifyList::theRockOfAllRecordsIsUsed() {
    open(holeRecords());
    const Scenario wanted = identifiedScenario(m_document->scenario(), report().findings);
    list().setCurrentCell(3, 0);
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("useRock")), Qt::LeftButton);
    QCOMPARE(m_document->scenario().bitRock, wanted.bitRock);
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY2(m_document->text().contains("# identified from 5 records: "), m_document->text().constData());
    m_document->undoStack().undo();
    QCOMPARE(list().currentRow(), 3);
}

void TestIdentifyList::allBlowsAreOfTheCommand() {
    open(holeRecords(2));
    m_page->findChild<QComboBox*>(QStringLiteral("blows"))->setCurrentIndex(1);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(m_page->command().contains(QStringLiteral("--blows all")));
    QCOMPARE(QString::fromUtf8(runCommand().out), QString::fromStdString(identifyText(report())));
    QCOMPARE(list().item(0, 0)->text(), QStringLiteral("hole_1.csv, 1"));
}

void TestIdentifyList::aCancelledListGoesOn() {
    m_page->openRecords(holeRecords());
    typeDistance(*m_page);
    QCOMPARE(m_page->activity()->state(), StudyState::running);
    m_page->activity()->cancel();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    QCOMPARE(list().rowCount(), 5);
    QVERIFY(!m_page->exports()[2].obstacle().isEmpty());
    m_page->activity()->resume();
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(!m_page->answer()->isPartial);
    QCOMPARE(list().item(4, 1)->text(), QStringLiteral("agrees"));
}

void TestIdentifyList::severalFilesGoThroughOneDialog() {
    m_page.reset();
    ImportFixture::start();
    QVERIFY(m_window->openFile(examples + QStringLiteral("hole.yaml")));
    auto& pages = part<PageTabs>(*m_window);
    auto* page = pages.findChild<IdentifyPage*>();
    pages.setCurrentWidget(page);
    const auto* records = page->findChild<RecordList*>();
    m_answers.imports = holeRecords(3);
    QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("openRecord")), Qt::LeftButton);
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog);
    QCOMPARE(dialog->path(), holeRecords(1).first());
    QVERIFY(settle(*dialog));
    test::control<QPushButton>(*dialog, "take").click();
    QCOMPARE(records->rowCount(), 3);
    m_answers.imports = {holeRecords(4).last()};
    QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("addRecords")), Qt::LeftButton);
    QCOMPARE(records->rowCount(), 4);
    auto* drop = m_window->findChild<FileDrop*>();
    emit drop->dropped({holeRecords().last()});
    QCOMPARE(records->rowCount(), 5);
    // On another page, several tables are records to import.
    pages.setCurrentIndex(0);
    emit drop->dropped(holeRecords(2));
    dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QCOMPARE(dialog->use(), ImportUse::rockRecord);
    m_window.reset();
}

// The command reads the files that `identify -o` writes.
void TestIdentifyList::drawsAreDesignedWithAsByTheCommand() {
    m_page.reset();
    ImportFixture::start();
    QFile given(examples + QStringLiteral("hole.yaml"));
    QVERIFY(given.open(QIODevice::ReadOnly));
    QVERIFY(m_window->openFile(write(QStringLiteral("hole.yaml"), given.readAll())));
    Document& document = m_window->document();
    auto& pages = part<PageTabs>(*m_window);
    auto* page = pages.findChild<IdentifyPage*>();
    auto* design = pages.findChild<DesignPage*>();
    pages.setCurrentWidget(page);
    page->openRecords(holeRecords());
    typeDistance(*page);
    QTRY_VERIFY_WITH_TIMEOUT(page->activity()->state() == StudyState::finished, 60000);
    const QString rock = m_folder.filePath(QStringLiteral("rock"));
    QVERIFY(test::shell(page->command() + QStringLiteral(" --force -o ") + rock).exitCode == 0);
    auto& button = *page->findChild<QPushButton*>(QStringLiteral("designDraws"));
    QVERIFY(button.isEnabled());
    button.click();
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(pages.currentWidget(), design);
    const auto* line = design->findChild<QWidget*>(QStringLiteral("draws"));
    const auto* text = line->findChild<QLabel*>();
    QVERIFY(line->isVisible());
    QVERIFY2(text->text().contains(QStringLiteral("draws of 5 records: 200 rows of")),
             qPrintable(text->text()));
    QVERIFY(design->findChild<QWidget*>(QStringLiteral("uncertain"))->isHidden());
    auto& samples = *design->findChild<QComboBox*>(QStringLiteral("samples"));
    samples.setCurrentIndex(samples.findData(256));
    const auto isAnswered = [&] {
        return design->activity()->state() == StudyState::finished && design->activity()->isCurrent();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered(), 120000);
    QVERIFY(document.save(m_folder.filePath(QStringLiteral("hole.yaml"))).isEmpty());
    QStringList typed = QProcess::splitCommand(design->command().replace(u'\'', u'"'));
    QCOMPARE(typed[1], QStringLiteral("design"));
    QVERIFY(!typed.contains(QStringLiteral("--uncertain")));
    typed.removeFirst();
    typed[1] = rock + QStringLiteral("/identified.yaml");
    const qsizetype file = typed.indexOf(QStringLiteral("--draws")) + 1;
    QCOMPARE(typed[file], m_folder.filePath(QStringLiteral("hole_posterior.csv")));
    typed[file] = rock + QStringLiteral("/posterior.csv");
    const test::Finished finished = test::run(typed << QStringLiteral("--json"));
    QVERIFY2(finished.exitCode == 0, finished.error.constData());
    const QJsonObject json = QJsonDocument::fromJson(finished.out).object();
    const DesignReport& answer = design->answer()->report;
    const QJsonArray designs = json[QStringLiteral("designs")].toArray();
    QCOMPARE(std::size_t(designs.size()), answer.findings.designs.size());
    QVERIFY(designs.size() > 5);
    const DesignAim& aim = answer.study.aims.front();
    const StatisticPlace place = answer.study.placeOf(*aim.output, aim.statistic);
    const QString key = QString::fromStdString(std::string(aim.output->name) + "_" + aim.statistic.name());
    for (qsizetype i = 0; i < designs.size(); ++i)
        QCOMPARE(answer.findings.designs[std::size_t(i)].statistics[place.output][place.statistic].value,
                 designs[i][QStringLiteral("statistics")][key][QStringLiteral("value")].toDouble());
    QCOMPARE(answer.findings.worst[0]->value,
             json[QStringLiteral("worst")][0][QStringLiteral("value")].toDouble());
    QCOMPARE(worstInputs(answer.study, *answer.findings.worst[0]).size(), std::size_t(3));
    QVERIFY(design->card().toPlainText().contains(QStringLiteral("at stiffness")));
    design->copyCommand();
    QVERIFY2(text->text().contains(QStringLiteral("hole_posterior.csv")), qPrintable(text->text()));
    m_answers.exportTo = m_folder.filePath(QStringLiteral("hole_posterior.csv"));
    line->findChild<QPushButton*>(QStringLiteral("saveDraws"))->click();
    QTRY_VERIFY(QFile::exists(m_answers.exportTo));
    QFile saved(m_answers.exportTo), written(rock + QStringLiteral("/posterior.csv"));
    QVERIFY(saved.open(QIODevice::ReadOnly) && written.open(QIODevice::ReadOnly));
    QCOMPARE(saved.readAll(), written.readAll());
    // Once they are removed the rows are those of before.
    line->findChild<QToolButton*>(QStringLiteral("removeDraws"))->click();
    QVERIFY(line->isHidden());
    QVERIFY(!design->command().contains(QStringLiteral("--draws")));
    QVERIFY2(design->command().contains(QStringLiteral("--uncertain 'bit_rock.stiffness=")),
             qPrintable(design->command()));
    m_window.reset();
}

void TestIdentifyList::noDrawsSayWhy() {
    open(holeRecords(1));
    const auto* button = m_page->findChild<QPushButton*>(QStringLiteral("designDraws"));
    QVERIFY(button->isEnabled());
    m_page->findChild<QComboBox*>(QStringLiteral("law"))->setCurrentIndex(3);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(!button->isEnabled());
    QVERIFY2(button->toolTip().contains(QStringLiteral("no draws")), qPrintable(button->toolTip()));
}

QTEST_MAIN(TestIdentifyList)
#include "tst_identify_list.moc"
