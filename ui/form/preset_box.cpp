// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/preset_box.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "ui/form/rig_dialog.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString htmlText(const QString& description) {
    return QStringLiteral("<p>%1</p>")
        .arg(QString(description).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}

// An ampersand in a name is no mnemonic.
QString menuText(QString name) {
    return name.replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace

PresetBox::PresetBox(PresetKind kind, const QString& part, Document& document, PresetLibrary& library,
                     Questions& questions, QWidget* parent)
    : ChoiceBox(parent),
      m_kind(kind),
      m_document(document),
      m_library(library),
      m_questions(questions),
      m_menu(new QMenu(this)) {
    setObjectName(QStringLiteral("preset.%1").arg(static_cast<int>(kind)));
    setAccessibleName(tr("%1: preset").arg(part));
    m_menu->setToolTipsVisible(true);
    addItem(tr("custom"));
}

void PresetBox::present(const Scenario& scenario) {
    const bool physical = hasUnits(scenario);
    const Preset* preset = m_library.matching(m_kind, scenario);
    QString help = tr("The values belong to no preset. Select one to start from its values.");
    if (!physical)
        help = tr("Presets have physical units, and this scenario has only dimensionless groups.") +
               QLatin1Char(' ') + waysToPhysicalUnits();
    else if (preset)
        help = describe(*preset);
    setItemText(0, preset ? coreText(preset->name) : physical ? tr("custom") : tr("none"));
    setEnabled(physical);
    setToolTip(preset ? htmlText(help) : help);
    setAccessibleDescription(help);
}

QString PresetBox::describe(const Preset& preset) const {
    return QString::fromStdString(description(preset, LocalStyle::of(m_document.units())));
}

QMenu* PresetBox::menu() {
    m_library.reload();
    emit libraryChanged();
    fillMenu();
    return m_menu;
}

void PresetBox::showPopup() {
    menu()->setMinimumWidth(width());
    m_menu->popup(mapToGlobal(QPoint(0, height())));
}

void PresetBox::fillMenu() {
    m_menu->clear();
    for (const PresetSource& source : m_library.sources()) {
        if (!source.problem.isEmpty())
            addProblem(source);
        else
            addPresets(m_menu, source);
    }
    m_menu->addSeparator();
    m_menu->addAction(tr("&Add file of presets…"), this, &PresetBox::addFile)
        ->setToolTip(tr("Adds the presets of your own YAML file, also for later sessions"));
    QAction* open = m_menu->addAction(tr("&Open folder of presets"), this, [] {
        QDir().mkpath(PresetLibrary::folder());
        QDesktopServices::openUrl(QUrl::fromLocalFile(PresetLibrary::folder()));
    });
    open->setToolTip(tr("A file presets.yaml in %1 is read automatically")
                         .arg(QDir::toNativeSeparators(PresetLibrary::folder()))
                         .toHtmlEscaped());
}

void PresetBox::addPresets(QMenu* menu, const PresetSource& source) {
    if (!source.path.isEmpty()) menu->addSection(menuText(QFileInfo(source.path).fileName()));
    for (const Preset& preset : source.presets) {
        if (preset.kind != m_kind) continue;
        QAction* action =
            menu->addAction(menuText(coreText(preset.name)), this, [this, preset] { take(preset); });
        action->setCheckable(true);
        action->setChecked(matches(preset, m_document.scenario()));
        action->setToolTip(htmlText(describe(preset)));
    }
    if (!source.path.isEmpty() && m_library.wasAdded(source.path))
        menu->addAction(tr("Remove these from the list"), this, [this, path = source.path] {
            m_library.remove(path);
            emit libraryChanged();
        });
}

void PresetBox::addProblem(const PresetSource& source) {
    QAction* action = m_menu->addAction(
        tr("⚠ %1 is not used: why?").arg(menuText(QFileInfo(source.path).fileName())), this,
        [this, path = source.path, problem = source.problem] { explainProblem(path, problem); });
    action->setToolTip(QStringLiteral("<p>%1</p>").arg(source.problem.toHtmlEscaped()));
}

void PresetBox::explainProblem(const QString& path, const QString& problem) {
    const QString what = tr("The presets of %1 are not used.").arg(QFileInfo(path).fileName());
    if (!m_library.wasAdded(path)) return m_questions.tell(window(), Questions::Tone::failure, what, problem);
    if (!m_questions.confirm(window(), what, problem, tr("Remove from the list"))) return;
    m_library.remove(path);
    emit libraryChanged();
}

void PresetBox::addFile() {
    const QString path =
        m_questions.fileToImport(window(), tr("Add a file of presets"), PresetLibrary::folder(),
                                 tr("Presets (*.yaml *.yml);;All files (*)"));
    if (path.isEmpty()) return;
    const QString problem = m_library.add(path);
    if (!problem.isEmpty())
        m_questions.tell(window(), Questions::Tone::failure, tr("These presets cannot be used."), problem);
    emit libraryChanged();
}

void PresetBox::take(const Preset& preset) {
    const QString problem = m_document.applyPreset(preset);
    if (!problem.isEmpty())
        m_questions.tell(window(), Questions::Tone::failure,
                         tr("This preset does not fit the rest of the scenario."), problem);
    // The same values again leave the document as it is, the box too.
    present(m_document.scenario());
}

}  // namespace drillwave
