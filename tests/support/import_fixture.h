// SPDX-License-Identifier: GPL-3.0-or-later
// Fixture with a window for importing measured signals, sample files, and access to the controls of the
// dialog.
#pragma once

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/support/window.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/import/import_dialog.h"
#include "ui/text/settings.h"

namespace drillwave::test {

/// Returns a record of two strain gauges with zero lines at 12 and −3 µε and noise of ±2 µε. The first has a
/// half sine of 100 µs and −1000 µε, the second half of it later. The file has semicolons, decimal commas and
/// times in ms.
inline QByteArray gaugeRecord() {
    QString text = QStringLiteral("Recorder 7\nZeit;DMS 1;DMS 2\nms;µm/m;µm/m\n");
    const auto pulse = [](double t) { return t > 0 && t < 100 ? -1000 * std::sin(M_PI * t / 100) : 0; };
    for (int i = 0; i <= 4000; ++i) {
        const double t = 0.1 * i;
        const double noise = 2 * std::sin(1000.0 * i);
        const QString row = QStringLiteral("%1;%2;%3\n")
                                .arg(t / 1000, 0, 'f', 4)
                                .arg(pulse(t - 50) + 12 + noise, 0, 'f', 2)
                                .arg(pulse(t - 250) / 2 - 3 - noise, 0, 'f', 2);
        text += QString(row).replace(QLatin1Char('.'), QLatin1Char(','));
    }
    return text.toUtf8();
}

template <class Control>
Control& control(const QWidget& dialog, const char* name) {
    auto* found = dialog.findChild<Control*>(QLatin1String(name));
    if (!found) qFatal("the dialog has no %s", name);
    return *found;
}

inline void choose(const QWidget& dialog, const char* name, const QString& text) {
    auto& box = control<ChoiceBox>(dialog, name);
    const int index = box.findText(text, Qt::MatchContains);
    if (index < 0) qFatal("%s has no such entry", name);
    box.setCurrentIndex(index);
}

inline void type(const QWidget& dialog, const char* name, const QString& text) {
    auto& field = control<QuantityField>(dialog, name);
    auto* edit = field.findChild<QLineEdit*>();
    edit->selectAll();
    QTest::keyClicks(edit, text);
}

/// Fixture whose settings and files are in a temporary folder.
class ImportFixture {
  protected:
    ImportFixture() { keepSettingsIn(m_folder.path()); }

    /// Makes a new window, as at the first start of the program.
    void start();
    QString write(const QString& name, const QByteArray& bytes);
    ImportDialog& open(const QString& path, ImportUse use);
    static bool settle(ImportDialog& dialog);
    QString message(const ImportDialog& dialog) const { return control<QLabel>(dialog, "message").text(); }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

inline void ImportFixture::start() {
    QLocale::setDefault(QLocale::c());
    Settings().clear();
    m_answers = {};
    m_window = newWindow(m_answers);
    m_window->show();
}

inline QString ImportFixture::write(const QString& name, const QByteArray& bytes) {
    QFile file(m_folder.filePath(name));
    if (file.open(QIODevice::WriteOnly)) file.write(bytes);
    return file.fileName();
}

// Opens the dialog as the menu does, or as the button in the section of the hammer force does.
inline ImportDialog& ImportFixture::open(const QString& path, ImportUse use) {
    m_answers.import = path;
    if (use == ImportUse::blow) {
        m_window->findChild<QPushButton*>(QStringLiteral("importBlow"))->click();
    } else {
        // Stops at the first match, because opening a dialog deletes the actions of an earlier one.
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->text() == QStringLiteral("&Import…")) {
                action->trigger();
                break;
            }
    }
    auto* dialog = m_window->findChild<ImportDialog*>();
    if (!dialog) qFatal("no dialog");
    if (dialog->use() != use) {
        auto& box = control<ChoiceBox>(*dialog, "use");
        box.setCurrentIndex(box.findData(static_cast<int>(use)));
    }
    return *dialog;
}

inline bool ImportFixture::settle(ImportDialog& dialog) {
    // One result may propose values that start the next computation.
    return QTest::qWaitFor(
        [&dialog] {
            if (dialog.isBusy()) return false;
            QCoreApplication::processEvents();
            return !dialog.isBusy();
        },
        60000);
}

}  // namespace drillwave::test
