// SPDX-License-Identifier: GPL-3.0-or-later
// The window in other languages: nothing is left in English, nothing is cut off, and files are the same.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"
#include "tests/support/files.h"
#include "tests/support/import_fixture.h"
#include "tests/support/pseudo_translator.h"
#include "tests/support/tries.h"
#include "tests/support/window_fixture.h"
#include "tests/ui/window/layout_check.h"
#include "tests/ui/window/shown_texts.h"
#include "ui/export/export_menu.h"
#include "ui/export/figure_plot.h"
#include "ui/export/numbers_window.h"
#include "ui/export/report_preview.h"
#include "ui/help/help_window.h"
#include "ui/pages/string/string_page.h"
#include "ui/questions/picture_dialog.h"
#include "ui/result/alert_list.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/window/figure_dialog.h"
#include "ui/window/manual_help.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/view_menu.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

std::unique_ptr<QTranslator> translator(const QString& code) {
    if (code == QLatin1String("pseudo")) return std::make_unique<PseudoTranslator>();
    return std::make_unique<Catalogue>(*findLanguage(code.toStdString()));
}

/// The application speaks a language as long as one lives.
class Speaking {
  public:
    explicit Speaking(const QString& code) : m_translator(translator(code)) {
        QCoreApplication::installTranslator(m_translator.get());
    }

  private:
    std::unique_ptr<QTranslator> m_translator;  // takes itself away
};

const char* const examples[] = {"t38_medium_rock", "paper_fig4b", "t38_string"};

/// Words that are the same in every language: names, units, formats, keys.
bool isNameless(const QString& word) {
    static const std::set<QString> names{
        "Drillwave", "English", "Deutsch", "Svenska", "COR",  "PNG",   "SVG",  "PDF",  "CSV", "HTML", "YAML",
        "lbf",       "kip",     "ksi",     "Mpsi",    "MPa",  "GPa",   "kPa",  "psi",  "Hz",  "bpm",  "min",
        "deg",       "rms",     "log",     "Del",     "Ctrl", "Shift", "Alt",  "Left", "Tab", "mod",  "MN",
        "Up",        "Down",    "Page",    "Esc",     "max",  "drill", "yaml", "runs", "csv", "json", "html",
        "daN",       "kgf",     "bar",     "kHz",     "rpm",  "rad",   "text"};  // an item of QCustomPlot
                                                                                 // that nothing is written in
    return names.contains(word);
}

/// Titles and names of scenarios and sections: data, as files have them.
const QStringList& data() {
    static const QStringList texts = [] {
        QStringList all;
        for (const Example& example : builtInExamples())
            all << QString::fromStdString(example.title) << QString::fromStdString(example.name);
        all << QStringLiteral("T38 rod") << QStringLiteral("shank adapter") << QStringLiteral("coupling");
        for (const char* name : {"bit skirt", "bit head", "adapter", "rod"}) all << QString::fromLatin1(name);
        std::ranges::sort(all, std::ranges::greater(), &QString::size);
        return all;
    }();
    return texts;
}

/// The words of it that nobody has translated.
QStringList untranslated(const ShownText& shown) {
    static const QRegularExpression word(QStringLiteral("(?<![\\w.])[A-Za-z]{3,}(?![\\w.])"));
    QString text = shown.text;
    for (const QString& each : data()) text.replace(each, QString());
    text = outsideMarks(text.remove(u'&'));
    static const QRegularExpression elided(QStringLiteral("[^⟦⟧]*…$"));  // a title that is too long
    text.remove(elided);
    QStringList found;
    for (const QRegularExpressionMatch& match : word.globalMatch(text))
        if (!isNameless(match.captured())) found << match.captured();
    return found;
}

QStringList untranslated(QWidget& window, const QString& page) {
    QStringList found;
    for (const ShownText& shown : shownTexts(window))
        if (const QStringList words = untranslated(shown); !words.isEmpty())
            found << QStringLiteral("%1, %2: %3 (%4)")
                         .arg(page, shown.where, shown.text.left(120), words.join(u' '));
    found.removeDuplicates();
    return found;
}

/// Keys that open two things of one menu.
QStringList doubleKeys(const QMenu& menu) {
    QStringList found;
    std::set<QChar> keys;
    for (const QAction* action : menu.actions()) {
        const qsizetype at = action->text().indexOf(u'&');
        if (at < 0 || at + 1 >= action->text().size() || !action->isVisible()) continue;
        if (const QChar key = action->text()[at + 1].toLower(); key != u'&' && !keys.insert(key).second)
            found << menu.title() + QStringLiteral(": ") + action->text();
    }
    return found;
}

}  // namespace

class TestLanguages : public QObject, WindowFixture {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void cleanup();
    void marksShowWhatIsNotTranslated();
    void everythingIsTranslated_data();
    void everythingIsTranslated();
    void dialogsAreTranslated();
    void importsAreTranslated_data();
    void importsAreTranslated();
    void helpAndReportsAreTranslated();
    void theWindowTakesEverySizeAtTheFirstAsking_data();
    void theWindowTakesEverySizeAtTheFirstAsking();
    void columnsOfSections_fitAWindowOf1280_data();
    void columnsOfSections_fitAWindowOf1280();
    void nothingIsCutOff_data();
    void nothingIsCutOff();
    void menusAndFieldsSpeak_data();
    void menusAndFieldsSpeak();
    void keysHaveOneName();
    void keysAreOfOneThingEach_data();
    void keysAreOfOneThingEach();
    void whatIsChosenCountsTheNextTime();
    void filesAreTheSame();

  private:
    void openIn(const QString& example);
    void visitPages(const std::function<void(int)>& look);
    QMap<QString, QByteArray> writeFiles(const QString& folder);
};

void TestLanguages::cleanup() {
    m_window.reset();
    Settings().clear();
}

void TestLanguages::openIn(const QString& example) {
    start();
    m_window->openExample(*findExample(example.toStdString()));
    settle();
}

void TestLanguages::visitPages(const std::function<void(int)>& look) {
    auto& pages = part<PageTabs>(window());
    for (int page = 0; page < pages.count(); ++page) {
        if (!pages.isOffered(page)) continue;
        pages.setCurrentIndex(page);
        settle();
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();  // what the last event has asked for
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        for (int pass = 0; pass < 2; ++pass)
            for (QLayout* each : window().findChildren<QLayout*>()) each->activate();
        look(page);
    }
}

void TestLanguages::marksShowWhatIsNotTranslated() {
    QCOMPARE(pseudo(QStringLiteral("%1 of %2")), QStringLiteral("%1⟦ of ~~⟧%2"));
    QCOMPARE(pseudo(QStringLiteral("<b>&Open</b>")), QStringLiteral("<b>⟦&Open~~⟧</b>"));
    QCOMPARE(outsideMarks(QStringLiteral("⟦a⟦b⟧⟧ 12 kN ⟦c⟧")), QStringLiteral(" 12 kN "));
    QCOMPARE(untranslated({QStringLiteral("a label"), QStringLiteral("⟦length~~⟧ 12 MPa")}), QStringList());
    QCOMPARE(untranslated({QStringLiteral("a label"), QStringLiteral("⟦peak~~⟧ of steel")}),
             QStringList{QStringLiteral("steel")});
}

void TestLanguages::everythingIsTranslated_data() {
    QTest::addColumn<QString>("example");
    int row = 0;
    for (const char* example : examples)
        if (isChosen(row++, 3)) QTest::newRow(example) << QString::fromLatin1(example);
}

void TestLanguages::everythingIsTranslated() {
    QFETCH(QString, example);
    const Speaking speaking(QStringLiteral("pseudo"));
    openIn(example);
    part<PinnedRuns>(window()).pinAction()->trigger();
    settle();
    QStringList found;
    visitPages(
        [&](int page) { found += untranslated(window(), part<PageTabs>(window()).page(page).title()); });
    found.removeDuplicates();
    for (const QString& each : found) qWarning("%s", qPrintable(each));  // one message is cut off
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

void TestLanguages::dialogsAreTranslated() {
    const Speaking speaking(QStringLiteral("pseudo"));
    QStringList found;
    PictureDialog picture({}, nullptr);
    found += untranslated(picture, QStringLiteral("picture"));
    FigureDialog figure(6, nullptr);
    for (const ShownText& shown : shownTexts(figure))
        // Texts of the paper are quoted.
        if (!shown.where.contains(QStringLiteral("QCustomPlot")) && !shown.where.contains("cell") &&
            shown.text != figureText(figure.figure().caption))
            found += untranslated(shown);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

void TestLanguages::importsAreTranslated_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<ImportUse>("use");
    int row = 0;
    for (const char* code : {"pseudo", "de", "sv"})
        for (const ImportUse use : {ImportUse::blow, ImportUse::normalForce})
            if (isChosen(row++, 3))
                QTest::addRow("%s, %s", code, use == ImportUse::blow ? "blow" : "measured") << code << use;
}

// Texts of the file are quoted, and units have their names.
void TestLanguages::importsAreTranslated() {
    QFETCH(QString, code);
    QFETCH(ImportUse, use);
    const Speaking speaking(code);
    openIn(QStringLiteral("t38_medium_rock"));
    m_answers.import = m_folder.filePath(QStringLiteral("record.csv"));
    QFile file(m_answers.import);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(gaugeRecord());
    file.close();
    window().findChild<QPushButton*>(QStringLiteral("importBlow"))->click();
    auto& dialog = part<ImportDialog>(window());
    auto& choice = control<ChoiceBox>(dialog, "use");
    choice.setCurrentIndex(choice.findData(static_cast<int>(use)));
    QVERIFY(QTest::qWaitFor([&] { return !dialog.isBusy(); }, 60000));
    QCoreApplication::processEvents();
    QVERIFY(QTest::qWaitFor([&] { return !dialog.isBusy(); }, 60000));
    QStringList found;
    if (code != QLatin1String("pseudo")) {
        found = clippedTexts(dialog) + overlaps(dialog);
    } else {
        for (const ShownText& shown : shownTexts(dialog)) {
            ShownText bare = shown;
            for (const char* quoted : {"Recorder", "record", "Zeit", "DMS", "microstrain"})
                bare.text.remove(QLatin1String(quoted));
            if (const QStringList words = untranslated(bare); !words.isEmpty())
                found << shown.where + QStringLiteral(": ") + shown.text.left(120) + words.join(u' ');
        }
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

// Around the manual, which is in English, and the pages of a report.
void TestLanguages::helpAndReportsAreTranslated() {
    const Speaking speaking(QStringLiteral("pseudo"));
    openIn(QStringLiteral("t38_medium_rock"));
    QStringList found;
    const auto look = [&found](QWidget& shown, const QString& name, const QRegularExpression& quoting) {
        for (const ShownText& text : shownTexts(shown))
            if (!text.where.contains(quoting) && !untranslated(text).isEmpty())
                found << name + QStringLiteral(": ") + text.where + QStringLiteral(": ") +
                             text.text.left(120);
    };
    QTest::keyClick(&window(), Qt::Key_F1);
    look(*part<ManualHelp>(window()).helpWindow(), QStringLiteral("help"),
         QRegularExpression(QStringLiteral("cell|“manual”.*description")));
    window().findChild<QAction*>(QStringLiteral("previewReport"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<ReportPreview*>(), 120000);
    look(part<ReportPreview>(window()), QStringLiteral("preview"), QRegularExpression(QStringLiteral("^$")));
    window().findChild<QAction*>(QStringLiteral("numbersAsTable"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<NumbersWindow*>(), 60000);
    look(part<NumbersWindow>(window()), QStringLiteral("numbers"),
         QRegularExpression(QStringLiteral("cell|column|QHeader")));  // those of a file
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

void TestLanguages::nothingIsCutOff_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("example");
    int row = 0;
    for (const char* code : {"de", "sv"})
        for (const char* example : examples)
            if (isChosen(row++, 5))
                QTest::addRow("%s, %s", code, example)
                    << QString::fromLatin1(code) << QString::fromLatin1(example);
}

void TestLanguages::theWindowTakesEverySizeAtTheFirstAsking_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QSize>("size");
    for (const char* code : {"en", "de", "sv"})
        for (const QSize size : {QSize(1000, 650), QSize(800, 500)})
            QTest::addRow("%s, %d × %d", code, size.width(), size.height())
                << QString::fromLatin1(code) << size;
}

void TestLanguages::theWindowTakesEverySizeAtTheFirstAsking() {
    QFETCH(QString, code);
    QFETCH(QSize, size);
    const Speaking speaking(code);
    openIn(QStringLiteral("t38_string"));
    window().resize(1440, 900);
    settle();
    const QList<QDockWidget*> docks = window().findChildren<QDockWidget*>();
    QTRY_VERIFY(window().tabifiedDockWidgets(docks[0]).isEmpty());
    window().resize(size);
    QCOMPARE(window().size(), size);
    QTRY_COMPARE(window().tabifiedDockWidgets(docks[0]).size(), 1);
    settle();
    QCOMPARE(window().size(), size);
    visitPages([&](int page) {
        QVERIFY2(window().size() == size, qPrintable(part<PageTabs>(window()).page(page).title()));
    });
    window().resize(1440, 900);
    QTRY_VERIFY(window().tabifiedDockWidgets(docks[0]).isEmpty());
}

void TestLanguages::columnsOfSections_fitAWindowOf1280_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("example");
    for (const char* code : {"en", "de", "sv"})
        for (const char* example : {"t38_string", "r32_string", "t51_string"})
            QTest::addRow("%s, %s", code, example)
                << QString::fromLatin1(code) << QString::fromLatin1(example);
}

void TestLanguages::columnsOfSections_fitAWindowOf1280() {
    QFETCH(QString, code);
    QFETCH(QString, example);
    const Speaking speaking(code);
    openIn(example);
    window().resize(1280, 800);
    settle();
    auto& page = part<StringPage>(window());
    part<PageTabs>(window()).setCurrentWidget(&page);
    settle();
    QTRY_COMPARE(page.table()->horizontalScrollBar()->maximum(), 0);
}

void TestLanguages::nothingIsCutOff() {
    QFETCH(QString, code);
    QFETCH(QString, example);
    const Speaking speaking(code);
    openIn(example);
    const QSize size(1000, 650);
    window().resize(size);
    part<PinnedRuns>(window()).pinAction()->trigger();
    settle();
    QStringList found;
    visitPages([&](int page) {
        const QString title = part<PageTabs>(window()).page(page).title();
        for (const QString& each : clippedTexts(window()) + cutTabs(window()) + overlaps(window()))
            found << title + QStringLiteral(": ") + each;
        if (window().width() > size.width() || window().height() > size.height())
            found
                << QStringLiteral("%1 wants %2 × %3").arg(title).arg(window().width()).arg(window().height());
    });
    for (const QString& each : found) qWarning("%s", qPrintable(each));
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

void TestLanguages::menusAndFieldsSpeak_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QStringList>("menus");
    QTest::addColumn<QStringList>("labels");
    QTest::newRow("de") << "de" << QStringList{"&Datei", "&Bearbeiten", "&Ansicht", "&Studie", "&Hilfe"}
                        << QStringList{"Stoßzahl e", "erforderlich, jeder Spalt", "Andruck", "Schlagfrequenz",
                                       "Steifigkeit k"};
    QTest::newRow("sv") << "sv" << QStringList{"&Arkiv", "&Redigera", "&Visa", "&Studie", "&Hjälp"}
                        << QStringList{"studstal e", "matningskraft", "slagfrekvens", "styvhet k"};
}

void TestLanguages::menusAndFieldsSpeak() {
    QFETCH(QString, code);
    QFETCH(QStringList, menus);
    QFETCH(QStringList, labels);
    const Speaking speaking(code);
    openIn(QStringLiteral("t38_medium_rock"));
    QStringList titles;
    for (const QAction* action : window().menuBar()->actions()) titles << action->text();
    QCOMPARE(titles, menus);
    QStringList texts;
    for (const QLabel* label : window().findChildren<QLabel*>()) texts << label->text();
    const QString all = texts.join(u'\n');
    for (const QString& label : labels) QVERIFY2(all.contains(label), qPrintable(label + u'\n' + all));
}

void TestLanguages::keysAreOfOneThingEach_data() {
    QTest::addColumn<QString>("code");
    for (const char* code : {"de", "sv"}) QTest::newRow(code) << QString::fromLatin1(code);
}

void TestLanguages::keysAreOfOneThingEach() {
    QFETCH(QString, code);
    const Speaking speaking(code);
    openIn(QStringLiteral("t38_medium_rock"));
    QStringList found;
    for (const QMenu* menu : window().menuBar()->findChildren<QMenu*>()) found += doubleKeys(*menu);
    for (const QMenu* menu : window().findChildren<QMenu*>())
        if (!menu->title().isEmpty()) found += doubleKeys(*menu);
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

void TestLanguages::whatIsChosenCountsTheNextTime() {
    start();
    auto& menu = part<LanguageMenu>(window());
    QStringList names;
    QAction* swedish = nullptr;
    for (QAction* action : menu.actions()) {
        if (action->isSeparator()) continue;
        names << action->text();
        QCOMPARE(action->isChecked(), action->text() == QStringLiteral("&System"));
        if (action->text() == QStringLiteral("Svenska")) swedish = action;
    }
    QCOMPARE(names, (QStringList{"&System", "English", "Deutsch", "Svenska"}));
    swedish->trigger();
    QCOMPARE(chosenLanguage(), findLanguage("sv"));
    QCOMPARE(m_answers.restartAsked.size(), 1);
    QVERIFY(m_answers.restartAsked.first().contains(QStringLiteral("Svenska")));
    swedish->trigger();
    QCOMPARE(m_answers.restartAsked.size(), 1);  // it is chosen already
    QVERIFY(!window().wantsRestart());
}

// The scenario, the numbers of every page, all that a run leaves in a folder, and the report.
QMap<QString, QByteArray> TestLanguages::writeFiles(const QString& folder) {
    auto& exports = part<ExportMenu>(window());
    visitPages([&](int page) {
        // studies take their time, and write as pages of one blow do
        if (part<PageTabs>(window()).page(page).activity()) return;
        const QList<PageExport> offered = part<PageTabs>(window()).page(page).exports();
        for (qsizetype i = 0; i < offered.size(); ++i) {
            const bool isHindered = offered[i].obstacle && !offered[i].obstacle().isEmpty();
            if (offered[i].picture || isHindered) continue;
            m_answers.exportTo = QStringLiteral("%1/%2_%3.csv").arg(folder).arg(page).arg(i);
            exports.save(offered[i]);
            settle();
        }
    });
    m_answers.folder = folder + QStringLiteral("/everything");
    for (QAction* action : exports.actions())
        if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_E)) action->trigger();
    m_answers.exportTo = folder + QStringLiteral("/report.html");
    window().findChild<QAction*>(QStringLiteral("report"))->trigger();
    [&] { QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(m_answers.exportTo), 120000); }();
    [&] {
        const QString problem = window().document().save(folder + QStringLiteral("/scenario.yaml"));
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }();
    QMap<QString, QByteArray> files;
    QDirIterator each(folder, QDir::Files, QDirIterator::Subdirectories);
    while (each.hasNext()) {
        const QString path = each.next();
        // how long the solver took is another number each time
        static const QRegularExpression runTime(QStringLiteral("\"run_time\": [^,\\n]*"));
        QByteArray bytes = read(path);
        if (path.endsWith(QLatin1String(".json"))) bytes = QString::fromUtf8(bytes).remove(runTime).toUtf8();
        files[QDir(folder).relativeFilePath(path)] = bytes;
    }
    return files;
}

void TestLanguages::filesAreTheSame() {
    qputenv("SOURCE_DATE_EPOCH", "1000000000");  // PDF files have the time in them
    for (const char* example : examples) {
        QMap<QString, QByteArray> english;
        for (const char* code : {"en", "de", "sv"}) {
            const Speaking speaking(QString::fromLatin1(code));
            openIn(QString::fromLatin1(example));
            const QTemporaryDir folder;
            const QMap<QString, QByteArray> now = writeFiles(folder.path());
            QVERIFY2(m_answers.told.isEmpty(), qPrintable(m_answers.told.join(u'\n')));
            if (english.isEmpty()) english = now;
            QVERIFY2(english.size() >= 10, qPrintable(QString::number(english.size())));
            QCOMPARE(now.keys(), english.keys());
            for (const QString& name : now.keys())
                QVERIFY2(now[name] == english[name], qPrintable(example + QStringLiteral(" ") + name + u'\n' +
                                                                QString::fromUtf8(now[name].left(400))));
        }
    }
}

/// Qt names the keys of menus by a catalogue of its own, which need not be installed; texts name them, too.
void TestLanguages::keysHaveOneName() {
    const QKeySequence find(Qt::CTRL | Qt::Key_F);
    for (const Language& language : languages) {
        const Speaking speaking(fromView(language.code));
        const QString name = find.toString(QKeySequence::NativeText);
        QCOMPARE(name, language.code == "de" ? QStringLiteral("Strg+F") : QStringLiteral("Ctrl+F"));
        QCOMPARE(QKeySequence(QStringLiteral("Ctrl+F")), find);  // as the sources have them
        const QString search =
            QCoreApplication::translate("drillwave::HelpWindow", "Search all chapters (Ctrl+F)");
        QVERIFY2(search.contains(name), qPrintable(search));
    }
}

QTEST_MAIN(TestLanguages)
#include "tst_languages.moc"
