// SPDX-License-Identifier: GPL-3.0-or-later
// The window exports what the command line writes, and reports every failure.
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>
#include <QPushButton>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/archive/result_scenario.h"
#include "core/yaml/examples.h"
#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/export/export_menu.h"
#include "ui/export/numbers_window.h"
#include "ui/export/plot_export.h"
#include "ui/job/study_status.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/plot/plot_widget.h"
#include "ui/questions/picture_dialog.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// But for what cannot be the same twice.
QByteArray comparable(const QString& path) {
    QByteArray bytes = read(path);
    if (path.endsWith(QStringLiteral(".pdf"))) return bytes.left(5);
    if (!path.endsWith(QStringLiteral("summary.json"))) return bytes;
    QJsonObject object = QJsonDocument::fromJson(bytes).object();
    object.remove(QStringLiteral("run_time"));
    return QJsonDocument(object).toJson();
}

}  // namespace

class TestExportMenu : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void cleanup();
    void everythingIsWhatTheCommandLineWrites_data();
    void everythingIsWhatTheCommandLineWrites();
    void filesInTheFolderAreOverwrittenOnlyOnRequest();
    void historiesHoldTheUnsavedScenarioInTheShownUnits();
    void aBlowThatIsNotSolvedIsNotExported();
    void failuresAreTold_data();
    void failuresAreTold();
    void thePictureHasItsSizeAndIsWhiteInTheDark();
    void thePictureGoesToTheClipboard();
    void theDataOfThePlotBeginWithTheScenario();
    void thePlotsOwnMenuExportsToo();
    void theMenuOffersWhatThePageDoes();
    void theNumbersAreThoseOfTheFile();
    void theDialogRefusesPicturesThatAreTooLarge();
    void choicesOfPicturesAreRemembered();

  private:
    MainWindow& window() { return *m_window; }
    void makeWindow(SolveJob::Solve solve);
    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    void edit(double metres) { window().document().assign(*findParameter("rod.length"), metres, 1); }
    PageExport numbers() { return part<BlowPage>(window()).exports().first(); }
    PageExport picture() { return part<BlowPage>(window()).exports().last(); }
    // Exports wait for the result of the present input.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(part<SolveStatus>(window()).isCurrent(), 60000); }

    std::unique_ptr<QTemporaryDir> m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestExportMenu::initTestCase() {
    QLocale::setDefault(QLocale::c());
}

void TestExportMenu::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(path("settings"));
    m_answers = {};
    makeWindow(exactSolve());
}

void TestExportMenu::cleanup() {
    m_window.reset();
}

void TestExportMenu::makeWindow(SolveJob::Solve solve) {
    m_window = newWindow(m_answers, std::move(solve));
    m_window->show();
}

void TestExportMenu::everythingIsWhatTheCommandLineWrites_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<bool>("edited");
    QTest::newRow("in SI units") << QStringLiteral("t38_medium_rock") << false;
    QTest::newRow("by groups") << QStringLiteral("paper_fig4b") << false;
    QTest::newRow("with unsaved edits") << QStringLiteral("t38_medium_rock") << true;
    QTest::newRow("of a drill string") << QStringLiteral("r32_string") << false;
}

void TestExportMenu::everythingIsWhatTheCommandLineWrites() {
    QFETCH(QString, example);
    QFETCH(bool, edited);
    QVERIFY(window().openFile(test::example(example)));
    QStringList words{QStringLiteral("run"), test::example(example)};
    if (edited) {
        edit(4.5);
        words << QStringLiteral("--set") << QStringLiteral("rod.length=4.5 m");
    }
    m_answers.folder = path("window");
    part<ExportMenu>(window()).saveEverything();
    settle();
    QCOMPARE(m_answers.told, QStringList());
    words << QStringLiteral("-o") << path("command") << QStringLiteral("--plots")
          << QStringLiteral("png,svg,pdf");
    const test::Finished finished = test::run(words);
    QVERIFY2(finished.exitCode == 0, finished.error);
    const QStringList names = QDir(path("command")).entryList(QDir::Files);
    QCOMPARE(names.size(), 16);
    QCOMPARE(QDir(path("window")).entryList(QDir::Files), names);
    for (const QString& name : names) {
        const QByteArray here = comparable(path("window/") + name);
        QVERIFY2(!here.isEmpty() && here == comparable(path("command/") + name), qPrintable(name));
    }
}

void TestExportMenu::filesInTheFolderAreOverwrittenOnlyOnRequest() {
    m_answers.folder = path("out");
    part<ExportMenu>(window()).saveEverything();
    QCOMPARE(m_answers.confirmed, QStringList());
    const QByteArray before = read(path("out/histories.csv"));
    edit(5);
    part<ExportMenu>(window()).saveEverything();
    QCOMPARE(m_answers.confirmed.size(), 1);
    QVERIFY(m_answers.confirmed.first().contains(QStringLiteral("histories.csv")));
    QCOMPARE(read(path("out/histories.csv")), before);
    m_answers.confirm = true;
    part<ExportMenu>(window()).saveEverything();
    settle();
    QVERIFY(read(path("out/histories.csv")).contains("length: 5 m"));
}

void TestExportMenu::historiesHoldTheUnsavedScenarioInTheShownUnits() {
    edit(5);
    m_answers.exportTo = path("h.csv");
    QSignalSpy exported(&part<ExportMenu>(window()), &ExportMenu::exported);
    part<ExportMenu>(window()).saveHistories();
    QTRY_COMPARE(exported.size(), 1);
    QVERIFY(read(path("h.csv")).contains("\ntime [s],impact_force [N],"));
    // The blow on the screen was that of the rod before the edit.
    const ScenarioDocument again = loadResultScenario(path("h.csv").toStdString());
    QVERIFY(again.scenario == window().document().scenario());
    part<UnitsChoice>(window()).choose(UnitSystem::dimensionless);
    settle();
    QCOMPARE(window().shown()->request.units, UnitSystem::dimensionless);
    m_answers.exportTo = path("e.csv");
    part<ExportMenu>(window()).saveEvents();
    QVERIFY(read(path("e.csv")).contains("\nkind,time\ncontact,"));
    QCOMPARE(m_answers.told, QStringList());
}

void TestExportMenu::aBlowThatIsNotSolvedIsNotExported() {
    makeWindow([](const SolveRequest& request) {
        return failedBlow(request, QStringLiteral("The rod has melted."));
    });
    m_answers.exportTo = path("h.csv");
    m_answers.folder = path("out");
    part<ExportMenu>(window()).saveHistories();
    part<ExportMenu>(window()).saveEvents();
    part<ExportMenu>(window()).saveEverything();
    part<ExportMenu>(window()).save(numbers());
    QCOMPARE(m_answers.told.size(), 4);
    for (const QString& told : m_answers.told) QVERIFY(told.contains(QStringLiteral("melted")));
    QVERIFY(QDir(m_folder->path()).entryList({QStringLiteral("h.csv"), QStringLiteral("out")}).isEmpty());
}

void TestExportMenu::failuresAreTold_data() {
    QTest::addColumn<QString>("place");
    QTest::newRow("a file where a folder should be") << QStringLiteral("file");
    QTest::newRow("a folder that does not exist") << QStringLiteral("missing/deep");
    QTest::newRow("a folder where the file should be") << QStringLiteral("folder");
}

void TestExportMenu::failuresAreTold() {
    QFETCH(QString, place);
    QFile file(path("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("folder/h.csv")));
    m_answers.exportTo = m_folder->filePath(place + QStringLiteral("/h.csv"));
    m_answers.picture = PictureChoice{};
    part<ExportMenu>(window()).saveHistories();
    part<ExportMenu>(window()).saveEvents();
    part<ExportMenu>(window()).save(picture());
    part<ExportMenu>(window()).save(numbers());
    QCOMPARE(m_answers.told.size(), 4);
    for (const QString& told : m_answers.told)
        QVERIFY2(told.contains(QStringLiteral("h.csv")), qPrintable(told));
    m_answers.folder = path("file");
    part<ExportMenu>(window()).saveEverything();
    QCOMPARE(m_answers.told.size(), 5);
}

void TestExportMenu::thePictureHasItsSizeAndIsWhiteInTheDark() {
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(30, 30, 30));
    dark.setColor(QPalette::Text, Qt::white);
    part<BlowPage>(window()).plot()->setPalette(dark);
    m_answers.exportTo = path("p.png");
    m_answers.picture = PictureChoice{QStringLiteral("png"), {120, 80}, 254};
    part<ExportMenu>(window()).save(picture());
    QCOMPARE(m_answers.told, QStringList());
    const QImage image(path("p.png"));
    QVERIFY(std::abs(image.width() - 1200) <=
            3);  // 10 pixels a millimetre; layout is in whole pixels of 96 dpi
    QVERIFY(std::abs(image.height() - 800) <= 3);
    QVERIFY(std::abs(image.dotsPerMeterX() - 10000) <= 1);
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    for (const char* format : {"svg", "pdf"}) {
        m_answers.exportTo = m_folder->filePath(QStringLiteral("p.") + QLatin1String(format));
        m_answers.picture->format = QLatin1String(format);
        part<ExportMenu>(window()).save(picture());
        QVERIFY(read(m_answers.exportTo).size() > 2000);
    }
}

void TestExportMenu::thePictureGoesToTheClipboard() {
    QGuiApplication::clipboard()->clear();
    part<ExportMenu>(window()).findChild<QAction*>(QStringLiteral("copyPicture"))->trigger();
    QVERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
    QCOMPARE(QGuiApplication::clipboard()->image().pixelColor(0, 0), QColor(Qt::white));
}

void TestExportMenu::theDataOfThePlotBeginWithTheScenario() {
    m_answers.exportTo = path("d.csv");
    part<ExportMenu>(window()).save(numbers());
    QCOMPARE(m_answers.told, QStringList());
    QVERIFY(loadResultScenario(path("d.csv").toStdString()).scenario == window().document().scenario());
    QVERIFY(read(path("d.csv")).count('\n') > 100);
}

void TestExportMenu::thePlotsOwnMenuExportsToo() {
    m_answers.exportTo = path("d.csv");
    emit part<BlowPage>(window()).plot()->saveDataRequested();
    QVERIFY(QFile::exists(path("d.csv")));
    m_answers.exportTo = path("p.svg");
    m_answers.picture = PictureChoice{QStringLiteral("svg"), {120, 80}, 200};
    emit part<BlowPage>(window()).plot()->savePictureRequested();
    QVERIFY(QFile::exists(path("p.svg")));
}

void TestExportMenu::theMenuOffersWhatThePageDoes() {
    ExportMenu& menu = part<ExportMenu>(window());
    const auto lines = [&menu] {
        QStringList texts;
        for (const QAction* action : menu.actions())
            texts << (action->isSeparator() ? QStringLiteral("-") : QString(action->text()).remove(u'&'));
        return texts;
    };
    const QStringList usual{QStringLiteral("Histories…"),
                            QStringLiteral("Events…"),
                            QStringLiteral("Data of this plot…"),
                            QStringLiteral("Numbers as a table"),
                            QStringLiteral("-"),
                            QStringLiteral("Picture of this plot…"),
                            QStringLiteral("Copy picture"),
                            QStringLiteral("-"),
                            QStringLiteral("Everything into a folder…")};
    QCOMPARE(lines(), usual);
    auto* copy = menu.findChild<QAction*>(QStringLiteral("copyPicture"));
    // A page of two tables and no plot.
    PageExport table;
    table.csv = [] { return QByteArray("a,b\n1,2\n"); };
    table.title = QStringLiteral("Needs…");
    PageExport other = table;
    other.title = QStringLiteral("Gaps…");
    menu.setExports({table, other});
    QCOMPARE(lines().mid(2, 4), (QStringList{QStringLiteral("Needs…"), QStringLiteral("Gaps…"),
                                             QStringLiteral("Numbers as a table"), QStringLiteral("-")}));
    QVERIFY(!copy->isEnabled());
    m_answers.exportTo = path("t.csv");
    menu.actions().at(3)->trigger();
    QVERIFY(read(path("t.csv")).endsWith("a,b\n1,2\n"));
    menu.setExports({numbers(), picture()});
    QCOMPARE(lines(), usual);
    QVERIFY(copy->isEnabled());
}

void TestExportMenu::theNumbersAreThoseOfTheFile() {
    ExportMenu& menu = part<ExportMenu>(window());
    QLocale::setDefault(QLocale(QLocale::German));
    const auto again = qScopeGuard([] { QLocale::setDefault(QLocale::c()); });
    menu.findChild<QAction*>(QStringLiteral("numbersAsTable"))->trigger();
    settle();
    auto* shown = window().findChild<NumbersWindow*>();
    QVERIFY(shown && shown->isVisible());
    const auto* view = shown->findChild<QTableView*>();
    const QList<QByteArray> lines = numbers().csv().trimmed().split('\n');
    const QAbstractItemModel& model = *view->model();
    QCOMPARE(model.rowCount(), lines.size() - 1);
    QStringList heads, cells;
    const int last = model.rowCount() - 1;
    for (int column = 0; column < model.columnCount(); ++column) {
        heads << model.headerData(column, Qt::Horizontal).toString();
        cells << model.index(last, column).data().toString();
    }
    QCOMPARE(heads.join(u',').toUtf8(), lines.front());
    QCOMPARE(cells.join(u';').replace(u',', u'.').toUtf8(), QByteArray(lines.back()).replace(',', ';'));
    QVERIFY(cells.join(u' ').contains(u','));  // in the numbers of the reader
    // The chosen cells are copied for other programs, under the heads of their columns.
    view->selectionModel()->select(QItemSelection(model.index(0, 0), model.index(1, 1)),
                                   QItemSelectionModel::Select);
    view->actions().front()->trigger();
    const QStringList copied = QGuiApplication::clipboard()->text().split(u'\n');
    QCOMPARE(copied.size(), 3);
    QCOMPARE(copied.front(), heads.mid(0, 2).join(u'\t'));
    QCOMPARE(copied.back(),
             model.index(1, 0).data().toString() + u'\t' + model.index(1, 1).data().toString());
    delete shown;
    // Several tables stand side by side, a page of pictures has none.
    PageExport table;
    table.csv = [] { return QByteArray("# of the blow\nname,b\n\"1,5\",2\n"); };
    table.title = QStringLiteral("&Needs…");
    menu.setExports({table, table});
    menu.showNumbers();
    auto* tabs = window().findChild<NumbersWindow*>()->findChild<QTabWidget*>();
    QCOMPARE(tabs->count(), 2);
    QCOMPARE(tabs->tabText(0), QStringLiteral("Needs"));
    const QAbstractItemModel& quoted = *qobject_cast<QTableView*>(tabs->widget(1))->model();
    QCOMPARE(quoted.index(0, 0).data().toString(), QStringLiteral("1,5"));
    // Missing numbers are left out if there are others.
    PageExport missing = table;
    missing.obstacle = [] { return QStringLiteral("There is no scan yet."); };
    delete window().findChild<NumbersWindow*>();
    menu.setExports({missing, table});
    menu.showNumbers();
    QCOMPARE(window().findChild<NumbersWindow*>()->findChild<QTabWidget*>(), nullptr);
    menu.setExports({missing});
    menu.showNumbers();
    QVERIFY(m_answers.told.last().contains(QStringLiteral("no scan yet")));
    menu.setExports({picture()});
    QVERIFY(!menu.findChild<QAction*>(QStringLiteral("numbersAsTable"))->isEnabled());
}

void TestExportMenu::theDialogRefusesPicturesThatAreTooLarge() {
    PictureDialog dialog(PictureChoice{}, nullptr);
    auto* width = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("width"));
    auto* dpi = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("dpi"));
    const auto mayAccept = [&dialog] {
        for (const QPushButton* button : dialog.findChildren<QPushButton*>())
            if (button->isDefault()) return button->isEnabled();
        return false;
    };
    QVERIFY(mayAccept());
    width->setValue(1200);
    dpi->setValue(1200);
    QVERIFY(!mayAccept());
    dialog.findChild<QComboBox*>(QStringLiteral("format"))->setCurrentIndex(1);
    QVERIFY(mayAccept());  // lines have no pixels
    QVERIFY(!dpi->isEnabled());
    width->setValue(5);
    QVERIFY(!mayAccept());
}

void TestExportMenu::choicesOfPicturesAreRemembered() {
    QCOMPARE(rememberedPictureChoice(1.5).size.height, 120.0);
    m_answers.exportTo = path("p.svg");
    m_answers.picture = PictureChoice{QStringLiteral("svg"), {100, 70}, 150};
    part<ExportMenu>(window()).save(picture());
    const PictureChoice again = rememberedPictureChoice(1.5);
    QCOMPARE(again.format, QStringLiteral("svg"));
    QCOMPARE(again.size.width, 100.0);
    QCOMPARE(again.dpi, 150.0);
}

QTEST_MAIN(TestExportMenu)
#include "tst_export_menu.moc"
