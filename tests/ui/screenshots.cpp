// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole window, to be looked at: screenshots FOLDER [PAGE]. Every page or that one, light and
// dark, in four sizes, at one and two pixels a point: blow_dark_1440x900_2x.png and so on. Options choose the
// units, the numbers of a locale, the language, the size of the type, and one of the sizes.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "core/yaml/examples.h"
#include "tests/support/themes.h"
#include "tests/support/window_parts.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_job.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/window/main_window.h"
#include "ui/window/manual_help.h"
#include "ui/window/page_tabs.h"
#include "ui/window/pinned_runs.h"
#include "ui/window/units_choice.h"

using namespace drillwave;

namespace {

/// Options of the pictures.
struct Wanted {
    QString page;  ///< empty: every page
    QList<QSize> sizes = {{800, 500}, {1000, 650}, {1440, 900}, {3200, 1800}};
    UnitSystem units = UnitSystem::si;
    bool bothScales = true;
};

// Also what is shown late, such as a finer raster for the size on screen.
void settle(MainWindow& window) {
    const Page& page = part<PageTabs>(window).current();
    const auto isRunning = [](const StudyActivity* study) {
        return study && study->state() == StudyState::running;
    };
    const auto* stiffness = qobject_cast<const CurvePage*>(&page);
    const auto* drilling = qobject_cast<const DrillingPage*>(&page);
    do QTest::qWait(200);
    while (part<SolveJob>(window).isBusy() || isRunning(page.activity()) ||
           (stiffness && isRunning(&stiffness->runLines().activity())) ||
           (drilling && isRunning(&drilling->scanActivity())));
}

// Another rock, another rod, another blow.
void pinRuns(MainWindow& window) {
    settle(window);  // what is not solved yet is not pinned once something changes
    Document& document = window.document();
    part<PinnedRuns>(window).pinAction()->trigger();
    for (const auto& [key, si] :
         {std::pair("bit_rock.gamma", 0.4), std::pair("rod.length", 2.4), std::pair("pulse.impulse", 70.0)}) {
        document.assign(*findParameter(key), si, document.newGesture());
        settle(window);
        if (key != std::string_view("pulse.impulse")) part<PinnedRuns>(window).pinAction()->trigger();
    }
}

// In whatever language the window speaks.
QString englishTitle(const Page& page) {
    const EnglishTexts english;
    return page.title();
}

bool isWanted(const QString& page, const Wanted& wanted) {
    return wanted.page.isEmpty() || page.compare(wanted.page, Qt::CaseInsensitive) == 0;
}

/// `of` stands before the names of pages that are of a drill string.
bool drawPages(MainWindow& window, const QDir& folder, const QString& of, const char* theme, int scale,
               const Wanted& wanted) {
    auto* pages = window.findChild<PageTabs*>();
    for (int page = 0; page < pages->count(); ++page) {
        if (!pages->isOffered(page) || !isWanted(englishTitle(pages->page(page)), wanted)) continue;
        pages->setCurrentIndex(page);
        if (auto* drilling = qobject_cast<DrillingPage*>(&pages->page(page))) {
            settle(window);
            drilling->scan();
        }
        for (const QSize size : wanted.sizes) {
            window.resize(size);
            settle(window);
            window.resize(size);  // a narrow window has moved its docks together
            settle(window);
            const QString name = QStringLiteral("%1%2_%3_%4x%5_%6x.png")
                                     .arg(of,
                                          englishTitle(pages->page(page))
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

/// The manual at a place of each kind: words, formulas, a table, an entry, what is found.
bool drawManual(MainWindow& window, const QDir& folder, const char* theme, int scale) {
    auto& manual = part<ManualHelp>(window);
    const std::pair<const char*, const char*> places[] = {
        {"tutorial", ""},   {"window", "Blow"}, {"theory", "§2"}, {"parameters", "bit_rock.gamma"},
        {"glossary", "§1"}, {"keys", ""}};
    for (const auto& [chapter, heading] : places) {
        manual.showAt({QString::fromUtf8(chapter), QString::fromUtf8(heading)});
        QTest::qWait(200);
        const QString name = QStringLiteral("manual_%1_%2_%3x.png")
                                 .arg(QLatin1String(chapter), QLatin1String(theme))
                                 .arg(scale);
        if (!manual.helpWindow()->grab().save(folder.filePath(name))) return false;
    }
    manual.helpWindow()->search().setText(QStringLiteral("super rebound"));
    QTest::keyClick(&manual.helpWindow()->search(), Qt::Key_Return);
    QTest::qWait(200);
    const QString name = QStringLiteral("manual_search_%1_%2x.png").arg(QLatin1String(theme)).arg(scale);
    return manual.helpWindow()->grab().save(folder.filePath(name));
}

bool drawThemes(const QDir& folder, int scale, const Wanted& wanted) {
    for (const bool dark : {false, true}) {
        QApplication::setPalette(dark ? darkPalette() : lightPalette());
        MainWindow window;
        window.show();
        part<UnitsChoice>(window).choose(wanted.units);
        const char* theme = dark ? "dark" : "light";
        if (isWanted(QStringLiteral("manual"), wanted) && !drawManual(window, folder, theme, scale))
            return false;
        if (wanted.page.isEmpty()) pinRuns(window);
        if (!drawPages(window, folder, {}, theme, scale, wanted)) return false;
        // Also of a drill string, in every look where one page is asked for.
        if (wanted.page.isEmpty() && (dark || scale > 1)) continue;
        window.document().startFrom(findExample("t38_string")->text, QStringLiteral("t38_string"));
        settle(window);
        if (!drawPages(window, folder, QStringLiteral("string_"), theme, scale, wanted)) return false;
    }
    return true;
}

// As in the window's own settings: a size is WIDTHxHEIGHT in points.
QSize sizeOf(const QString& text) {
    const QStringList sides = text.split(u'x');
    return sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
}

}  // namespace

// The factor is read when the application begins, so the pictures of two pixels a point are a child's.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const bool isChild = qEnvironmentVariableIsSet("QT_SCALE_FACTOR");
    QApplication application(argc, argv);
    QCommandLineParser words;
    const QCommandLineOption us("us", "US units in place of SI.");
    const QCommandLineOption locale(
        "locale", "Numbers as in LOCALE, such as de_DE (default: as in LANGUAGE).", "LOCALE");
    const QCommandLineOption type("type", "Type of POINTS points.", "POINTS");
    const QCommandLineOption only("size", "That size alone, at one pixel a point.", "WIDTHxHEIGHT");
    const QCommandLineOption language("language", "The window in LANGUAGE: de, sv or en.", "LANGUAGE", "en");
    words.addOptions({us, locale, language, type, only});
    words.addHelpOption();
    words.addPositionalArgument("FOLDER", "Where the pictures go.");
    words.addPositionalArgument("PAGE", "That page alone, by the words on its tab, or `manual`.", "[PAGE]");
    words.process(application);
    const QStringList named = words.positionalArguments();
    Wanted wanted;
    wanted.page = named.value(1);
    if (words.isSet(us)) wanted.units = UnitSystem::us;
    if (words.isSet(only)) {
        wanted.sizes = {sizeOf(words.value(only))};
        wanted.bothScales = false;
    }
    if (named.isEmpty() || named.size() > 2 || wanted.sizes.first().isEmpty()) words.showHelp(2);
    const Language* spoken = findLanguage(words.value(language).toStdString());
    if (!spoken) words.showHelp(2);
    const QString ofLanguage = words.value(language) == "en" ? QStringLiteral("C") : words.value(language);
    QLocale::setDefault(withoutGroups(QLocale(words.isSet(locale) ? words.value(locale) : ofLanguage)));
    speak(*spoken);
    if (words.isSet(type)) {
        QFont font = QApplication::font();
        font.setPointSize(words.value(type).toInt());
        QApplication::setFont(font);
    }
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QDir().mkpath(named.first());
    if (!drawThemes(QDir(named.first()), isChild ? 2 : 1, wanted)) return 1;
    if (isChild || !wanted.bothScales) return 0;
    qputenv("QT_SCALE_FACTOR", "2");
    return QProcess::execute(QCoreApplication::applicationFilePath(), QCoreApplication::arguments().mid(1));
}
