// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/importer.h"

#include <QFileInfo>
#include <QSettings>

#include "core/model/form_conversion.h"
#include "core/signal/signal_option.h"
#include "core/yaml/recorder_file.h"
#include "ui/import/import_preview.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr QLatin1String lastKey("import/lastSettings");

QString tablesFilter() {
    return Importer::tr("Tables of samples (*.csv *.txt *.tsv *.dat *.asc *.prn);;All files (*)");
}

}  // namespace

Importer::Importer(Document& document, MeasuredList& measured, Questions& questions, QWidget* window)
    : m_document(document), m_measured(measured), m_questions(questions), m_window(window) {}

Importer::~Importer() {
    delete m_dialog;
}

QString Importer::folder() const {
    return QFileInfo(m_document.suggestedPath()).absolutePath();
}

void Importer::start(ImportUse use) {
    if (use == ImportUse::rockRecord) {
        const QStringList paths = chooseRecords();
        if (!paths.isEmpty()) open(paths.first(), use, paths.mid(1));
        return;
    }
    const QString path =
        m_questions.fileToImport(m_window, tr("Import a measured signal"), folder(), tablesFilter());
    if (!path.isEmpty()) open(path, use);
}

QStringList Importer::chooseRecords() {
    return m_questions.filesToImport(m_window, tr("Open records of strain gauges"), folder(), tablesFilter());
}

void Importer::open(const QString& path, ImportUse use, const QStringList& further) {
    m_further = further;
    delete m_dialog;
    m_dialog = new ImportDialog(path, use, m_document, m_window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &ImportDialog::wanted, this, &Importer::take);
    connect(m_dialog, &ImportDialog::helpRequested, this, [this] {
        m_questions.tell(m_dialog, Questions::Tone::information, tr("Import of a measured signal"),
                         importHelp());
    });
    connect(m_dialog, &ImportDialog::keepWanted, this, &Importer::keepRecorder);
    offerRecorders();
    m_dialog->show();
}

// Problems of the file are reported where a recorder is kept.
void Importer::offerRecorders() {
    Recorder last;
    const QStringList lines = Settings().value(lastKey).toStringList();
    for (const QString& line : lines)
        last.settings.emplace_back(line.section(u'=', 0, 0).toStdString(),
                                   line.section(u'=', 1).toStdString());
    m_dialog->offer(loadRecorders(recordersPath()).recorders, std::move(last));
}

void Importer::keepRecorder() {
    RecorderFile file = loadRecorders(recordersPath());
    Message problem = file.problems.empty() ? Message() : file.problems.front();
    if (problem.isEmpty())
        problem = saveRecorders(recordersPath(), withRecorder(std::move(file.recorders),
                                                              {m_dialog->recorder().toStdString(),
                                                               recorderSettings(m_dialog->settings())}));
    if (!problem.isEmpty()) return m_dialog->refuse(translated(problem));
    offerRecorders();
    emit imported(tr("The settings are kept for recorder %1.").arg(m_dialog->recorder()));
}

void Importer::take() {
    const QString file = QFileInfo(m_dialog->path()).fileName();
    const ImportUse use = m_dialog->use();
    const QString problem = use == ImportUse::blow         ? takeBlow()
                            : use == ImportUse::rockRecord ? QString()
                                                           : takeMeasured();
    if (!problem.isEmpty()) return m_dialog->refuse(problem);
    QStringList lines;
    for (const auto& [name, value] : recorderSettings(m_dialog->settings()))
        lines << QString::fromStdString(name + "=" + value);
    Settings().setValue(lastKey, lines);
    const QString path = m_dialog->path();
    const SignalOptions settings = m_dialog->settings();
    m_dialog->close();
    if (use == ImportUse::rockRecord) return emit recordsTaken(QStringList(path) + m_further, settings);
    emit imported(use == ImportUse::blow ? tr("The hammer blow is taken from %1.").arg(file)
                                         : tr("%1 is shown on the page Blow.").arg(file));
}

QString Importer::takeBlow() {
    Scenario changed = withForce(m_document.scenario());  // a blow takes the place of a hammer of sections
    changed.pulse.shape = PulseShape::table;
    changed.pulse.tableFile.clear();
    changed.pulse.tablePoints = m_dialog->result()->points;
    return m_document.useScenario(
        changed, tr("take the hammer blow from %1").arg(QFileInfo(m_dialog->path()).fileName()));
}

QString Importer::takeMeasured() {
    if (m_measured.isFull())
        return tr("%1 measured curves are there already: remove one on the page Blow.")
            .arg(MeasuredList::most);
    m_measured.add(m_dialog->measured());
    return {};
}

}  // namespace drillwave
