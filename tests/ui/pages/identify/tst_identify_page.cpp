// SPDX-License-Identifier: GPL-3.0-or-later
// The page Identify: the words and numbers of `drillwave identify`, and what its controls do.
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "core/report/identify_report.h"
#include "core/yaml/examples.h"
#include "tests/support/import_fixture.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "tests/support/window_parts.h"
#include "ui/form/section_box.h"
#include "ui/pages/identify/gauge_fields.h"
#include "ui/pages/identify/identify_page.h"
#include "ui/plot/drag_line.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/stale_veil.h"
#include "ui/text/shown_text.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

QString caseFile(const QString& name) {
    const QString example = QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/examples/identify/") + name;
    return QFile::exists(example) ? example
                                  : QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/identify/") + name;
}

// The title names the record as it was given, here with its folder.
QByteArray belowTitle(const QByteArray& text) {
    return text.mid(text.indexOf('\n'));
}

}  // namespace

class TestIdentifyPage : public QObject, private test::ImportFixture {
    Q_OBJECT

  private slots:
    void init();
    void cleanup() { m_page.reset(); }
    void anEmptyPageSaysWhatItDoes();
    void aMissingDistanceIsAskedFor();
    void aDimensionlessScenarioSaysWhyNot();
    void theAnswerIsThatOfTheCommand_data();
    void theAnswerIsThatOfTheCommand();
    void aRejectedRecordHasNoIntervals();
    void theButtonThatOpensARecordIsInViewInALowWindow();
    void theRecordIsShownInThreeRows();
    void theRockIsUsedAsOneUndoStep();
    void theRockOfTheScenarioIsNotAsked();
    void aDraggedArrivalMovesTheGauge();
    void aTypedToleranceNarrowsTheInterval();
    void aClickOnALimitGoesToItsField();
    void limitsReadAsInTheText();
    void aCancelledRecordIsNotWritten();
    void anUnreadableRecordSaysWhy();
    void aRecordIsChosenByTheImportDialog();

  private:
    void start(const QString& scenario);
    void open(const QString& record, const QStringList& distances);
    void typeInto(QWidget& field, const QString& text);
    bool isDone() const { return m_page->activity()->state() == StudyState::finished; }
    QString words() const { return pageWords(*m_page); }
    QTableWidget& table(const char* name) const {
        return *m_page->findChild<QTableWidget*>(QLatin1String(name));
    }
    QCPAxisRect* rectOf(std::size_t panel) const {
        return m_page->figureFrame().graph(panel)->keyAxis()->axisRect();
    }
    const RecordAnswer& found() const { return m_page->answer()->report.findings.main(); }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<IdentifyPage> m_page;
};

void TestIdentifyPage::init() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    start(QStringLiteral("noise.yaml"));
}

void TestIdentifyPage::start(const QString& scenario) {
    m_page.reset();
    m_document = std::make_unique<Document>();
    QCOMPARE(m_document->open(caseFile(scenario)), QString());
    m_page = std::make_unique<IdentifyPage>(*m_document);
    m_page->resize(1100, 900);
    m_page->show();
}

void TestIdentifyPage::typeInto(QWidget& field, const QString& text) {
    auto* edit = field.findChild<QLineEdit*>();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
}

// As a user does: the record, then the places of its gauges by the keyboard.
void TestIdentifyPage::open(const QString& record, const QStringList& distances) {
    m_page->openRecord(caseFile(record));
    if (distances.size() > 1) {
        auto* second = m_page->findChild<QComboBox*>(QStringLiteral("column2"));
        second->setCurrentIndex(second->count() - 1);
    }
    for (int i = 0; i < distances.size(); ++i)
        typeInto(*m_page->findChild<QuantityField*>(QStringLiteral("distance%1").arg(i + 1)), distances[i]);
}

void TestIdentifyPage::anEmptyPageSaysWhatItDoes() {
    QVERIFY2(words().contains(QStringLiteral("Open a record")), qPrintable(words()));
    QCOMPARE(m_page->started(), 0);
    QVERIFY(m_page->command().isEmpty());
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    QSignalSpy wanted(m_page.get(), &IdentifyPage::recordWanted);
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("openRecord")), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
}

void TestIdentifyPage::aMissingDistanceIsAskedFor() {
    m_page->openRecord(caseFile(QStringLiteral("noise.csv")));
    QCOMPARE(m_page->started(), 0);
    QVERIFY2(words().contains(QStringLiteral("distance of gauge strain")), qPrintable(words()));
    typeInto(*m_page->findChild<QuantityField*>(QStringLiteral("distance1")), QStringLiteral("9 m"));
    QVERIFY2(words().contains(QStringLiteral("not on a uniform section")), qPrintable(words()));
    typeInto(*m_page->findChild<QuantityField*>(QStringLiteral("distance1")), QStringLiteral("1.83 m"));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(m_page->findChild<QLabel*>(QStringLiteral("place1"))->text().contains(QStringLiteral("1.83")));
}

void TestIdentifyPage::aDimensionlessScenarioSaysWhyNot() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QCOMPARE(m_document->startFrom(findExample("paper_fig8_minimum")->text, QStringLiteral("groups")),
             QString());
    QVERIFY2(words().contains(QStringLiteral("physical units")), qPrintable(words()));
    QVERIFY(!m_page->answer());
    QVERIFY(!m_page->findChild<StaleVeil*>()->isVisible());
}

void TestIdentifyPage::theAnswerIsThatOfTheCommand_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("distances");
    QTest::newRow("rod, one gauge") << "noise" << QStringList{"1.83 m"};
    QTest::newRow("string, two gauges") << "string" << QStringList{"1.13 m", "2.93 m"};
    QTest::newRow("one side of a bent rod") << "bending" << QStringList{"1.83 m"};
    QTest::newRow("rock that yields") << "corner" << QStringList{"1.83 m"};
}

void TestIdentifyPage::theAnswerIsThatOfTheCommand() {
    QFETCH(QString, name);
    QFETCH(QStringList, distances);
    start(name + QStringLiteral(".yaml"));
    open(name + QStringLiteral(".csv"), distances);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const test::Finished text = test::shell(m_page->command());
    constexpr int nothingKnown = 6;
    const bool isKnown = m_page->answer()->report.findings.saysSomething();
    QVERIFY2(text.exitCode == (isKnown ? 0 : nothingKnown), text.error.constData());
    QCOMPARE(belowTitle(text.out), belowTitle(identifyText(m_page->answer()->report).c_str()));
    const QString sentence = translated(identifySentence(found()));
    QCOMPARE(words(), sentence);
    QVERIFY(QString::fromUtf8(text.out).simplified().contains(sentence.simplified()));

    const test::Finished json = test::shell(m_page->command() + QStringLiteral(" --json"));
    const QJsonArray parameters =
        QJsonDocument::fromJson(json.out).object()[QStringLiteral("parameters")].toArray();
    QCOMPARE(std::size_t(parameters.size()), found().parameters.size());
    QTableWidget& values = table("values");
    QCOMPARE(values.rowCount(), int(parameters.size()));
    for (int i = 0; i < int(parameters.size()); ++i) {
        const IdentifiedParameter& shown = found().parameters[std::size_t(i)];
        QCOMPARE(shown.value, parameters[i].toObject()[QStringLiteral("value")].toDouble());
        const bool isOpen = parameters[i].toObject()[QStringLiteral("low")].isNull() ||
                            parameters[i].toObject()[QStringLiteral("high")].isNull();
        QCOMPARE(values.item(i, 2)->text().isEmpty(), isOpen);
    }
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("copyAnswer")), Qt::LeftButton);
    QVERIFY(QGuiApplication::clipboard()->text().simplified().contains(sentence.simplified()));
    const QList<QByteArray> lines = m_page->exports().first().csv().split('\n');
    QCOMPARE(lines.first(), QByteArray("time [s],incident [N],measured [N],model [N],residual [N]"));
    QCOMPARE(m_page->exports()[1].csv().count('\n'), qsizetype(posteriorRows + 1));
}

void TestIdentifyPage::theButtonThatOpensARecordIsInViewInALowWindow() {
    QScrollArea window;
    window.setWidget(m_page.get());
    window.setWidgetResizable(true);
    const auto* button = m_page->findChild<QPushButton*>(QStringLiteral("openRecord"));
    window.resize(900, 500);
    window.show();
    QVERIFY(button->isVisible());
    window.resize(1100, 900);
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    window.resize(901, 500);
    QTRY_VERIFY(!button->isVisible());
    window.takeWidget();
}

void TestIdentifyPage::aRejectedRecordHasNoIntervals() {
    start(QStringLiteral("string_head_left_out.yaml"));
    open(QStringLiteral("string_head_left_out.csv"), {QStringLiteral("1.13 m"), QStringLiteral("2.93 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY2(words().contains(QStringLiteral("nothing is known about the rock")), qPrintable(words()));
    QVERIFY(table("values").rowCount() > 0);
    QVERIFY(!table("values").isEnabled());
    for (int row = 0; row < table("values").rowCount(); ++row) {
        QCOMPARE(table("values").item(row, 2)->text(), QString());
        QVERIFY(!table("values").item(row, 2)->data(Qt::UserRole).isValid());
    }
    QVERIFY(!m_page->findChild<QPushButton*>(QStringLiteral("useRock"))->isEnabled());
    QVERIFY(!table("limits").isVisible());
    QVERIFY(!m_page->exports()[1].obstacle().isEmpty());
}

void TestIdentifyPage::theRecordIsShownInThreeRows() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const StudyFigure figure = identifyFigure(m_page->answer()->report.findings, found());
    QCOMPARE(figure.panels.size(), std::size_t(3));
    QCOMPARE(figure.panels[0].bands.size(), std::size_t(3));
    // Each band follows the one before.
    for (std::size_t i = 1; i < 3; ++i)
        QVERIFY(figure.panels[0].bands[i].from >= figure.panels[0].bands[i - 1].to);
    QList<QCPAxisRect*> rects{rectOf(0), rectOf(1)};
    for (QCPAxisRect* rect : m_page->plot()->axisRects())
        if (!rects.contains(rect)) rects.append(rect);
    QCOMPARE(rects.size(), 3);
    m_page->plot()->replot();
    QVERIFY(rects[0]->bottom() < rects[1]->top() && rects[1]->bottom() < rects[2]->top());
    rects[1]->axis(QCPAxis::atBottom)->setRange(0.1, 0.2);
    QCOMPARE(rects[0]->axis(QCPAxis::atBottom)->range(), QCPRange(0.1, 0.2));
    QVERIFY(rects[2]->axis(QCPAxis::atBottom)->range() != QCPRange(0.1, 0.2));
    // A cursor stands in both plots over time, and not in the one over penetration.
    const QList<QCPAxisRect*> withCursors = m_page->plot()->reader().cursors().rects();
    QCOMPARE(withCursors.size(), 2);
    QVERIFY(withCursors.contains(rects[0]) && withCursors.contains(rects[1]));
}

void TestIdentifyPage::theRockIsUsedAsOneUndoStep() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const Scenario before = m_document->scenario();
    const int started = m_page->started();  // one for each value on the way to 1.83 m
    const Scenario wanted = identifiedScenario(before, m_page->answer()->report.findings);
    QSignalSpy pinned(m_page.get(), &Page::pinRequested);
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("pinRock")), Qt::LeftButton);
    QCOMPARE(pinned.count(), 1);
    QCOMPARE(pinned[0][0].value<ScenarioDocument>().scenario.bitRock, wanted.bitRock);
    QCOMPARE(m_document->undoStack().count(), 0);
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("useRock")), Qt::LeftButton);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(m_document->scenario().bitRock, wanted.bitRock);
    const QByteArray text = m_document->text();
    QVERIFY2(text.contains("# identified from noise.csv: "), text.constData());
    QCOMPARE(m_page->started(), started);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario(), before);
}

void TestIdentifyPage::theRockOfTheScenarioIsNotAsked() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const int started = m_page->started();
    m_document->assign(*findParameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    QCOMPARE(m_page->started(), started);
    m_document->assign(*findParameter("rod.diameter"), 38.5e-3, m_document->newGesture());
    QCOMPARE(m_page->started(), started + 1);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    // With the law of the file its rock is what the record is compared with.
    m_page->findChild<QComboBox*>(QStringLiteral("law"))->setCurrentIndex(3);
    QCOMPARE(m_page->started(), started + 2);
    m_document->assign(*findParameter("bit_rock.stiffness"), 3e8, m_document->newGesture());
    QCOMPARE(m_page->started(), started + 3);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QCOMPARE(found().law, std::string("file"));
    QVERIFY(!m_page->findChild<QPushButton*>(QStringLiteral("useRock"))->isEnabled());
}

// The file says 1.98 m, and the gauge is at 1.83 m.
void TestIdentifyPage::aDraggedArrivalMovesTheGauge() {
    start(QStringLiteral("distance.yaml"));
    open(QStringLiteral("distance.csv"), {QStringLiteral("1.98 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(found().has("distance_off"));
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    PlotWidget& plot = *m_page->plot();
    plot.replot();
    const auto* line = m_page->findChild<DragLine*>();
    QCPAxisRect* rect = rectOf(0);
    QCPAxis* time = rect->axis(QCPAxis::atBottom);
    const double factor = line->x() / (found().curves.front + found().match.roundTripOfFile);
    const double seen = (found().curves.front + found().match.roundTrip) * factor;
    const int y = rect->center().y();
    const int started = m_page->started();
    QTest::mousePress(&plot, Qt::LeftButton, {}, QPoint(qRound(time->coordToPixel(line->x())), y));
    // Within the pixels from which it jumps there.
    const QPoint target(qRound(time->coordToPixel(seen)) + 2, y);
    QTest::mouseMove(&plot, target);
    QMouseEvent move(QEvent::MouseMove, target, plot.mapToGlobal(target), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&plot, &move);
    QCOMPARE(m_page->started(), started);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, target);
    QCOMPARE(line->x(), seen);
    QCOMPARE(m_page->started(), started + 1);
    const double distance = m_page->gaugeFields().gauges().front().distance;
    QVERIFY2(std::abs(distance - 1.83) < 0.015, qPrintable(QString::number(distance)));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(!found().has("distance_off"));
}

void TestIdentifyPage::aTypedToleranceNarrowsTheInterval() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const double before = found().parameters.front().halfWidth;
    auto* field = m_page->findChild<QuantityField*>(QStringLiteral("known.rod.diameter"));
    QVERIFY(field);
    QVERIFY(!field->value());  // assumed
    QTest::mouseClick(m_page->findChild<SectionBox*>()->findChild<QToolButton*>(), Qt::LeftButton);
    typeInto(*field, QStringLiteral("0.05 mm"));
    QVERIFY2(m_page->command().contains(QStringLiteral("--known rod.diameter=+-0.05mm")),
             qPrintable(m_page->command()));
    QTRY_VERIFY_WITH_TIMEOUT(isDone() && m_page->activity()->isCurrent(), 60000);
    QVERIFY(found().parameters.front().halfWidth < before);
    const test::Finished text = test::shell(m_page->command());
    QCOMPARE(belowTitle(text.out), belowTitle(identifyText(m_page->answer()->report).c_str()));
}

void TestIdentifyPage::aClickOnALimitGoesToItsField() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QTableWidget& limits = table("limits");
    const QList<QTableWidgetItem*> rows = limits.findItems(QStringLiteral("diameter"), Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    emit limits.cellClicked(rows.first()->row(), 0);
    auto* field = m_page->findChild<QuantityField*>(QStringLiteral("known.rod.diameter"));
    QVERIFY(field->isVisible());
    QVERIFY(field->hasFocus() || field->focusProxy() || m_page->focusWidget() == field);
}

// A record that is cut says nothing of the elasticity.
void TestIdentifyPage::limitsReadAsInTheText() {
    open(QStringLiteral("cut.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    const QTableWidget& limits = table("limits");
    QVERIFY(limits.rowCount() > 0);
    QTest::mouseClick(m_page->findChild<QPushButton*>(QStringLiteral("copyAnswer")), Qt::LeftButton);
    const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
    for (int row = 0; row < limits.rowCount(); ++row) {
        const QString effects = limits.item(row, 1)->text() + u' ' + limits.item(row, 2)->text();
        QCOMPARE(limits.item(row, 2)->text(), QStringLiteral("-"));
        const QString cause = limits.item(row, 0)->text();
        QVERIFY2(std::ranges::any_of(lines,
                                     [&](const QString& line) {
                                         return line.simplified().startsWith(cause + u' ' + effects);
                                     }),
                 qPrintable(cause + u' ' + effects));
    }
}

void TestIdentifyPage::aCancelledRecordIsNotWritten() {
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QCOMPARE(m_page->activity()->state(), StudyState::running);
    m_page->activity()->cancel();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    QVERIFY(!m_page->plot()->isCurrent());
    QVERIFY(!m_page->answer());
    m_page->activity()->resume();
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    QVERIFY(m_page->exports().first().obstacle().isEmpty());
}

void TestIdentifyPage::anUnreadableRecordSaysWhy() {
    m_page->openRecord(caseFile(QStringLiteral("truth.json")));
    QVERIFY2(words().contains(QStringLiteral("column")), qPrintable(words()));
    open(QStringLiteral("noise.csv"), {QStringLiteral("1.83 m")});
    QTRY_VERIFY_WITH_TIMEOUT(isDone(), 60000);
    m_page->openRecord(m_folder.filePath(QStringLiteral("gone.csv")));
    QVERIFY2(words().contains(QStringLiteral("column")), qPrintable(words()));
    QVERIFY(!m_page->answer());
}

void TestIdentifyPage::aRecordIsChosenByTheImportDialog() {
    m_page.reset();
    ImportFixture::start();
    QVERIFY(m_window->openFile(caseFile(QStringLiteral("noise.yaml"))));
    auto& pages = part<PageTabs>(*m_window);
    auto* page = pages.findChild<IdentifyPage*>();
    pages.setCurrentWidget(page);
    m_answers.import = caseFile(QStringLiteral("noise.csv"));
    QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("openRecord")), Qt::LeftButton);
    auto* dialog = m_window->findChild<ImportDialog*>();
    QVERIFY(dialog);
    QCOMPARE(dialog->use(), ImportUse::rockRecord);
    QVERIFY(settle(*dialog));
    QVERIFY2(dialog->result(), qPrintable(message(*dialog)));
    QVERIFY(!test::control<ChoiceBox>(*dialog, "zero").isVisible());
    test::control<QPushButton>(*dialog, "take").click();
    QCOMPARE(page->findChild<QLabel*>(QStringLiteral("recordName"))->text(), QStringLiteral("noise.csv"));
    QCOMPARE(page->gaugeFields().gauges().size(), std::size_t(1));
    m_window.reset();
}

QTEST_MAIN(TestIdentifyPage)
#include "tst_identify_page.moc"
