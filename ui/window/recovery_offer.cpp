// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery_offer.h"

#include <QDir>
#include <QLocale>

#include "ui/document/recovery.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString detailsOf(const UnsavedScenario& scenario) {
    const QString when = QLocale().toString(scenario.time, QLocale::ShortFormat);
    const QString text = tr("The program ended unexpectedly; the last change was at %1.").arg(when);
    if (scenario.origin.isEmpty()) return text;
    return text + QLatin1Char('\n') +
           tr("The changes were made to %1, which stays as it is until you save.")
               .arg(QDir::toNativeSeparators(scenario.origin));
}

QString restored(const UnsavedScenario& scenario, Document& document) {
    if (scenario.path.isEmpty() || scenario.saved.empty())
        return document.restore(scenario.text, scenario.origin, scenario.isUnsaved);
    return document.restore(scenario.text, scenario.path, scenario.saved);
}

void setAside(LostChanges& lost, const QString& problem, Questions& questions, QWidget* window) {
    const QString kept = QDir::toNativeSeparators(lost.setAside());
    questions.tell(window, Questions::Tone::failure,
                   tr("Unsaved changes of an earlier run cannot be restored."),
                   tr("%1\nThe file is kept as %2 and not offered again.").arg(problem, kept));
}

}  // namespace

void offerLostChanges(const QString& folder, Document& document, Recovery& recovery, Questions& questions,
                      QWidget* window, const std::function<void(const WorkBeside&)>& takeBeside) {
    for (LostChanges& lost : findLostChanges(folder)) {
        const UnsavedScenario& scenario = lost.scenario();
        if (!lost.problem().isEmpty()) {
            setAside(lost, lost.problem(), questions, window);
            continue;
        }
        const auto answer = scenario.isRestart
                                ? Questions::Recovery::restore
                                : questions.recover(window, scenario.name, detailsOf(scenario));
        if (answer == Questions::Recovery::discard) lost.discard();
        if (answer != Questions::Recovery::restore) continue;
        const QString problem = restored(scenario, document);
        if (!problem.isEmpty()) {
            setAside(lost, problem, questions, window);
            continue;
        }
        takeBeside(scenario.beside);
        if (!scenario.problems.isEmpty())
            questions.tell(window, Questions::Tone::failure, tr("Some pinned runs cannot be restored."),
                           scenario.problems.join(QLatin1Char('\n')));
        // Only when they are safe again.
        recovery.writeNow();
        if (QFile::exists(recovery.file()) || !document.isModified()) lost.discard();
        return;
    }
}

}  // namespace drillwave
