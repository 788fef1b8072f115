// SPDX-License-Identifier: GPL-3.0-or-later
// The tabs of the pages: their groups, and how one gets from one to the next.
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/study_status.h"
#include "ui/pages/compare/compare_page.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/string/string_page.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/result_panel.h"
#include "ui/text/settings.h"
#include "ui/window/page_notices.h"
#include "ui/window/page_tabs.h"
#include "ui/window/study_menu.h"
#include "ui/window/tab_strip.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

class EmptyPage : public Page {
  public:
    explicit EmptyPage(const QString& title) : m_title(title) {}
    QString title() const override { return m_title; }
    PreparePage prepare() const override { return {}; }
    void setResult(const SolvedBlowPtr& /*blow*/) override {}
    void fit() override {}
    QList<PageExport> exports() const override { return {}; }
    void setCurrent(bool /*current*/) override {}

  private:
    QString m_title;
};

QStringList texts(const QTabBar& bar) {
    QStringList all;
    for (int i = 0; i < bar.count(); ++i) all << bar.tabText(i);
    return all;
}

}  // namespace

class TestPageTabs : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void pagesStandInTheirGroups();
    void captionsAreNeverChosen();
    void namesOfPagesGoBeforeCaptions();
    void lettersShrinkWhereThatBringsAllTabsIntoView();
    void theChosenTabIsInViewInANarrowWindow();
    void tabsAreAboveTheDocksOverTheWholeWidth();
    void aPageThatFitsIsNotScrolled();
    void theKeysGoRoundThePages();
    void f6GoesRoundTheAreas();
    void onlyTheStudyOfThePageOnShowIsFollowed();
    void theStudyMenuHasTheStudies();
    void noPageIsChosenThatShowsNothingOfAString();
    void theGapOfAStringIsVariedByOneClick();
    void aPageThatIsAbsentSaysWhereItsAnswerIs();
    void thrustIsAbsentWithoutUnits();
    void aClickOnTheGreyedTabMakesAString();
    void aKeyHasOneMeaning();
    void aPageIsFoundByItsFormerName();

  private:
    void press(QWidget& window, Qt::Key key, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(window.windowHandle(), key, modifiers);
    }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
};

void TestPageTabs::initTestCase() {
    QLocale::setDefault(QLocale::c());
    keepSettingsIn(m_folder.path());
}

void TestPageTabs::aClickOnTheGreyedTabMakesAString() {
    const auto made = newWindow(m_answers);
    MainWindow& window = *made;
    window.resize(1440, 900);
    window.show();
    const PageTabs& pages = part<PageTabs>(window);
    auto* page = window.findChild<StringPage*>();
    TabStrip& strip = *pages.strip();
    const int tab = strip.indexOf(page);
    QVERIFY(!strip.isTabEnabled(tab));
    QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.tabRect(tab).center());
    QVERIFY(isString(window.document().scenario()));
    QCOMPARE(pages.currentWidget(), static_cast<QWidget*>(page));
    QVERIFY(window.document().scenario().title.ends_with(", as a drill string"));
    QVERIFY(!window.document().text().startsWith("#"));
    window.document().undoStack().undo();
    QVERIFY(!isString(window.document().scenario()));
}

void TestPageTabs::aKeyHasOneMeaning() {
    const auto made = newWindow(m_answers);
    const MainWindow& window = *made;
    QHash<QKeySequence, QStringList> names;
    for (const QAction* action : window.findChildren<QAction*>())
        for (const QKeySequence& keys : action->shortcuts())
            if (!action->text().isEmpty() && keys[0].keyboardModifiers() != Qt::NoModifier)
                names[keys] << action->text();
    for (auto key = names.cbegin(); key != names.cend(); ++key) {
        QStringList different = *key;
        different.removeDuplicates();
        QVERIFY2(different.size() == 1, qPrintable(key.key().toString() + ": " + different.join(", ")));
    }
}

// Kept by a version in which the page Curve had another name.
void TestPageTabs::aPageIsFoundByItsFormerName() {
    Settings().setValue(QStringLiteral("window/page"), QStringLiteral("drillwave::StiffnessPage"));
    const auto window = newWindow(m_answers);
    QCOMPARE(part<PageTabs>(*window).currentWidget(), static_cast<QWidget*>(&part<CurvePage>(*window)));
    Settings().remove(QStringLiteral("window/page"));
}

void TestPageTabs::pagesStandInTheirGroups() {
    QWidget window;
    PageTabs pages(&window);
    // In any order.
    pages.add(new EmptyPage("Gap"), PageGroup::studies);
    pages.add(new EmptyPage("Blow"), PageGroup::thisBlow);
    pages.add(new EmptyPage("Map"), PageGroup::studies);
    pages.add(new EmptyPage("Rock"), PageGroup::thisBlow);
    QCOMPARE(texts(*pages.strip()), QStringList({"THIS BLOW", "Blow", "Rock", "STUDIES", "Gap", "Map"}));
    QCOMPARE(pages.count(), 4);
    QCOMPARE(pages.page(1).title(), QString("Rock"));
    QCOMPARE(pages.page(2).title(), QString("Gap"));
    for (int i = 0; i < pages.count(); ++i) {
        pages.setCurrentIndex(i);
        QCOMPARE(pages.strip()->tabText(pages.strip()->currentIndex()), pages.page(i).title());
        QCOMPARE(&pages.current(), &pages.page(i));
    }
    pages.strip()->setCurrentIndex(1);
    QCOMPARE(pages.current().title(), QString("Blow"));
}

void TestPageTabs::captionsAreNeverChosen() {
    QWidget window;
    PageTabs pages(&window);
    pages.add(new EmptyPage("Blow"), PageGroup::thisBlow);
    pages.add(new EmptyPage("Gap"), PageGroup::studies);
    TabStrip& strip = *pages.strip();
    window.show();
    for (int i = 0; i < strip.count(); ++i) {
        QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.tabRect(i).center());
        QVERIFY(strip.pageAt(strip.currentIndex()));
        QCOMPARE(strip.pageAt(strip.currentIndex()), pages.currentWidget());
    }
    strip.setFocus();
    for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Left, Qt::Key_Left, Qt::Key_Home}) {
        QTest::keyClick(&strip, key);
        QVERIFY(strip.pageAt(strip.currentIndex()));
    }
    strip.choose(1);
    strip.choose(1);
    QVERIFY(strip.pageAt(strip.currentIndex()));
}

void TestPageTabs::namesOfPagesGoBeforeCaptions() {
    QWidget window;
    PageTabs pages(&window);
    for (const char* title : {"Blow", "Rock"}) pages.add(new EmptyPage(title), PageGroup::thisBlow);
    for (const char* title : {"COR–gap", "Map"}) pages.add(new EmptyPage(title), PageGroup::studies);
    TabStrip& strip = *pages.strip();
    strip.setParent(nullptr);
    strip.resize(1000, strip.sizeHint().height());
    strip.show();
    QList<int> widths;
    for (int i = 0; i < strip.count(); ++i) widths << strip.tabRect(i).width();
    strip.resize(strip.tabRect(strip.count() - 1).right() - 50, strip.height());
    for (int i = 0; i < strip.count(); ++i)
        if (strip.pageAt(i))
            QCOMPARE(strip.tabRect(i).width(), widths[i]);
        else
            QVERIFY(strip.tabRect(i).width() < widths[i]);
    QVERIFY(strip.tabRect(strip.count() - 1).right() < strip.width());
    strip.resize(1000, strip.height());
    for (int i = 0; i < strip.count(); ++i) QCOMPARE(strip.tabRect(i).width(), widths[i]);
    strip.setParent(&window);
}

void TestPageTabs::lettersShrinkWhereThatBringsAllTabsIntoView() {
    QWidget window;
    TabStrip strip(&window);
    QList<EmptyPage*> pages;
    for (int i = 0; i < 6; ++i) {
        pages << new EmptyPage(QStringLiteral("a page with a long name"));
        pages.last()->setParent(&window);
        strip.insertPage(i, pages.last(), pages.last()->title());
    }
    window.resize(2000, 100);
    window.show();
    const auto wanted = [&] { return strip.tabRect(strip.count() - 1).right() + 1; };
    strip.resize(2000, 30);
    const double usual = strip.font().pointSizeF();
    const int room = wanted();
    strip.resize(room - 10, 30);
    QVERIFY(strip.font().pointSizeF() < usual);
    QVERIFY(wanted() <= strip.width());
    // Where that is not enough the tabs scroll, and a wide row has its usual letters again.
    for (const int width : {room / 2, room}) {
        strip.resize(width, 30);
        QCOMPARE(strip.font().pointSizeF(), usual);
    }
}

void TestPageTabs::theChosenTabIsInViewInANarrowWindow() {
    TabStrip strip;
    QList<QWidget*> pages;
    for (int i = 0; i < 10; ++i) {
        pages.append(new QWidget(&strip));
        pages.last()->hide();
        strip.insertPage(i, pages.last(), QStringLiteral("a page with a name %1").arg(i));
    }
    strip.resize(400, strip.sizeHint().height());
    strip.show();
    for (int i = 0; i < 10; ++i) {
        strip.setCurrentIndex(i);
        const QRect tab = strip.tabRect(i);
        QVERIFY2(tab.left() >= 0 && tab.right() <= 400, qPrintable(strip.tabText(i)));
    }
    strip.setCurrentIndex(9);
    strip.resize(300, strip.height());
    QVERIFY(strip.tabRect(9).right() <= 300 && strip.tabRect(9).left() >= 0);
}

void TestPageTabs::tabsAreAboveTheDocksOverTheWholeWidth() {
    const auto window = newWindow(m_answers);
    window->resize(1440, 900);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    const TabStrip& strip = *part<PageTabs>(*window).strip();
    const int bottom = strip.mapTo(window.get(), QPoint(0, strip.height())).y();
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>()) QTRY_VERIFY(dock->y() >= bottom - 1);
    QVERIFY(strip.mapTo(window.get(), QPoint()).x() < 20);
    QVERIFY(strip.width() > 1200);
    QCOMPARE(strip.tabText(0), QString("THIS BLOW"));
}

// The height of a page is its own, not that of the highest page.
void TestPageTabs::aPageThatFitsIsNotScrolled() {
    const auto window = newWindow(m_answers);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    auto& pages = part<PageTabs>(*window);
    const QScrollBar& bar = *part<PageScroll>(*window).verticalScrollBar();
    for (const QSize size : {QSize(1280, 800), QSize(800, 500)}) {
        window->resize(size);
        for (const char* title : {"Rock", "Feed"}) {
            for (int i = 0; i < pages.count(); ++i)
                if (pages.page(i).title() == QLatin1String(title)) pages.setCurrentIndex(i);
            QCOMPARE(pages.current().title(), QLatin1String(title));
            const bool hasTable = pages.current().findChild<QWidget*>(QStringLiteral("answerTable"));
            if (size.height() > 500 || !hasTable) QTRY_COMPARE(bar.maximum(), 0);
            const QWidget& plot = *pages.current().findChild<PlotWidget*>();
            QTRY_VERIFY(plot.mapTo(&pages.current(), QPoint(0, plot.height())).y() <=
                        part<PageScroll>(*window).viewport()->height());
        }
    }
}

void TestPageTabs::theKeysGoRoundThePages() {
    const auto window = newWindow(m_answers);
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    auto& pages = part<PageTabs>(*window);
    pages.setCurrentIndex(0);
    for (int i = 1; i <= pages.count(); ++i) {
        if (!pages.isOffered(i % pages.count())) continue;
        press(*window, Qt::Key_Tab, Qt::ControlModifier);
        QCOMPARE(pages.currentIndex(), i % pages.count());
    }
    press(*window, Qt::Key_Tab, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(pages.currentIndex(), pages.count() - 1);
}

void TestPageTabs::f6GoesRoundTheAreas() {
    const auto window = newWindow(m_answers);
    window->resize(1440, 900);
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    const QList<QWidget*> areas{&part<ScenarioPanel>(*window), &part<PageTabs>(*window),
                                &part<ResultPanel>(*window)};
    const auto isIn = [](const QWidget* area) {
        const QWidget* focus = QApplication::focusWidget();
        return focus && (area == focus || area->isAncestorOf(focus));
    };
    auto* field = areas[0]->findChild<QWidget*>("bit_rock.gap");
    field->setFocus();
    for (const int area : {1, 2, 0, 1}) {
        press(*window, Qt::Key_F6, {});
        QVERIFY2(isIn(areas[area]), qPrintable(QString::number(area)));
    }
    press(*window, Qt::Key_F6, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget() == field || field->isAncestorOf(QApplication::focusWidget()), true);
    // An area that is closed is passed over; a hidden one is raised.
    window->findChild<QDockWidget*>("result")->hide();
    press(*window, Qt::Key_F6, Qt::ShiftModifier);
    QVERIFY(isIn(areas[1]));
    window->findChild<QDockWidget*>("result")->show();
    window->resize(1000, 650);
    QTRY_VERIFY(!window->tabifiedDockWidgets(window->findChild<QDockWidget*>("result")).isEmpty());
    press(*window, Qt::Key_F6, {});
    QVERIFY(isIn(areas[2]));
    QTRY_VERIFY(areas[2]->isVisible());
}

void TestPageTabs::onlyTheStudyOfThePageOnShowIsFollowed() {
    const auto window = newWindow(m_answers);
    part<StudyStatus>(*window).setPatience(std::chrono::milliseconds(0));
    window->resize(1440, 900);  // room for the name
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    auto& pages = part<PageTabs>(*window);
    for (int i = 0; i < pages.count(); ++i) {
        pages.setCurrentIndex(i);
        QCoreApplication::processEvents();
        for (int other = 0; other < pages.count(); ++other)
            if (const StudyActivity* activity = pages.page(other).activity(); activity && other != i)
                QVERIFY2(activity->state() != StudyState::running, qPrintable(pages.page(other).title()));
        const QString text = part<StudyStatus>(*window).text();
        QVERIFY2(text.isEmpty() || text.startsWith(pages.page(i).title()), qPrintable(text));
    }
}

void TestPageTabs::theStudyMenuHasTheStudies() {
    const auto window = newWindow(m_answers);
    window->show();
    auto& pages = part<PageTabs>(*window);
    auto& menu = part<StudyMenu>(*window);
    pages.setCurrentIndex(0);
    emit menu.aboutToShow();
    QVERIFY(!menu.actions().last()->isEnabled());
    for (QAction* action : menu.actions()) {
        if (action->isSeparator()) break;
        action->trigger();
        QCOMPARE(pages.current().title(), action->text());
    }
    emit menu.aboutToShow();
    QAction* copy = menu.actions().at(menu.actions().size() - 2);
    QVERIFY(copy->isEnabled());
    QGuiApplication::clipboard()->clear();
    copy->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("drillwave ")));
}

void TestPageTabs::noPageIsChosenThatShowsNothingOfAString() {
    const auto window = newWindow(m_answers);
    window->show();
    auto& pages = part<PageTabs>(*window);
    const Example& example = *findExample("t38_string");
    auto& compare = part<ComparePage>(*window);  // stays on show when the string comes
    pages.setCurrentWidget(&compare);
    QCOMPARE(window->document().startFrom(example.text, QStringLiteral("t38")), QString());
    QCOMPARE(pages.currentWidget(), &compare);
    QStringList enabled;
    emit part<StudyMenu>(*window).aboutToShow();
    for (const QAction* action : part<StudyMenu>(*window).actions()) {
        if (action->isSeparator()) break;
        if (action->isEnabled()) enabled << action->text();
    }
    QCOMPARE(enabled,
             (QStringList{QStringLiteral("Identify"), QStringLiteral("Efficiency–stiffness"),
                          QStringLiteral("COR–gap"), QStringLiteral("Map"), QStringLiteral("Feed"),
                          QStringLiteral("Drilling"), QStringLiteral("Design"), QStringLiteral("Accuracy")}));
    // A place of the rod's blow, which is on show until the string is solved.
    emit part<ResultPanel>(*window).placeChosen(0.5, 1);
    QCOMPARE(pages.currentWidget(), &compare);
}

void TestPageTabs::theGapOfAStringIsVariedByOneClick() {
    const auto window = newWindow(m_answers);
    window->show();
    auto& pages = part<PageTabs>(*window);
    const Example& example = *findExample("t38_string");
    QCOMPARE(window->document().startFrom(example.text, QStringLiteral("t38")), QString());
    pages.choose(pages.indexOf(&studyPage(*window, "gap")));
    QTest::mouseClick(window->findChild<QPushButton*>("goThere"), Qt::LeftButton);
    auto& stiffness = part<CurvePage>(*window);
    QCOMPARE(pages.currentWidget(), &stiffness);
    const StudyRange& range = stiffness.axis()->range();
    QCOMPARE(range.parameter->key, std::string_view("bit_rock.gap"));
    QCOMPARE(range.start, 0.0);
    QCOMPARE(range.stop, 9e-3);  // 4 v0 t0 = 8.5 mm
    QCOMPARE(stiffness.study().started(), 1);
    QTRY_COMPARE_WITH_TIMEOUT(stiffness.activity()->state(), StudyState::finished, 60'000);
    QTRY_VERIFY(stiffness.figure() && stiffness.figureFrame().graph()->dataCount() > 100);
}

// By the menu, by the scenario that takes its place, and by the keys, which pass it over.
void TestPageTabs::aPageThatIsAbsentSaysWhereItsAnswerIs() {
    const auto window = newWindow(m_answers);
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    auto& pages = part<PageTabs>(*window);
    auto& gap = studyPage(*window, "gap");
    const auto& notice = part<ElsewhereNotice>(*window);
    const int tab = pages.strip()->indexOf(&gap);
    pages.setCurrentWidget(&gap);
    QVERIFY(pages.strip()->isTabVisible(tab));
    QVERIFY(notice.isHidden());
    const Example& example = *findExample("t38_string");
    QCOMPARE(window->document().startFrom(example.text, QStringLiteral("t38")), QString());
    QVERIFY(pages.currentWidget() != &gap);
    QVERIFY(!pages.strip()->isTabVisible(tab));
    QVERIFY(notice.isVisible());
    QCOMPARE(notice.text(), gap.elsewhere());
    QVERIFY(!notice.text().contains(u'\n'));
    for (int i = 0; i < pages.count(); ++i) {
        press(*window, Qt::Key_Tab, Qt::ControlModifier);
        QVERIFY(pages.currentWidget() != &gap);
    }
    QVERIFY(notice.isHidden());  // another page is on show
    for (QAction* action : part<StudyMenu>(*window).actions())
        if (action->text() == gap.title()) action->trigger();
    QVERIFY(notice.isVisible());
    window->document().startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    QVERIFY(notice.isHidden());
    QVERIFY(pages.strip()->isTabVisible(tab));
}

// No page has the answer, so that nothing is offered that leads there; what was on show comes back.
void TestPageTabs::thrustIsAbsentWithoutUnits() {
    const auto window = newWindow(m_answers);
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    auto& pages = part<PageTabs>(*window);
    auto& thrust = studyPage(*window, "thrust");
    const auto& notice = part<ElsewhereNotice>(*window);
    const auto* goThere = notice.findChild<QPushButton*>(QStringLiteral("goThere"));
    const int tab = pages.strip()->indexOf(&thrust);
    pages.setCurrentWidget(&thrust);
    const int studies = thrust.studies();
    window->document().startFrom(findExample("paper_fig4b")->text, QStringLiteral("fig4b"));
    QVERIFY(pages.currentWidget() != &thrust);
    QVERIFY(!pages.strip()->isTabVisible(tab));
    QVERIFY(notice.isVisible());
    QCOMPARE(notice.text(), thrust.elsewhere());
    QVERIFY(!goThere->isVisible());
    QCOMPARE(thrust.studies(), studies);
    window->document().startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    QVERIFY(notice.isHidden());
    QVERIFY(pages.strip()->isTabVisible(tab));
    // A page that leads to its answer offers that again.
    for (QAction* action : part<StudyMenu>(*window).actions())
        if (action->text() == studyPage(*window, "gap").title()) action->trigger();
    QVERIFY(goThere->isVisible());
}

QTEST_MAIN(TestPageTabs)
#include "tst_page_tabs.moc"
