// SPDX-License-Identifier: GPL-3.0-or-later
// Files come into the window by menus and by drops, and what is unsaved is asked about every time.
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/text/settings.h"
#include "ui/window/document_notices.h"
#include "ui/window/file_menu.h"
#include "ui/window/page_tabs.h"
#include "ui/window/units_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

QByteArray exampleBytes() {
    return QByteArray(defaultExample().text.data(), qsizetype(defaultExample().text.size()));
}

QAction* actionOf(const QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions())
        if (QString(action->text()).remove(QLatin1Char('&')) == text) return action;
    return nullptr;
}

// The middle of a widget, as a drag from another program delivers it.
bool drop(QWidget& widget, const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(widget.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &enter);
    QDropEvent event(widget.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    event.ignore();
    QCoreApplication::sendEvent(&widget, &event);
    return enter.isAccepted() && event.isAccepted();
}

}  // namespace

class TestFiles : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup();
    void openingAsksForTheFileFirstAndThenAboutTheChanges();
    void everyWayToAnotherScenarioAsksAboutChanges();
    void aDroppedScenarioIsOpened();
    void aFileDroppedOntoAFieldIsNotTypedIntoIt();
    void aDroppedResultIsOpenedWithoutAPath();
    void aDroppedTableBecomesTheHammerBlow();
    void whatCannotBeTakenIsToldOnce();
    void everyExampleExplainsItself();
    void theExplanationCanBeDismissedAndComesBackByTheMenu();
    void theFirstExplanationStaysAwayOnceDismissed();
    void savingAsAddsTheSuffix();
    void recentFilesCanBeClearedAndMissingOnesTakenOff();
    void pageUnitsAndPlaceAreRemembered();
    void aWindowOffTheScreenComesBack();
    void aResetForgetsChoicesButNotFiles();

  private:
    MainWindow& window() { return *m_window; }
    void makeWindow();
    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString put(const char* name, const QByteArray& bytes) const;
    void edit(double metres) { window().document().assign(*findParameter("rod.length"), metres, 1); }
    double length() const { return m_window->document().scenario().rod.length; }
    QMenu* menu(const QString& title) const;
    QStringList recentFiles() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

void TestFiles::init() {
    QLocale::setDefault(QLocale::c());
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(path("settings"));
    m_answers = {};
    makeWindow();
}

void TestFiles::cleanup() {
    m_window.reset();
}

void TestFiles::makeWindow() {
    m_window.reset();
    m_window = newWindow(m_answers);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

QString TestFiles::put(const char* name, const QByteArray& bytes) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write");
    return path(name);
}

QMenu* TestFiles::menu(const QString& title) const {
    for (QMenu* menu : part<FileMenu>(*m_window).findChildren<QMenu*>())
        if (menu->title().remove(QLatin1Char('&')) == title) return menu;
    return nullptr;
}

QStringList TestFiles::recentFiles() const {
    QStringList names;
    for (const QAction* action : menu(QStringLiteral("Open Recent"))->actions())
        if (action->text().contains(QLatin1Char('.'))) names.append(action->text());
    return names;
}

void TestFiles::openingAsksForTheFileFirstAndThenAboutTheChanges() {
    QAction* open = actionOf(part<FileMenu>(window()), QStringLiteral("Open…"));
    edit(5);
    open->trigger();  // no file was chosen, so there is nothing to ask
    QCOMPARE(m_answers.unsavedAsked, 0);
    m_answers.open = put("other.yaml", exampleBytes().replace("3.66 m", "7 m"));
    open->trigger();
    QCOMPARE(m_answers.unsavedAsked, 1);
    QCOMPARE(length(), 5.0);
    m_answers.unsaved = Questions::Unsaved::save;
    m_answers.save = path("mine.yaml");
    open->trigger();
    QCOMPARE(length(), 7.0);
    QVERIFY(QFile::exists(path("mine.yaml")));
}

void TestFiles::everyWayToAnotherScenarioAsksAboutChanges() {
    const QString other = put("other.yaml", exampleBytes());
    QVERIFY(window().openFile(other));
    edit(5);
    m_answers.unsaved = Questions::Unsaved::cancel;
    m_answers.open = other;
    int asked = 0;
    const auto refused = [&] { return m_answers.unsavedAsked == ++asked && length() == 5; };
    actionOf(part<FileMenu>(window()), QStringLiteral("New"))->trigger();
    QVERIFY(refused());
    actionOf(part<FileMenu>(window()), QStringLiteral("Open…"))->trigger();
    QVERIFY(refused());
    menu(QStringLiteral("Examples"))->actions().first()->trigger();
    QVERIFY(refused());
    menu(QStringLiteral("Open Recent"))->actions().first()->trigger();
    QVERIFY(refused());
    QVERIFY(drop(window(), {QUrl::fromLocalFile(other)}));
    QTRY_VERIFY(m_answers.unsavedAsked == asked + 1);
    QVERIFY(refused());
    QVERIFY(!window().close());
    QVERIFY(refused());
}

void TestFiles::aDroppedScenarioIsOpened() {
    const QString file = put("dropped.yaml", exampleBytes().replace("3.66 m", "7 m"));
    QVERIFY(drop(window(), {QUrl::fromLocalFile(file)}));
    QTRY_COMPARE(length(), 7.0);
    QCOMPARE(window().document().path(), file);
    QCOMPARE(m_answers.told, QStringList());
}

// A line edit takes the names of files for text.
void TestFiles::aFileDroppedOntoAFieldIsNotTypedIntoIt() {
    const QString file = put("dropped.yaml", exampleBytes().replace("3.66 m", "7 m"));
    auto* field = window().findChild<QLineEdit*>(QStringLiteral("title"));
    QVERIFY(field);
    QVERIFY(drop(*field, {QUrl::fromLocalFile(file)}));
    QTRY_COMPARE(length(), 7.0);
    QVERIFY(!field->text().contains(QStringLiteral("dropped")));
}

void TestFiles::aDroppedResultIsOpenedWithoutAPath() {
    QByteArray header;
    for (const QByteArray& line : exampleBytes().replace("3.66 m", "7 m").split('\n'))
        header += "# " + line + '\n';
    const QByteArray result = header + "kind,time\ncontact,10\n";
    const QString file = put("events.csv", result);
    QVERIFY(drop(window(), {QUrl::fromLocalFile(file)}));
    QTRY_COMPARE(length(), 7.0);
    QCOMPARE(window().document().path(), QString());
    m_answers.save = path("events.yaml");
    edit(8);
    QVERIFY(part<FileMenu>(window()).save());
    QFile after(file);
    QVERIFY(after.open(QIODevice::ReadOnly));
    QCOMPARE(after.readAll(), result);
}

void TestFiles::aDroppedTableBecomesTheHammerBlow() {
    const QString table = put("blow.csv", "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    QVERIFY(drop(window(), {QUrl::fromLocalFile(table)}));
    QTRY_COMPARE(window().document().scenario().pulse.shape, PulseShape::table);
    QTRY_COMPARE(window().shown()->request.scenario, window().document().scenario());
    QCOMPARE(window().shown()->fault, QString());
    window().document().undoStack().undo();
    QCOMPARE(window().document().text(), exampleBytes());
}

void TestFiles::whatCannotBeTakenIsToldOnce() {
    const QUrl first = QUrl::fromLocalFile(put("a.yaml", exampleBytes()));
    const QUrl second = QUrl::fromLocalFile(put("b.yaml", exampleBytes()));
    const QUrl picture = QUrl::fromLocalFile(put("c.png", "picture"));
    const QList<QList<QUrl>> refused{{first, second}, {picture}, {QUrl::fromLocalFile(m_folder->path())}};
    int told = 0;
    for (const QList<QUrl>& urls : refused) {
        QVERIFY(drop(window(), urls));
        ++told;
        QTRY_COMPARE(m_answers.told.size(), told);
        QCOMPARE(window().document().text(), exampleBytes());
    }
    QVERIFY(!drop(window(), {QUrl(QStringLiteral("https://example.org/a.yaml"))}));
    QCOMPARE(m_answers.told.size(), told);
}

void TestFiles::everyExampleExplainsItself() {
    constexpr qsizetype figures = 2;  // their menu, and the line above it
    QCOMPARE(menu(QStringLiteral("Examples"))->actions().size(),
             qsizetype(builtInExamples().size()) + figures);
    for (size_t i = 0; i < builtInExamples().size(); ++i) {
        menu(QStringLiteral("Examples"))->actions()[qsizetype(i)]->trigger();
        QVERIFY(part<ExampleNote>(window()).isVisible());
        QCOMPARE(part<ExampleNote>(window()).text(),
                 QString::fromStdString(builtInExamples()[i].explanation));
        QVERIFY(
            part<ExampleNote>(window()).findChild<QLabel*>(QStringLiteral("text"))->textInteractionFlags() &
            Qt::TextSelectableByMouse);
    }
    QVERIFY(window().openFile(put("other.yaml", exampleBytes())));
    QVERIFY(!part<ExampleNote>(window()).isVisible());
    QVERIFY(!part<ExampleNote>(window()).action()->isEnabled());
}

void TestFiles::theExplanationCanBeDismissedAndComesBackByTheMenu() {
    menu(QStringLiteral("Examples"))->actions().first()->trigger();
    part<ExampleNote>(window()).findChild<QToolButton*>(QStringLiteral("dismiss"))->click();
    QVERIFY(!part<ExampleNote>(window()).isVisible());
    part<ExampleNote>(window()).action()->trigger();
    QVERIFY(part<ExampleNote>(window()).isVisible());
    part<ExampleNote>(window()).action()->trigger();
    QVERIFY(!part<ExampleNote>(window()).isVisible());
}

void TestFiles::theFirstExplanationStaysAwayOnceDismissed() {
    QVERIFY(part<ExampleNote>(window()).isVisible());
    part<ExampleNote>(window()).findChild<QToolButton*>(QStringLiteral("dismiss"))->click();
    makeWindow();
    QVERIFY(!part<ExampleNote>(window()).isVisible());
    QVERIFY(part<ExampleNote>(window()).action()->isEnabled());
    menu(QStringLiteral("Examples"))->actions().first()->trigger();
    QVERIFY(part<ExampleNote>(window()).isVisible());
}

void TestFiles::savingAsAddsTheSuffix() {
    m_answers.save = path("T38.v2");
    QVERIFY(part<FileMenu>(window()).saveAs());
    QCOMPARE(window().document().path(), path("T38.v2.yaml"));
    QCOMPARE(m_answers.confirmed, QStringList());
    // The dialog has asked about another name.
    QVERIFY(!part<FileMenu>(window()).saveAs());
    QCOMPARE(m_answers.confirmed.size(), 1);
    m_answers.save = path("plain.YML");
    QVERIFY(part<FileMenu>(window()).saveAs());
    QCOMPARE(window().document().path(), path("plain.YML"));
}

void TestFiles::recentFilesCanBeClearedAndMissingOnesTakenOff() {
    const QString first = put("a.yaml", exampleBytes());
    const QString second = put("b & c.yaml", exampleBytes());
    QVERIFY(window().openFile(first));
    QVERIFY(window().openFile(second));
    QCOMPARE(recentFiles().size(), 2);
    QVERIFY(recentFiles().first().endsWith(QStringLiteral("b && c.yaml")));
    QVERIFY(QFile::remove(first));
    menu(QStringLiteral("Open Recent"))->actions()[1]->trigger();
    QCOMPARE(m_answers.confirmed.size(), 1);
    QCOMPARE(recentFiles().size(), 2);
    m_answers.confirm = true;
    menu(QStringLiteral("Open Recent"))->actions()[1]->trigger();
    QCOMPARE(recentFiles().size(), 1);
    actionOf(*menu(QStringLiteral("Open Recent")), QStringLiteral("Clear list"))->trigger();
    QCOMPARE(recentFiles().size(), 0);
    QVERIFY(QFile::exists(second));
}

void TestFiles::pageUnitsAndPlaceAreRemembered() {
    auto* pages = window().findChild<PageTabs*>();
    const int last = pages->count() - 1;
    pages->setCurrentIndex(last);
    part<UnitsChoice>(window()).choose(UnitSystem::dimensionless);
    window().resize(1100, 700);
    const int height = window().height();
    QVERIFY(window().close());
    makeWindow();
    QCOMPARE(window().findChild<PageTabs*>()->currentIndex(), last);
    QCOMPARE(window().shown()->request.units, UnitSystem::dimensionless);
    QCOMPARE(window().height(), height);  // the screen of the test is narrower than the window
}

void TestFiles::aWindowOffTheScreenComesBack() {
    window().move(-5000, 9000);
    QVERIFY(window().close());
    makeWindow();
    const QRect shown = window().screen()->availableGeometry() & window().frameGeometry();
    QVERIFY(shown.width() >= 80 && shown.height() >= 80);
}

void TestFiles::aResetForgetsChoicesButNotFiles() {
    QVERIFY(window().openFile(put("a.yaml", exampleBytes())));
    part<UnitsChoice>(window()).choose(UnitSystem::dimensionless);
    QVERIFY(window().close());
    const QStringList presets{QStringLiteral("mine.yaml")};
    Settings().setValue(presetFilesKey, presets);
    resetSettings();
    QCOMPARE(Settings().value(presetFilesKey).toStringList(), presets);
    makeWindow();
    QCOMPARE(window().shown()->request.units, UnitSystem::si);
    QCOMPARE(recentFiles().size(), 1);
}

QTEST_MAIN(TestFiles)
#include "tst_files.moc"
