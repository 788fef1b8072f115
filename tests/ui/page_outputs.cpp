// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what the pages of the window give, for tests/house/compare_outputs.sh:
//   page_outputs [--language CODE] [--without-studies] FOLDER EXAMPLE
// Each page gets files named by its place in the row of tabs: 03_1.csv and 03_2.svg are its exports,
// 03_command.txt is the command line that it copies, 03_copy.txt its copied table, 03_copy.png its copied
// picture and 03.lines.txt every text on it. menus.lines.txt and window.lines.txt hold the menus and the
// panels around the pages. An export that is not available leaves its reason in a text file. Exit code 1 if a
// study does not end or a file cannot be written. Only what older versions have as well is used here, because
// the same source is compiled for both sides.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QCommandLineParser>
#include <QDir>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "core/yaml/examples.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_job.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/window/main_window.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

constexpr int patience = 300000;  // for the longest study on a busy machine [ms]

bool isWritten = true;

void write(const QDir& folder, const QString& name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size()) return;
    std::fprintf(stderr, "%s cannot be written\n", qPrintable(file.fileName()));
    isWritten = false;
}

QString obstacleOf(const PageExport& wanted) {
    return wanted.obstacle ? wanted.obstacle() : QString();
}

/// Whether neither the blow nor the study of the page is being solved.
bool isIdle(const MainWindow& window, const Page& page) {
    const StudyActivity* study = page.activity();
    return !window.findChild<SolveJob*>()->isBusy() && !(study && study->state() == StudyState::running);
}

/// Waits until the page shows its answer: a page that is drawn may ask for more, such as a finer picture.
bool settle(MainWindow& window, const Page& page) {
    for (int drawn = 0; drawn < 3; ++drawn) {
        if (!QTest::qWaitFor([&] { return isIdle(window, page); }, patience)) return false;
        window.grab();
        QCoreApplication::processEvents();
        if (!isIdle(window, page)) drawn = -1;
    }
    return true;
}

/// Waits until everything can be exported.
bool waitForExports(const Page& page) {
    return QTest::qWaitFor(
        [&] {
            for (const PageExport& each : page.exports())
                if (!obstacleOf(each).isEmpty()) return false;
            return true;
        },
        patience);
}

QAbstractButton* button(const QWidget& page, const char* name) {
    return page.findChild<QAbstractButton*>(QLatin1String(name));
}

/// Whether rows of tables are among the texts: those of the study of accuracy contain times.
enum class Tables { written, skipped };

/// Each text in a line of its own, with a word that says what has it.
class Lines {
  public:
    explicit Lines(Tables tables = Tables::written) : m_tables(tables) {}

    void add(const char* what, QString text) {
        text.replace(QLatin1Char('\n'), QStringLiteral(" / "));
        if (!text.trimmed().isEmpty()) m_lines << QLatin1String(what) + QStringLiteral(": ") + text;
    }
    void addWidget(const QWidget& widget);
    void addAll(const QWidget& parent) {
        addWidget(parent);
        for (const QWidget* each : parent.findChildren<QWidget*>()) addWidget(*each);
    }
    void addAction(const QAction& action) {
        add("action", action.text());
        add("keys", action.shortcut().toString(QKeySequence::PortableText));
        if (action.toolTip() != action.iconText()) add("tip", action.toolTip());
        add("status", action.statusTip());
    }
    void addTable(const QAbstractItemView& view);
    QByteArray all() const { return m_lines.join(QLatin1Char('\n')).toUtf8() + '\n'; }

  private:
    Tables m_tables;
    QStringList m_lines;
};

void Lines::addTable(const QAbstractItemView& view) {
    const QAbstractItemModel* model = view.model();
    if (!model || view.inherits("QComboBoxListView")) return;
    constexpr int mostRows = 200;
    for (int column = 0; column < model->columnCount(); ++column)
        add("column", model->headerData(column, Qt::Horizontal).toString());
    if (m_tables == Tables::skipped) return;
    for (int row = 0; row < std::min(model->rowCount(), mostRows); ++row) {
        QStringList cells{model->headerData(row, Qt::Vertical).toString()};
        for (int column = 0; column < model->columnCount(); ++column) {
            const QModelIndex index = model->index(row, column);
            cells << index.data().toString();
            const QString tip = index.data(Qt::ToolTipRole).toString();
            if (tip != cells.last()) add("tip", tip);
        }
        add("row", cells.join(QStringLiteral(" | ")));
    }
}

void Lines::addWidget(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) add("label", label->text());
    if (const auto* push = qobject_cast<const QAbstractButton*>(&widget)) add("button", push->text());
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) add("group", group->title());
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) {
        add("field", field->text());
        add("placeholder", field->placeholderText());
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        for (int item = 0; item < box->count(); ++item) add("item", box->itemText(item));
        add("chosen", box->currentText());
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
        for (int tab = 0; tab < tabs->count(); ++tab) {
            add("tab", tabs->tabText(tab));
            add("tip", tabs->tabToolTip(tab));
        }
    }
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) addTable(*view);
    add("tip", widget.toolTip());
    add("status", widget.statusTip());
    add("name", widget.accessibleName());
    add("description", widget.accessibleDescription());
}

/// Exports of the page as files named by the place of the page.
void writeExports(const QDir& folder, const Page& page, const QString& stem) {
    int number = 0;
    for (const PageExport& each : page.exports()) {
        const QString name = stem + QStringLiteral("_%1").arg(++number);
        if (const QString why = obstacleOf(each); !why.isEmpty()) {
            write(folder, name + QStringLiteral(".txt"), why.toUtf8() + '\n');
        } else if (each.picture) {
            PictureChoice choice;
            choice.dpi = standardDpi;
            for (const QString& format : plotFormats()) {
                choice.format = format;
                write(folder, name + QLatin1Char('.') + format,
                      each.picture->file(choice, QStringLiteral("title")));
            }
        } else {
            const EnglishTexts english;
            write(folder, name + QStringLiteral(".csv"), each.csv());
        }
    }
}

/// Texts that the buttons of the page and the menu copy.
void writeCopied(const QDir& folder, const Page& page, const QString& stem) {
    QClipboard* clipboard = QGuiApplication::clipboard();
    for (const auto& [name, ending] : {std::pair("copyCommand", "_command.txt"), {"copy", "_copy.txt"}}) {
        QAbstractButton* copy = button(page, name);
        if (!copy) continue;
        clipboard->clear();
        copy->click();
        write(folder, stem + QLatin1String(ending), clipboard->text().toUtf8());
    }
    for (const PageExport& each : page.exports()) {
        if (!each.picture || !obstacleOf(each).isEmpty()) continue;
        clipboard->clear();
        each.picture->copy();
        clipboard->image().save(folder.filePath(stem + QStringLiteral("_copy.png")));
        write(folder, stem + QStringLiteral("_copy.svg"),
              clipboard->mimeData()->data(QStringLiteral("image/svg+xml")));
    }
}

void writeTexts(const QDir& folder, const Page& page, const QString& stem, Tables tables) {
    Lines lines(tables);
    lines.add("title", page.title());
    lines.add("elsewhere", page.elsewhere());
    for (const PageExport& each : page.exports()) {
        lines.add("export", each.title);
        lines.add("tip", each.toolTip);
        lines.add("stem", each.fileStem);
    }
    lines.addAll(page);
    write(folder, stem + QStringLiteral(".lines.txt"), lines.all());
}

void writeAround(const QDir& folder, const MainWindow& window) {
    Lines menus;
    for (const QMenu* menu : window.findChildren<QMenu*>()) {
        menus.add("menu", menu->title());
        for (const QAction* action : menu->actions()) menus.addAction(*action);
    }
    write(folder, QStringLiteral("menus.lines.txt"), menus.all());
    Lines lines;
    const auto* pages = window.findChild<PageTabs*>();
    for (const QWidget* each : window.findChildren<QWidget*>()) {
        const bool isMenu = qobject_cast<const QMenu*>(each);
        const bool isStatus = each->parentWidget() && each->parentWidget()->inherits("QStatusBar");
        if (!isMenu && !isStatus && !pages->isAncestorOf(each)) lines.addWidget(*each);
    }
    write(folder, QStringLiteral("window.lines.txt"), lines.all());
}

/// One page; its studies that only a button starts are run as well, but not that of stability, which takes
/// long and is the same for every scenario.
bool writePage(MainWindow& window, Page& page, const QDir& folder, QString stem, bool withStudies) {
    if (auto* samples = page.findChild<QComboBox*>(QStringLiteral("samples"))) samples->setCurrentIndex(0);
    if (!settle(window, page)) return false;
    QAbstractButton* proof = button(page, "run");
    QAbstractButton* study = proof ? proof : button(page, "scan");
    if (study && withStudies) {
        study->click();
        if (!waitForExports(page) || !settle(window, page)) return false;
        if (proof)
            stem += QStringLiteral("_accuracy");  // the comparison expects times in a file of that name
    }
    writeTexts(folder, page, stem, proof ? Tables::skipped : Tables::written);
    writeExports(folder, page, stem);
    writeCopied(folder, page, stem);
    return true;
}

bool writePages(MainWindow& window, const QDir& folder, bool withStudies) {
    auto& pages = *window.findChild<PageTabs*>();
    QString tabs;
    for (int page = 0; page < pages.count(); ++page)
        tabs += pages.page(page).title() +
                (pages.isOffered(page) ? QStringLiteral("\n") : QStringLiteral(" (not offered)\n"));
    write(folder, QStringLiteral("tabs.txt"), tabs.toUtf8());
    for (int index = 0; index < pages.count(); ++index) {
        if (!pages.isOffered(index)) continue;
        pages.setCurrentIndex(index);
        Page& page = pages.page(index);
        if (!writePage(window, page, folder, QStringLiteral("%1").arg(index, 2, 10, QLatin1Char('0')),
                       withStudies)) {
            std::fprintf(stderr, "page %d, %s: its study does not end\n", index, qPrintable(page.title()));
            return false;
        }
    }
    writeAround(folder, window);
    return true;
}

/// Pins the run on show; the pages of tables compare it with the present one.
bool writeComparison(MainWindow& window, const QDir& folder) {
    const QList<QAction*> actions = window.findChildren<QAction*>();
    const auto pin = std::ranges::find(actions, QKeySequence(Qt::Key_F7), &QAction::shortcut);
    if (pin == actions.end()) return false;
    (*pin)->trigger();
    auto& pages = *window.findChild<PageTabs*>();
    for (int index = 0; index < pages.count(); ++index) {
        Page& page = pages.page(index);
        if (!pages.isOffered(index) || !button(page, "copy")) continue;
        pages.setCurrentIndex(index);
        const QString stem = QStringLiteral("%1_pinned").arg(index, 2, 10, QLatin1Char('0'));
        if (!waitForExports(page) || !writePage(window, page, folder, stem, true)) return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QCommandLineParser words;
    const QCommandLineOption language("language", "The window in LANGUAGE: de, sv or en.", "LANGUAGE", "en");
    const QCommandLineOption without("without-studies", "Leave out what only a button starts.");
    words.addOptions({language, without});
    words.addHelpOption();
    words.addPositionalArgument("FOLDER", "Where the files go.");
    words.addPositionalArgument("EXAMPLE", "The scenario of the window.");
    words.process(application);
    const QStringList named = words.positionalArguments();
    const Language* spoken = findLanguage(words.value(language).toStdString());
    const Example* example = findExample(named.value(1).toStdString());
    if (named.size() != 2 || !spoken || !example) words.showHelp(2);
    QLocale::setDefault(
        withoutGroups(spoken == findLanguage("en") ? QLocale::c() : QLocale(words.value(language))));
    speak(*spoken);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    const QDir folder(named.first());
    if (!folder.mkpath(QStringLiteral("."))) return 1;
    MainWindow window;
    window.resize(1440, 900);
    window.show();
    window.openExample(*example);
    const bool isWhole = !words.isSet(without);
    if (!writePages(window, folder, isWhole)) return 1;
    if (isWhole && !writeComparison(window, folder)) return 1;
    return isWritten ? 0 : 1;
}
