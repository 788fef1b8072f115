#include "ui/questions.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QMessageBox>
#include <cstdio>

namespace drillwave {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave::Questions", text);
}

bool someoneIsThere() {
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

QString scenarioFilter() {
    return tr("Scenarios (*.yaml *.yml);;All files (*)");
}

}  // namespace

Questions::Unsaved DialogQuestions::unsavedChanges(QWidget* parent, const QString& name) {
    if (!someoneIsThere()) return Unsaved::discard;
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), tr("Save the changes to “%1”?").arg(name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(tr("They are lost otherwise."));
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

QString DialogQuestions::fileToOpen(QWidget* parent, const QString& folder) {
    if (!someoneIsThere()) return {};
    return QFileDialog::getOpenFileName(parent, tr("Open a scenario"), folder, scenarioFilter());
}

QString DialogQuestions::fileToSave(QWidget* parent, const QString& suggestion) {
    if (!someoneIsThere()) return {};
    QFileDialog dialog(parent, tr("Save the scenario"), suggestion, scenarioFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("yaml"));
    dialog.selectFile(suggestion);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

void DialogQuestions::tell(QWidget* parent, Tone tone, const QString& what, const QString& details) {
    if (!someoneIsThere()) {
        std::fprintf(stderr, "%s: %s\n", qPrintable(what), qPrintable(details));
        return;
    }
    auto* box = new QMessageBox(tone == Tone::failure ? QMessageBox::Warning : QMessageBox::Information,
                                tr("Drillwave"), what, QMessageBox::Ok, parent);
    box->setInformativeText(details);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    // Lines that begin with a path need width.
    auto* layout = static_cast<QGridLayout*>(box->layout());
    layout->addItem(new QSpacerItem(520, 0), layout->rowCount(), 0, 1, layout->columnCount());
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace drillwave
