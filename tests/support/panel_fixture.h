// SPDX-License-Identifier: GPL-3.0-or-later
// Fixture with only the scenario form, its document, answers to its questions, and temporary folders.
#pragma once

#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/scripted_questions.h"
#include "ui/form/scenario_panel.h"

namespace drillwave {

/// Temporary folder for settings and the user's presets.
struct PanelFolder {
    QTemporaryDir folder;

    PanelFolder() {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_CONFIG_HOME", QFile::encodeName(folder.filePath(QStringLiteral("config"))));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           folder.filePath(QStringLiteral("settings")));
    }
};

/// Fixture with a scenario form and its document, which reads its settings from the folder of the base class.
struct PanelFixture : PanelFolder {
    ScriptedAnswers answers;
    ScriptedQuestions questions{answers};
    int checks = 0;  // number of times that the document has checked a scenario
    Document document{nullptr, [this](const Scenario& scenario) {
                          ++checks;
                          return validate(scenario);
                      }};
    std::unique_ptr<ScenarioPanel> panel;

    PanelFixture() {
        document.startFrom(defaultExample().text, QStringLiteral("example"));
        makePanel();
    }

    /// Makes the form again, as the next start of the program does.
    void makePanel() {
        panel = std::make_unique<ScenarioPanel>(document, questions);
        panel->resize(420, 900);
        panel->show();
    }

    QString write(const QString& name, const QByteArray& bytes) const {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(bytes);
        return file.fileName();
    }

    template <typename Widget>
    Widget& find(const char* name) const {
        auto* widget = panel->findChild<Widget*>(QLatin1String(name));
        if (!widget) qFatal("the panel has no %s", name);
        return *widget;
    }

    /// Chooses an entry of a combo box as a user would; returns false if there is none with that text.
    static bool choose(QComboBox& box, const QString& text) {
        const int index = box.findText(text);
        if (index < 0) return false;
        box.setCurrentIndex(index);
        emit box.activated(index);
        return true;
    }

    void undoAll() {
        while (document.undoStack().canUndo()) document.undoStack().undo();
    }
};

}  // namespace drillwave
