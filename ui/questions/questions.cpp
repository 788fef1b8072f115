// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/questions.h"

#include <QCollator>
#include <QFileDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <algorithm>
#include <cstdio>

#include "ui/questions/export_dialog.h"
#include "ui/questions/picture_dialog.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

bool someoneIsThere() {
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

void printOut(const QString& what, const QString& details) {
    std::fprintf(stderr, "%s: %s\n", qPrintable(what), qPrintable(details));
}

QString scenarioFilter() {
    return drillwave::tr("Scenarios (*.yaml *.yml);;All files (*)");
}

QString openFilter() {
    return drillwave::tr("Scenarios and results (*.yaml *.yml *.csv *.json *.html);;All files (*)");
}

}  // namespace

Questions::Unsaved DialogQuestions::unsavedChanges(QWidget* parent, const QString& name) {
    if (!someoneIsThere()) return Unsaved::discard;
    QMessageBox box(QMessageBox::Warning, drillwave::tr("Unsaved changes"),
                    withoutMarkup(drillwave::tr("Save the changes to “%1”?").arg(name)),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(drillwave::tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save:
            return Unsaved::save;
        case QMessageBox::Discard:
            return Unsaved::discard;
        default:
            return Unsaved::cancel;
    }
}

bool DialogQuestions::confirmClose(QWidget* parent, const QString& what, const QString& details) {
    if (!someoneIsThere()) {
        printOut(what, details);
        return true;
    }
    QMessageBox box(QMessageBox::Warning, drillwave::tr("Drillwave"), withoutMarkup(what),
                    QMessageBox::Cancel, parent);
    box.setInformativeText(withoutMarkup(details));
    const QAbstractButton* closes =
        box.addButton(drillwave::tr("Close all the same"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == closes;
}

QString DialogQuestions::fileToOpen(QWidget* parent, const QString& folder) {
    if (!someoneIsThere()) return {};
    return QFileDialog::getOpenFileName(parent, drillwave::tr("Open a scenario"), folder, openFilter());
}

QString DialogQuestions::fileToImport(QWidget* parent, const QString& title, const QString& folder,
                                      const QString& filter) {
    if (!someoneIsThere()) return {};
    return QFileDialog::getOpenFileName(parent, title, folder, filter);
}

QStringList DialogQuestions::filesToImport(QWidget* parent, const QString& title, const QString& folder,
                                           const QString& filter) {
    if (!someoneIsThere()) return {};
    QStringList files = QFileDialog::getOpenFileNames(parent, title, folder, filter);
    QCollator order;
    order.setNumericMode(true);
    std::ranges::sort(files, order);
    return files;
}

QString DialogQuestions::fileToSave(QWidget* parent, const QString& suggestion) {
    if (!someoneIsThere()) return {};
    QFileDialog dialog(parent, drillwave::tr("Save the scenario"), suggestion, scenarioFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("yaml"));
    dialog.selectFile(suggestion);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString DialogQuestions::fileToExport(QWidget* parent, const QString& title, const QString& suggestion,
                                      const QString& filter) {
    if (!someoneIsThere()) return {};
    ExportDialog dialog(parent, title, suggestion, filter);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

std::unique_ptr<QPrinter> DialogQuestions::printer(QWidget* parent, const QString& title) {
    if (!someoneIsThere()) return nullptr;
    auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(title);
    QPrintDialog dialog(printer.get(), parent);
    dialog.setWindowTitle(title);
    dialog.setOption(QAbstractPrintDialog::PrintPageRange, false);  // nobody knows the pages yet
    return dialog.exec() == QDialog::Accepted ? std::move(printer) : nullptr;
}

QString DialogQuestions::folderToExport(QWidget* parent, const QString& suggestion) {
    if (!someoneIsThere()) return {};
    FolderDialog dialog(parent, drillwave::tr("Export everything into a folder"), suggestion);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

std::optional<PictureChoice> DialogQuestions::picture(QWidget* parent, const PictureChoice& before) {
    if (!someoneIsThere()) return std::nullopt;
    PictureDialog dialog(before, parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.choice();
}

bool DialogQuestions::confirm(QWidget* parent, const QString& question, const QString& details,
                              const QString& action) {
    if (!someoneIsThere()) return false;
    QMessageBox box(QMessageBox::Warning, drillwave::tr("Drillwave"), withoutMarkup(question),
                    QMessageBox::Cancel, parent);
    box.setInformativeText(withoutMarkup(details));
    const QAbstractButton* does = box.addButton(action, QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == does;
}

Questions::Recovery DialogQuestions::recover(QWidget* parent, const QString& name, const QString& details) {
    if (!someoneIsThere()) return Recovery::later;
    QMessageBox box(QMessageBox::Question, drillwave::tr("Unsaved changes found"),
                    withoutMarkup(drillwave::tr("Restore the unsaved changes to “%1”?").arg(name)),
                    QMessageBox::NoButton, parent);
    box.setInformativeText(withoutMarkup(details));
    QPushButton* restore = box.addButton(drillwave::tr("&Restore"), QMessageBox::AcceptRole);
    const QAbstractButton* discard = box.addButton(drillwave::tr("&Discard"), QMessageBox::DestructiveRole);
    box.setEscapeButton(box.addButton(drillwave::tr("&Later"), QMessageBox::RejectRole));
    box.setDefaultButton(restore);
    box.exec();
    if (box.clickedButton() == discard) return Recovery::discard;
    return box.clickedButton() == restore ? Recovery::restore : Recovery::later;
}

bool DialogQuestions::restartNow(QWidget* parent, const QString& question, const QString& details) {
    if (!someoneIsThere()) return false;
    QMessageBox box(QMessageBox::Question, drillwave::tr("Drillwave"), withoutMarkup(question),
                    QMessageBox::NoButton, parent);
    box.setInformativeText(withoutMarkup(details));
    QPushButton* now = box.addButton(drillwave::tr("Restart &now"), QMessageBox::AcceptRole);
    box.setEscapeButton(box.addButton(drillwave::tr("&Later"), QMessageBox::RejectRole));
    box.setDefaultButton(now);
    box.exec();
    return box.clickedButton() == now;
}

void DialogQuestions::tell(QWidget* parent, Tone tone, const QString& what, const QString& details) {
    if (!someoneIsThere()) return printOut(what, details);
    auto* box = new QMessageBox(tone == Tone::failure ? QMessageBox::Warning : QMessageBox::Information,
                                drillwave::tr("Drillwave"), withoutMarkup(what), QMessageBox::Ok, parent);
    box->setInformativeText(withoutMarkup(details));
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    // Lines that begin with a path need width.
    auto* layout = static_cast<QGridLayout*>(box->layout());
    layout->addItem(new QSpacerItem(520, 0), layout->rowCount(), 0, 1, layout->columnCount());
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace drillwave
