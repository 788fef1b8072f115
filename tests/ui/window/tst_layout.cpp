// SPDX-License-Identifier: GPL-3.0-or-later
// Every page at every size, light and dark: nothing is cut off, covered, nameless or faint.
#include <QAction>
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "core/file/examples.h"
#include "tests/support/themes.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "tests/ui/window/layout_check.h"
#include "ui/job/solve_job.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr int widestSmallWindow = 1100;

// By its menu, so that its explanation is on show as well.
void openExample(MainWindow& window, const QString& name) {
    const QString title = QString::fromStdString(findExample(name.toStdString())->title);
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text() == title) return action->trigger();
    QFAIL(qPrintable(title));
}

}  // namespace

class TestLayout : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void everythingCanBeReadAndReached_data();
    void everythingCanBeReadAndReached();
    void cleanup();

  private:
    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
};

void TestLayout::initTestCase() {
    keepSettingsIn(m_folder.path());
    QLocale::setDefault(QLocale::c());
}

void TestLayout::cleanup() {
    QApplication::setPalette(QPalette());
    Settings().clear();
}

void TestLayout::everythingCanBeReadAndReached_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("dark");
    for (const char* example : {"t38_medium_rock", "t51_soft_rock", "paper_fig4b", "reference_case"})
        for (const QSize size : {QSize(1000, 650), QSize(1440, 900), QSize(1920, 1080)})
            for (const bool dark : {false, true})
                QTest::addRow("%s, %d × %d, %s", example, size.width(), size.height(),
                              dark ? "dark" : "light")
                    << QString::fromLatin1(example) << size << dark;
}

void TestLayout::everythingCanBeReadAndReached() {
    QFETCH(QString, example);
    QFETCH(QSize, size);
    QFETCH(bool, dark);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
    MainWindow window(std::make_unique<ScriptedQuestions>(m_answers), exactSolve());
    openExample(window, example);
    window.resize(size);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    auto* pages = window.findChild<PageTabs*>();
    QStringList problems;
    // The numbers of the result panel are never cut: a small window grows by what they need.
    if (window.width() > std::max(size.width(), widestSmallWindow) || window.height() > size.height())
        problems.append(QStringLiteral("wants %1 × %2").arg(window.width()).arg(window.height()));
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        QTRY_VERIFY(!part<SolveJob>(window).isBusy());
        QCoreApplication::processEvents();
        const QStringList found =
            clippedTexts(window) + overlaps(window) + namelessControls(window) + faintTexts(window);
        for (const QString& each : found)
            problems.append(pages->page(page).title() + QStringLiteral(": ") + each);
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestLayout)
#include "tst_layout.moc"
