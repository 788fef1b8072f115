// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole window, to be looked at: screenshots FOLDER [PAGE]. Every page or that one, light and
// dark, in three sizes, at one and two pixels a point: blow_dark_1440x900_2x.png and so on.
#include <QApplication>
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "core/file/examples.h"
#include "tests/support/themes.h"
#include "tests/support/window_parts.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_activity.h"
#include "ui/pages/stiffness/stiffness_page.h"
#include "ui/text/settings.h"
#include "ui/window/main_window.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"

using namespace drillwave;

namespace {

const QSize sizes[] = {{1000, 650}, {1440, 900}, {3200, 1800}};

// Also what is shown late, such as a finer raster for the size on screen.
void settle(MainWindow& window) {
    const Page& page = part<PageTabs>(window).current();
    const auto isRunning = [](const StudyActivity* study) {
        return study && study->state() == StudyState::running;
    };
    const auto* stiffness = qobject_cast<const StiffnessPage*>(&page);
    do QTest::qWait(200);
    while (part<SolveJob>(window).isBusy() || isRunning(page.activity()) ||
           (stiffness && isRunning(&stiffness->runLines().activity())));
}

// Another rock, another rod, another blow.
void pinRuns(MainWindow& window) {
    Document& document = window.document();
    part<PinnedRuns>(window).pinAction()->trigger();
    for (const auto& [key, si] :
         {std::pair("bit_rock.gamma", 0.4), std::pair("rod.length", 2.4), std::pair("pulse.impulse", 70.0)}) {
        document.assign(*findParameter(key), si, document.newGesture());
        settle(window);
        if (key != std::string_view("pulse.impulse")) part<PinnedRuns>(window).pinAction()->trigger();
    }
}

bool isWanted(const QString& page) {
    const QString wanted = QCoreApplication::arguments().value(2);
    return wanted.isEmpty() || page.compare(wanted, Qt::CaseInsensitive) == 0;
}

/// `of` stands before the names of pages that are of a drill string.
bool drawPages(MainWindow& window, const QDir& folder, const QString& of, const char* theme, int scale) {
    auto* pages = window.findChild<PageTabs*>();
    for (int page = 0; page < pages->count(); ++page) {
        if (!pages->isOffered(page) || !isWanted(pages->page(page).title())) continue;
        pages->setCurrentIndex(page);
        for (const QSize size : sizes) {
            window.resize(size);
            settle(window);
            window.resize(size);  // a narrow window has moved its docks together
            settle(window);
            const QString name = QStringLiteral("%1%2_%3_%4x%5_%6x.png")
                                     .arg(of,
                                          pages->page(page)
                                              .title()
                                              .section(QStringLiteral(" ("), 0, 0)
                                              .toLower()
                                              .replace(u' ', u'_'),
                                          QLatin1String(theme))
                                     .arg(size.width())
                                     .arg(size.height())
                                     .arg(scale);
            if (!window.grab().save(folder.filePath(name))) {
                std::fprintf(stderr, "%s cannot be written\n", qPrintable(folder.filePath(name)));
                return false;
            }
        }
    }
    return true;
}

bool drawThemes(const QDir& folder, int scale) {
    for (const bool dark : {false, true}) {
        QApplication::setPalette(dark ? darkPalette() : lightPalette());
        MainWindow window;
        window.show();
        const char* theme = dark ? "dark" : "light";
        if (QCoreApplication::arguments().size() < 3) pinRuns(window);
        if (!drawPages(window, folder, {}, theme, scale)) return false;
        // Also of a drill string, in every look where one page is asked for.
        if (QCoreApplication::arguments().size() < 3 && (dark || scale > 1)) continue;
        window.document().startFrom(findExample("t38_string")->text, QStringLiteral("t38_string"));
        settle(window);
        if (!drawPages(window, folder, QStringLiteral("string_"), theme, scale)) return false;
    }
    return true;
}

}  // namespace

// The factor is read when the application begins, so the pictures of two pixels a point are a child's.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const bool isChild = qEnvironmentVariableIsSet("QT_SCALE_FACTOR");
    const QApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    if ((words.size() != 2 && words.size() != 3) || words.at(1).startsWith(QLatin1Char('-'))) {
        std::fprintf(stderr, "usage: screenshots FOLDER [PAGE]\n");
        return 2;
    }
    QLocale::setDefault(QLocale::c());
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QDir().mkpath(words.at(1));
    if (!drawThemes(QDir(words.at(1)), isChild ? 2 : 1)) return 1;
    if (isChild) return 0;
    qputenv("QT_SCALE_FACTOR", "2");
    return QProcess::execute(QCoreApplication::applicationFilePath(), words.mid(1));
}
